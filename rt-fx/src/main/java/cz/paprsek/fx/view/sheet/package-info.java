/**
 * The property sheet: what is selected, property by property. Changes nothing but through the editor's model.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.view.sheet;
