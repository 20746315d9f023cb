/**
 * The scene database that is open, its rows by table, and its file.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.model.library;
