/**
 * What a user can do by menu, key or button, each one step of the history. Changes nothing but through {@code EditorModel}.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.view.command;
