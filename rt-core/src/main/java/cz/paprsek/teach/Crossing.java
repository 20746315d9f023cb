package cz.paprsek.teach;

/**
 * Where a line goes through a surface.
 *
 * @param face which of the primitive's faces
 * @param flipped whether a difference turned the surface inside out
 */
record Crossing(double t, Primitive of, int face, boolean flipped) {
    Crossing at(double place) {
        return new Crossing(place, of, face, flipped);
    }

    Crossing turned() {
        return new Crossing(t, of, face, !flipped);
    }

    /** The normal of the surface, out of the body. */
    Vec normal(Vec point) {
        Vec outwards = of.normal(point, face);
        return flipped ? outwards.times(-1) : outwards;
    }

    /** Whether the body is entered here. */
    boolean isEntry(Ray ray) {
        return ray.direction().dot(normal(ray.at(t))) < 0;
    }
}
