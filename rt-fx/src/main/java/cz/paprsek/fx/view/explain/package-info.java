/** Why a pixel has its colour: the tree of rays as an outline, as worked exercise and as drawing. Shows what the core explains; computes nothing. */
package cz.paprsek.fx.view.explain;
