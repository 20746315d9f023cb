/**
 * Why a pixel has its colour: the tree of rays behind it as immutable records.
 * What the records hold was computed by the tracer that computes pictures; nothing is computed again here.
 * Right-handed world, y up, lengths in scene units, angles in degrees, colours in linear light.
 */
@NullMarked
package cz.paprsek.render.explain;

import org.jspecify.annotations.NullMarked;
