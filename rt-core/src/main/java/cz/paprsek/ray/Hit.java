package cz.paprsek.ray;

import cz.paprsek.math.Affine;

/**
 * Scratch of one worker: the place where a ray met a surface, world space. Point and normals are known of every hit; the map (u, v and the
 * tangent) only where somebody has asked for it.
 */
public final class Hit {
    /** The point. */
    public double px;
    public double py;
    public double pz;
    /** The size of the numbers that led to the point, coordinates and distance travelled, added up: what its rounding errors are relative to. */
    public double size;
    /** The normal of the surface itself, of length 1: out of a solid, or on the +z side of a flat surface. It tells the sides, and what is entered. */
    public double nx;
    public double ny;
    public double nz;
    /** The normal that light is reckoned with, of length 1, on the same side; the same if the surface does not say otherwise. */
    public double sx;
    public double sy;
    public double sz;
    /**
     * Whether the surface is made of flat pieces that stand for a round one, of which the normal for light is: a piece that is turned away from a
     * light where the round one is not yet is lit all the same.
     */
    public boolean isRounded;
    /** The place in a picture that covers the surface: 0–1 to the right and up, as seen from outside; beyond on a surface without end. */
    public double u;
    public double v;
    /** The direction in which u grows and v does not, along the surface, of length 1. */
    public double tx;
    public double ty;
    public double tz;

    /** The colour of the surface there, linear light, 0–1: what a pattern that was made in code answers. */
    public double red;
    public double green;
    public double blue;

    /** What who was hit has left for itself to describe the hit sooner, or what another one has: it tells by itself which. */
    public int hint;

    private double[] room = {};

    /** Scratch of at least so many numbers, for a surface while it describes the hit. */
    public double[] room(int numbers) {
        if (room.length < numbers) {
            room = new double[numbers];
        }
        return room;
    }

    /** Sets the colour, linear light, 0–1. */
    public void color(double r, double g, double b) {
        red = r;
        green = g;
        blue = b;
    }

    /** Sets the normals from one in a shape's own space, of any length but 0, by the transpose of the map into that space. */
    public void normal(Affine toLocal, double x, double y, double z) {
        normal(
                toLocal.xx() * x + toLocal.yx() * y + toLocal.zx() * z,
                toLocal.xy() * x + toLocal.yy() * y + toLocal.zy() * z,
                toLocal.xz() * x + toLocal.yz() * y + toLocal.zz() * z);
    }

    /** Takes the normals out of another space, by the transpose of the map into that space; if they are one there, they are one here. */
    public void normalsFrom(Affine toOther) {
        boolean isRoundedThere = isRounded;
        boolean areOne = sx == nx && sy == ny && sz == nz;
        double x = sx;
        double y = sy;
        double z = sz;
        normal(toOther, nx, ny, nz);
        isRounded = isRoundedThere;
        if (!areOne) {
            bend(toOther.xx() * x + toOther.yx() * y + toOther.zx() * z, toOther.xy() * x + toOther.yy() * y + toOther.zy() * z,
                    toOther.xz() * x + toOther.yz() * y + toOther.zz() * z);
        }
    }

    /** Takes the normal of the surface itself into another space, where it has any length: by the transpose of the map back, by Cramer's rule. */
    public void normalInto(Affine toOther) {
        double ax = toOther.yy() * toOther.zz() - toOther.yz() * toOther.zy();
        double ay = toOther.yz() * toOther.zx() - toOther.yx() * toOther.zz();
        double az = toOther.yx() * toOther.zy() - toOther.yy() * toOther.zx();
        double bx = toOther.zy() * toOther.xz() - toOther.zz() * toOther.xy();
        double by = toOther.zz() * toOther.xx() - toOther.zx() * toOther.xz();
        double bz = toOther.zx() * toOther.xy() - toOther.zy() * toOther.xx();
        double cx = toOther.xy() * toOther.yz() - toOther.xz() * toOther.yy();
        double cy = toOther.xz() * toOther.yx() - toOther.xx() * toOther.yz();
        double cz = toOther.xx() * toOther.yy() - toOther.xy() * toOther.yx();
        double side = toOther.xx() * ax + toOther.xy() * ay + toOther.xz() * az < 0 ? -1 : 1;
        double x = side * (ax * nx + ay * ny + az * nz);
        double y = side * (bx * nx + by * ny + bz * nz);
        nz = side * (cx * nx + cy * ny + cz * nz);
        nx = x;
        ny = y;
    }

    /** Sets the normals from a vector of any length but 0. */
    public void normal(double x, double y, double z) {
        double k = 1 / Math.sqrt(x * x + y * y + z * z);
        unitNormal(x * k, y * k, z * k);
    }

    /** Sets the normals from a vector of length 1. */
    public void unitNormal(double x, double y, double z) {
        nx = x;
        ny = y;
        nz = z;
        sx = x;
        sy = y;
        sz = z;
        isRounded = false;
    }

    /** Sets the normal that light is reckoned with, from a vector of any length; it stays as it is if that is 0 or too large. */
    public void bend(double x, double y, double z) {
        double k = 1 / Math.sqrt(x * x + y * y + z * z);
        if (k > 0 && k < Double.POSITIVE_INFINITY) {
            sx = x * k;
            sy = y * k;
            sz = z * k;
        }
    }

    /** Turns the normals round. */
    public void turn() {
        nx = -nx;
        ny = -ny;
        nz = -nz;
        sx = -sx;
        sy = -sy;
        sz = -sz;
    }

    /** Sets the map; the tangent of any length but 0. */
    public void map(double atU, double atV, double tangentX, double tangentY, double tangentZ) {
        u = atU;
        v = atV;
        double k = 1 / Math.sqrt(tangentX * tangentX + tangentY * tangentY + tangentZ * tangentZ);
        tx = tangentX * k;
        ty = tangentY * k;
        tz = tangentZ * k;
    }

    /**
     * Sets the map as a label around the y axis, of which (x, z) says the direction: u = ½ + atan2(x, z)/2π, so that the middle of the
     * picture looks to +z and its edges meet at −z. On the axis itself u is ½.
     */
    public void mapAround(double x, double z, double atV) {
        boolean onAxis = x == 0 && z == 0;
        map(0.5 + StrictMath.atan2(x, z) / (2 * Math.PI), atV, onAxis ? 1 : z, 0, onAxis ? 0 : -x);
    }

    /** Sets the map as that of a globe about the origin, by the direction of a point: as {@link #mapAround} with v = ½ + latitude/π. */
    public void mapGlobe(double x, double y, double z) {
        mapAround(x, z, 0.5 + StrictMath.atan2(y, Math.sqrt(x * x + z * z)) / Math.PI);
    }

    /**
     * Sets the map as that of a round lid of which the centre is at 0, seen from above (+y) or below by somebody who stands at +z: the square
     * around it is the whole picture.
     */
    public void mapLid(double x, double z, double radius, boolean fromAbove) {
        map((1 + x / radius) / 2, (fromAbove ? 1 - z / radius : 1 + z / radius) / 2, 1, 0, 0);
    }

    /** Takes the tangent from a shape's own space to the world: the inverse of the map into that space, by Cramer's rule. */
    public void tangentFrom(Affine toLocal) {
        double ax = toLocal.yy() * toLocal.zz() - toLocal.yz() * toLocal.zy();
        double ay = toLocal.yz() * toLocal.zx() - toLocal.yx() * toLocal.zz();
        double az = toLocal.yx() * toLocal.zy() - toLocal.yy() * toLocal.zx();
        double bx = toLocal.zy() * toLocal.xz() - toLocal.zz() * toLocal.xy();
        double by = toLocal.zz() * toLocal.xx() - toLocal.zx() * toLocal.xz();
        double bz = toLocal.zx() * toLocal.xy() - toLocal.zy() * toLocal.xx();
        double cx = toLocal.xy() * toLocal.yz() - toLocal.xz() * toLocal.yy();
        double cy = toLocal.xz() * toLocal.yx() - toLocal.xx() * toLocal.yz();
        double cz = toLocal.xx() * toLocal.yy() - toLocal.xy() * toLocal.yx();
        double side = toLocal.xx() * ax + toLocal.xy() * ay + toLocal.xz() * az < 0 ? -1 : 1;
        map(u, v, side * (tx * ax + ty * bx + tz * cx), side * (tx * ay + ty * by + tz * cy), side * (tx * az + ty * bz + tz * cz));
    }
}
