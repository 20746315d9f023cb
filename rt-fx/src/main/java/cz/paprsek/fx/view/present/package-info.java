/** Explaining a pixel before a class: the picture large, its rays one after the other, their exercise in large type. */
package cz.paprsek.fx.view.present;
