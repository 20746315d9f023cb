/**
 * Fields for numbers that say what is wrong with them, and values to choose by name.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.view.render.fields;
