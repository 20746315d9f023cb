package cz.paprsek.render.integrate;

import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.surface.Level;
import cz.paprsek.shape.placed.Ray;

/**
 * What holds where light is reckoned with another normal s than that of the surface itself, n: no light leaks through what has no holes. A normal
 * that the viewer would see from behind is turned until he sees it edge-on. Light that comes from behind the surface does not light it. A
 * direction that would lead a mirrored ray into the surface, or one that goes on out of it, is folded back: its part along n is turned round.
 */
final class Bent {
    /** The sine of how far a flat piece may be turned away from a light that the round surface for which it stands faces: 20°. */
    private static final double ROUNDED = 0.342;

    private Bent() {}

    /** Turns s, which is on the viewer's side of the surface as n is, to the viewer if it is not. */
    static void towardsViewer(Ray ray, Hit hit) {
        double away = ray.dx * hit.sx + ray.dy * hit.sy + ray.dz * hit.sz;
        if (away > 0) {
            double x = hit.sx - away * ray.dx;
            double y = hit.sy - away * ray.dy;
            double z = hit.sz - away * ray.dz;
            // Seen exactly from behind, no direction is nearer than another.
            if (x * x + y * y + z * z > 0) {
                hit.bend(x, y, z);
            } else {
                hit.bend(hit.nx, hit.ny, hit.nz);
            }
        }
    }

    /** Folds the level's mirrored direction back to the side of the viewer. */
    static void mirror(Level level) {
        Hit hit = level.hit;
        double fold = fold(hit, level.mirrorX, level.mirrorY, level.mirrorZ, false);
        level.mirrorX += fold * hit.nx;
        level.mirrorY += fold * hit.ny;
        level.mirrorZ += fold * hit.nz;
    }

    /** By how much of n a direction must be moved so that it is on the side of n, or on the other. */
    static double fold(Hit hit, double x, double y, double z, boolean beyond) {
        double along = x * hit.nx + y * hit.ny + z * hit.nz;
        return -2 * (beyond ? Math.max(0, along) : Math.min(0, along));
    }

    /**
     * N·L, of which the sign says from which side of the surface light comes: 0 if the two normals do not agree, unless the surface stands for a round
     * one that is flatter there. Else the border of light and shadow would run along its flat pieces.
     */
    static double facing(Hit hit, Arrival light, double facing) {
        double itself = hit.nx * light.x + hit.ny * light.y + hit.nz * light.z;
        return (itself > 0) == (facing > 0) || (hit.isRounded && facing > 0 && itself > -ROUNDED) ? facing : 0;
    }
}
