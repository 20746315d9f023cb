package cz.paprsek.ray;

import cz.paprsek.math.Affine;

/** Scratch of one worker: the place where a ray met a surface, world space. */
public final class Hit {
    /** The point. */
    public double px;
    public double py;
    public double pz;
    /** The size of the numbers that led to the point, coordinates and distance travelled, added up: what its rounding errors are relative to. */
    public double size;
    /** The normal, of length 1: out of a solid, or on the +z side of a flat surface. */
    public double nx;
    public double ny;
    public double nz;
    /** Where on a flat surface: 0–1 along its x and y; 0 on a solid. */
    public double u;
    public double v;

    /** Sets the normal from one in a shape's own space, of any length, by the transpose of the map into that space. */
    public void normal(Affine toLocal, double x, double y, double z) {
        unitNormal(
                toLocal.xx() * x + toLocal.yx() * y + toLocal.zx() * z,
                toLocal.xy() * x + toLocal.yy() * y + toLocal.zy() * z,
                toLocal.xz() * x + toLocal.yz() * y + toLocal.zz() * z);
    }

    /** Sets the normal from a vector of any length but 0, world space. */
    public void unitNormal(double x, double y, double z) {
        double k = 1 / Math.sqrt(x * x + y * y + z * z);
        nx = x * k;
        ny = y * k;
        nz = z * k;
    }
}
