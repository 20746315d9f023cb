package cz.paprsek.render.integrate;

import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import cz.paprsek.shape.placed.Ray;

/** Scratch of one level: where a surface sends light whose shares depend on the angle, and how much of it. */
final class Scatter {
    private final Witness witness;
    /** The share of what is mirrored; nothing is if it is black. */
    double red;
    double green;
    double blue;
    /** Where to, of length 1. */
    double x;
    double y;
    double z;
    /** The share of what goes on beyond the surface; nothing does if it is 0. */
    double through;
    double throughX;
    double throughY;
    double throughZ;

    Scatter(Witness witness) {
        this.witness = witness;
    }

    /**
     * Decides where light goes from the level's hit.
     *
     * @param next a level whose media may be changed
     * @param leaving whether the normal was turned round
     * @param c cosine of the angle between the ray and the normal, 0–1
     */
    void decide(World scene, Level level, Level next, Finish finish, boolean leaving, double c) {
        Ray ray = level.ray;
        Hit hit = level.hit;
        boolean isTransparent = finish.transparency > 0;
        boolean isFlat = !scene.isSolid(scene.parts().object(ray.part));
        double from = level.media.refractiveIndex();
        double to = isFlat ? finish.refractiveIndex : scene.enterBeyond(level, finish, leaving, next.media);
        double e = from / to;
        double radicand = 1 + e * e * (c * c - 1);
        if (isTransparent && !isFlat) {
            witness.bent(from, to, radicand);
        }
        boolean isTotal = radicand < 0;
        double root = isTotal ? 0 : Math.sqrt(radicand);
        weigh(level, finish, isTransparent, isTransparent && isFlat, isTotal, from, to, c, root);
        double twice = 2 * c;
        x = ray.dx + twice * hit.sx;
        y = ray.dy + twice * hit.sy;
        z = ray.dz + twice * hit.sz;
        double bend = isFlat ? 1 : e;
        double k = isFlat ? 0 : e * c - root;
        throughX = bend * ray.dx + k * hit.sx;
        throughY = bend * ray.dy + k * hit.sy;
        throughZ = bend * ray.dz + k * hit.sz;
    }

    private void weigh(Level level, Finish finish, boolean isTransparent, boolean isPane, boolean isTotal, double from, double to, double c, double root) {
        boolean isLost = isTotal && isTransparent && !isPane;
        if (finish.fresnel == Fresnel.METAL) {
            double grazing = schlick(c);
            double r = level.colorRed + (1 - level.colorRed) * grazing;
            double g = level.colorGreen + (1 - level.colorGreen) * grazing;
            double b = level.colorBlue + (1 - level.colorBlue) * grazing;
            witness.split(from, to, c, root, r, g, b);
            double rest = isLost ? finish.transparency : 0;
            mirror(finish.reflection * r + rest, finish.reflection * g + rest, finish.reflection * b + rest);
            through = finish.transparency - rest;
            return;
        }
        double once = isTotal ? 1 : reflectance(from, to, c, root);
        // Of a pane what is mirrored within comes out again: R + (1 − R)²·R·(1 + R² + R⁴ + …).
        double share = isPane ? 2 * once / (1 + once) : once;
        witness.split(from, to, c, root, share, share, share);
        double mirrored = isLost ? finish.reflection + finish.transparency * (1 - finish.reflection) : finish.reflection * share;
        mirror(mirrored, mirrored, mirrored);
        through = isLost ? 0 : finish.transparency * (1 - finish.reflection * share);
    }

    private void mirror(double r, double g, double b) {
        red = r;
        green = g;
        blue = b;
    }

    /** Whether anything is mirrored. */
    boolean isMirrored() {
        return red > 0 || green > 0 || blue > 0;
    }

    /** (1 − cos θ)⁵ */
    static double schlick(double cosine) {
        double rest = 1 - cosine;
        double square = rest * rest;
        return square * square * rest;
    }

    /**
     * The share of light without polarisation that is mirrored where one medium ends and another begins, 0–1.
     *
     * @param from n₁, refractive index before it
     * @param to n₂, refractive index beyond it
     * @param cosine cos θ₁, 0–1
     * @param beyond cos θ₂, 0–1
     * @source Fresnel's equations: Born and Wolf, Principles of Optics, 1.5.2
     */
    static double reflectance(double from, double to, double cosine, double beyond) {
        double across = from * cosine + to * beyond;
        double along = from * beyond + to * cosine;
        if (!(across > 0 && along > 0)) {
            return 1;
        }
        double s = (from * cosine - to * beyond) / across;
        double p = (from * beyond - to * cosine) / along;
        return (s * s + p * p) / 2;
    }
}
