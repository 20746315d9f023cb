package cz.paprsek.shape.copied;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;

/**
 * One of the places in which an {@link Original} stands: a ray is taken into its space, and what it meets there is taken back. There the ray's direction is
 * of length 1 again, so that t grows as often as fast as lengths do.
 */
public final class Copy extends Volume {
    private final Original original;
    private final Affine toOriginal;
    private final Bounds bounds;
    /** The number of its first part; those of the others lie as far behind as in the original. */
    private final int first;
    /** How often as fast t grows in the original's space; 0 if that depends on the direction. */
    private final double growth;

    /** @param toWorld from the original's space to the one around: the world, or that of another original */
    Copy(Original original, Affine toWorld, int first) {
        this.original = original;
        this.toOriginal = toWorld.inverse();
        this.bounds = original.whole().bounds().transformed(toWorld);
        this.first = first;
        this.growth = toOriginal.uniformScale();
    }

    /** What it is a copy of. */
    public Original original() {
        return original;
    }

    Affine toOriginal() {
        return toOriginal;
    }

    @Override
    public Bounds bounds() {
        return bounds;
    }

    @Override
    public double cost() {
        return original.whole().cost();
    }

    private double growth(Ray ray) {
        if (growth > 0) {
            return growth;
        }
        double x = toOriginal.directionX(ray.dx, ray.dy, ray.dz);
        double y = toOriginal.directionY(ray.dx, ray.dy, ray.dz);
        double z = toOriginal.directionZ(ray.dx, ray.dy, ray.dz);
        return Math.sqrt(x * x + y * y + z * z);
    }

    private Ray enter(Ray ray, double k) {
        Ray within = ray.within();
        int part = ray.left - first;
        within.become(ray, toOriginal, k, ray.left >= first && part <= original.lastNumber() ? part : -1);
        return within;
    }

    @Override
    public void nearest(Ray ray) {
        double k = growth(ray);
        Ray within = enter(ray, k);
        original.whole().nearest(within);
        if (within.part >= 0) {
            ray.accept(within.max / k, first + within.part, within.face);
        }
    }

    @Override
    public boolean occludes(Ray ray) {
        return original.whole().occludes(enter(ray, growth(ray)));
    }

    @Override
    public void crossings(Ray ray, Spans out) {
        double k = growth(ray);
        int mark = out.size();
        original.whole().crossings(enter(ray, k), out);
        out.carry(mark, k, first);
    }

    @Override
    public void spans(Ray ray, Spans out) {
        double k = growth(ray);
        int mark = out.size();
        original.whole().spans(enter(ray, k), out);
        out.carry(mark, k, first);
    }
}
