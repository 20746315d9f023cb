/**
 * What shows the scene: projections, object tree, property sheet, pictures. Changes nothing but through {@code EditorModel}.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.view;
