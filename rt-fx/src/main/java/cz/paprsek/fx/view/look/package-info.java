/**
 * How everything looks: themes, colours of what is drawn, icons.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.view.look;
