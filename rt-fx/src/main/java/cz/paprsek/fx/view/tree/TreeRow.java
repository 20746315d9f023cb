package cz.paprsek.fx.view.tree;

import cz.paprsek.scene.ScenePath;

/**
 * A line of the tree.
 *
 * @param item what it stands for
 * @param depth how many operations are around it
 * @param text its name, or its kind if it has none
 * @param named whether the text is a name
 * @param icon of its kind
 * @param operation whether it has operands
 * @param expanded whether these are shown
 */
record TreeRow(ScenePath item, int depth, String text, boolean named, String icon, boolean operation, boolean expanded) {}
