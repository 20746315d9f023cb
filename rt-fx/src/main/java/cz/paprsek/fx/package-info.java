/**
 * The editor as a program: where it starts, its window and menus, its words. No logic.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx;
