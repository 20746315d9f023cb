/**
 * Pictures in linear light, and the files they are written to.
 * Right-handed world, y up, lengths in scene units; degrees at the border, radians inside.
 */
package cz.paprsek.image;
