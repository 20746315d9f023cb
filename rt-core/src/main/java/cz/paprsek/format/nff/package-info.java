/** NFF, the neutral file format of the Standard Procedural Databases: balls, cones and polygons, with a view, lights and materials that are nearly ours. */
@NullMarked
package cz.paprsek.format.nff;

import org.jspecify.annotations.NullMarked;
