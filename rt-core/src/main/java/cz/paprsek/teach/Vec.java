package cz.paprsek.teach;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;

/** Three numbers: a point, a direction, or light by its red, green and blue. Mistakes may make them infinite, or no numbers. */
record Vec(double x, double y, double z) {
    static final Vec ZERO = new Vec(0, 0, 0);

    static Vec of(Vec3 v) {
        return new Vec(v.x(), v.y(), v.z());
    }

    /** The linear light of a colour. */
    static Vec light(Rgb color) {
        return new Vec(color.linearRed(), color.linearGreen(), color.linearBlue());
    }

    Vec plus(Vec v) {
        return new Vec(x + v.x, y + v.y, z + v.z);
    }

    Vec minus(Vec v) {
        return new Vec(x - v.x, y - v.y, z - v.z);
    }

    Vec times(double k) {
        return new Vec(x * k, y * k, z * k);
    }

    /** Channel by channel. */
    Vec times(Vec v) {
        return new Vec(x * v.x, y * v.y, z * v.z);
    }

    double dot(Vec v) {
        return x * v.x + y * v.y + z * v.z;
    }

    double length() {
        return Math.sqrt(dot(this));
    }

    /** The same direction, of length 1. */
    Vec unit() {
        return times(1 / length());
    }

    /** |x| + |y| + |z|: what the rounding errors of a point are relative to. */
    double size() {
        return Math.abs(x) + Math.abs(y) + Math.abs(z);
    }

    /** Where a map takes this point. */
    Vec through(Affine map) {
        return new Vec(map.pointX(x, y, z), map.pointY(x, y, z), map.pointZ(x, y, z));
    }

    /** Where a map takes this direction. */
    Vec along(Affine map) {
        return new Vec(map.directionX(x, y, z), map.directionY(x, y, z), map.directionZ(x, y, z));
    }

    /** A normal as it is in the world, of length 1: by the transpose of the map from there to the space that it is given in. */
    Vec normalFrom(Affine toOwn) {
        return new Vec(
                toOwn.xx() * x + toOwn.yx() * y + toOwn.zx() * z,
                toOwn.xy() * x + toOwn.yy() * y + toOwn.zy() * z,
                toOwn.xz() * x + toOwn.yz() * y + toOwn.zz() * z).unit();
    }
}
