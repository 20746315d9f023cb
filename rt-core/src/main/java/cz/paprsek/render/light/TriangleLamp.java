package cz.paprsek.render.light;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;

/** A triangle that shines to both sides, or, of a closed mesh, outwards. */
final class TriangleLamp extends AreaLamp {
    /**
     * A triangle of a mesh.
     *
     * @param a a corner, world space; the others counter-clockwise as seen from outside
     * @param isOneSided whether what is behind it is within a body
     */
    TriangleLamp(Rgb color, double strength, Vec3 a, Vec3 b, Vec3 c, boolean isOneSided) {
        super(color, strength, a, b.minus(a), c.minus(a), 0.5, !isOneSided);
    }

    /** @source Shirley and Wang, Direct Lighting Calculation by Monte Carlo Integration, Eurographics Workshop on Rendering, 1991 */
    @Override
    void place(double u, double v, Arrival out) {
        double root = Math.sqrt(u);
        out.x = root * (1 - v);
        out.y = root * v;
    }
}
