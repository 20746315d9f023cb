/**
 * Where in a scene something stands that can be selected, and what stands there.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.fx.model.item;
