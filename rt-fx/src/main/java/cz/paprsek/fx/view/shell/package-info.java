/**
 * What the window is put together from: the four titled views, palette, messages, status.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.view.shell;
