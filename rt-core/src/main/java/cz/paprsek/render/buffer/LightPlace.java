package cz.paprsek.render.buffer;

import cz.paprsek.math.Vec3;

/**
 * Where all light of a lamp comes from.
 *
 * @param at a point, world space; or of a light endlessly far away its direction, towards the light, of length 1
 */
public record LightPlace(Vec3 at, boolean isFar) {}
