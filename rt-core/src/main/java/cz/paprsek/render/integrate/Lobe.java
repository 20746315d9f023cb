package cz.paprsek.render.integrate;

import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.Media;
import cz.paprsek.render.surface.World;
import cz.paprsek.shape.placed.Ray;

/**
 * Scratch of one worker: what the facets of a rough surface send to the viewer of light that comes from one direction, as what is mirrored or as
 * what is let through.
 */
final class Lobe extends Shares {
    /** Vectors shorter than this have no direction: light goes straight through. */
    private static final double NOWHERE = 1e-9;

    private final World scene;
    /** The media beyond the surface. */
    final Media beyond = new Media();
    private boolean isPane;
    private double from;
    private double to;
    /** Cosine between viewer and normal; G₁ from there. */
    private double facing;
    private double seen;

    /** D, and G₁ from the light, of what was looked at last. */
    double spread;
    double lit;
    /** π·f·cos θ of each channel. */
    double valueRed;
    double valueGreen;
    double valueBlue;
    /** How probable it is that a ray goes there, per solid angle. */
    double density;

    Lobe(World scene) {
        this.scene = scene;
    }

    /** Makes ready for a hit. */
    void at(Level level, Finish of) {
        Ray ray = level.ray;
        Hit hit = level.hit;
        isPane = scene.isPane(level, of);
        from = level.media.refractiveIndex();
        double inside = scene.enterBeyond(level, of, beyond);
        to = isPane || !scene.isSolid(scene.parts().object(ray.part)) ? of.refractiveIndex : inside;
        facing = Math.min(1, -(ray.dx * hit.sx + ray.dy * hit.sy + ray.dz * hit.sz));
        seen = facing > 0 ? Ggx.seen(facing, of.alpha) : 0;
    }

    /** G₁ from the viewer. */
    double seen() {
        return seen;
    }

    /**
     * Looks at light from a direction: whether anything of it is sent to the viewer.
     *
     * @param finish the hit's
     * @param cosine N·L; below 0 for light from beyond the surface
     */
    boolean look(Level level, Finish finish, Arrival light, double cosine) {
        forget();
        if (!(facing > 0) || cosine == 0 || (cosine < 0 && finish.transparency == 0)) {
            return false;
        }
        return (cosine < 0 && !isPane) ? through(level, finish, light, -cosine) : back(level, finish, light, cosine);
    }

    /** Looks at no light. */
    void forget() {
        density = 0;
        value(0, 0, 0);
    }

    /** Mirrored; or let through by a pane, which strews as much to the one side as to the other. */
    private boolean back(Level level, Finish finish, Arrival light, double cosine) {
        Ray ray = level.ray;
        Hit hit = level.hit;
        double over = cosine < 0 ? 2 * cosine : 0;
        double hx = light.x - over * hit.sx - ray.dx;
        double hy = light.y - over * hit.sy - ray.dy;
        double hz = light.z - over * hit.sz - ray.dz;
        double length = Math.sqrt(hx * hx + hy * hy + hz * hz);
        if (length < NOWHERE) {
            return false;
        }
        double upright = Math.min(1, (hx * hit.sx + hy * hit.sy + hz * hit.sz) / length);
        double c = Math.min(1, -(hx * ray.dx + hy * ray.dy + hz * ray.dz) / length);
        double e = from / to;
        weigh(level, finish, isPane, from, to, c, 1 + e * e * (c * c - 1));
        spread = Ggx.spread(upright, finish.alpha);
        lit = Ggx.seen(Math.min(1, Math.abs(cosine)), finish.alpha);
        double k = Math.PI * spread * seen * lit / (4 * facing);
        density = k / (Math.PI * lit) * (cosine > 0 ? chance() : 1 - chance());
        return cosine > 0 ? value(k * red, k * green, k * blue) : value(k * through, k * through, k * through);
    }

    private boolean through(Level level, Finish finish, Arrival light, double cosine) {
        Ray ray = level.ray;
        Hit hit = level.hit;
        // Against the ray and towards the light, each times its index: along the facet's normal, on the side of the thinner medium.
        double hx = to * light.x - from * ray.dx;
        double hy = to * light.y - from * ray.dy;
        double hz = to * light.z - from * ray.dz;
        double length = Math.sqrt(hx * hx + hy * hy + hz * hz);
        if (length < NOWHERE * to) {
            return false;
        }
        double sign = (hx * hit.sx + hy * hit.sy + hz * hit.sz < 0 ? -1 : 1) / length;
        hx *= sign;
        hy *= sign;
        hz *= sign;
        double upright = Math.min(1, hx * hit.sx + hy * hit.sy + hz * hit.sz);
        double c = Math.min(1, -(hx * ray.dx + hy * ray.dy + hz * ray.dz));
        double d = -(hx * light.x + hy * light.y + hz * light.z);
        if (!(c > 0) || !(d > 0)) {
            return false;
        }
        double e = from / to;
        weigh(level, finish, false, from, to, c, 1 + e * e * (c * c - 1));
        spread = Ggx.spread(upright, finish.alpha);
        lit = Ggx.seen(Math.min(1, cosine), finish.alpha);
        double bend = from * c - to * d;
        double k = Math.PI * spread * seen * lit * c * d * (to * to / (bend * bend)) / facing;
        density = k / (Math.PI * lit) * (1 - chance());
        return value(k * through, k * through, k * through);
    }

    private boolean value(double r, double g, double b) {
        valueRed = r;
        valueGreen = g;
        valueBlue = b;
        return r > 0 || g > 0 || b > 0;
    }
}
