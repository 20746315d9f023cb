/**
 * What is edited: the scene, the selection beside it, and the history. Knows {@code javafx.base} only, no stage and no node.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.model;
