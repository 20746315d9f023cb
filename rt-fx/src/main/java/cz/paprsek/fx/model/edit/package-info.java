/**
 * What can be done to a scene: each change takes a state or a scene and gives another, for {@code EditorModel} to take. Knows no window.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.model.edit;
