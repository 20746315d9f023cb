/**
 * Pictures rendered one by one, each in a tab, while editing goes on.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.view.render;
