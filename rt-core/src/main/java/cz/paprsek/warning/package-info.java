/**
 * What is allowed in a scene, but hardly what its author meant.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.warning;
