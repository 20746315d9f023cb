package cz.paprsek.render.integrate;

import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;

/** Scratch: which shares of light a surface mirrors and lets through at an angle. */
class Shares {
    /** F, of what the material mirrors. */
    double fresnelRed;
    double fresnelGreen;
    double fresnelBlue;
    /** The share of what is mirrored. */
    double red;
    double green;
    double blue;
    /** The share of what goes on beyond the surface. */
    double through;

    /**
     * Weighs what becomes of light.
     *
     * @param isPane whether light that goes through meets two surfaces at once
     * @param from refractive index before the surface
     * @param to refractive index beyond it
     * @param c cosine of the angle before it
     * @param radicand cosine, squared, of the angle beyond it; below 0 if there is none
     */
    final void weigh(Level level, Finish finish, boolean isPane, double from, double to, double c, double radicand) {
        boolean isTotal = radicand < 0;
        boolean isLost = isTotal && finish.transparency > 0 && !isPane;
        if (finish.fresnel != Fresnel.TRUE) {
            double grazing = finish.fresnel == Fresnel.METAL ? schlick(c) : 1;
            fresnelRed = level.colorRed + (1 - level.colorRed) * grazing;
            fresnelGreen = level.colorGreen + (1 - level.colorGreen) * grazing;
            fresnelBlue = level.colorBlue + (1 - level.colorBlue) * grazing;
            if (finish.fresnel == Fresnel.FALSE) {
                fresnel(1);
            }
            double rest = isLost ? finish.transparency : 0;
            mirror(finish.reflection * fresnelRed + rest, finish.reflection * fresnelGreen + rest, finish.reflection * fresnelBlue + rest);
            through = finish.transparency - rest;
            return;
        }
        double once = isTotal ? 1 : reflectance(from, to, c, Math.sqrt(radicand));
        // Of a pane what is mirrored within comes out again: R + (1 − R)²·R·(1 + R² + R⁴ + …).
        double share = isPane ? 2 * once / (1 + once) : once;
        fresnel(share);
        double mirrored = isLost ? finish.reflection + finish.transparency * (1 - finish.reflection) : finish.reflection * share;
        mirror(mirrored, mirrored, mirrored);
        through = isLost ? 0 : finish.transparency * (1 - finish.reflection * share);
    }

    private void fresnel(double share) {
        fresnelRed = share;
        fresnelGreen = share;
        fresnelBlue = share;
    }

    private void mirror(double r, double g, double b) {
        red = r;
        green = g;
        blue = b;
    }

    /** The greatest share that is mirrored of a channel. */
    final double mirrored() {
        return Math.max(red, Math.max(green, blue));
    }

    /** Of one ray that is followed for both, how often it is the mirrored one. */
    final double chance() {
        double mirrored = mirrored();
        return mirrored + through > 0 ? mirrored / (mirrored + through) : 1;
    }

    /** (1 − cos θ)⁵ */
    private static double schlick(double cosine) {
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
