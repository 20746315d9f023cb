/**
 * Where scenes are kept: files, databases, copies of what is unsaved; and what the program remembers of a user.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.model.file;
