/** The timeline below the views: times, keys, playing. */
package cz.paprsek.fx.view.motion;
