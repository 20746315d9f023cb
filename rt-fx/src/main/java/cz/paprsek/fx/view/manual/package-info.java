/** The manual: pages that come with the program, read in a window of their own, without a network. */
package cz.paprsek.fx.view.manual;
