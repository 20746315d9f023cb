/**
 * What can be seen and changed about things: made from the components of their records, with one table of what the components do not tell.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.model.property;
