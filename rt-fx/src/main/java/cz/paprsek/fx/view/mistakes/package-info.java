/** The mistake laboratory: pictures with mistakes beside the right one. */
package cz.paprsek.fx.view.mistakes;
