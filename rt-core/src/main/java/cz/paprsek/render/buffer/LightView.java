package cz.paprsek.render.buffer;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;

/**
 * What a light would see: a point p is seen at u = (p − o)·U / (p − o)·W and v likewise, where W leads from the light to the middle of things; of a light far away, which looks along
 * W from before all of them, without the quotient. Immutable.
 */
final class LightView {
    /** o. */
    final double x;
    final double y;
    final double z;
    final boolean isFar;
    final double ux;
    final double uy;
    final double uz;
    final double vx;
    final double vy;
    final double vz;
    final double wx;
    final double wy;
    final double wz;

    LightView(LightPlace light, Bounds things) {
        isFar = light.isFar();
        Vec3 middle = things.middle();
        Vec3 w = isFar ? light.at().negated() : middle.minus(light.at()).normalized();
        Vec3 o = isFar ? middle.minus(w.times(length(things))) : light.at();
        Vec3 u = w.cross(Math.abs(w.x()) < 0.6 ? Vec3.X : Vec3.Y).normalized();
        Vec3 v = w.cross(u);
        x = o.x();
        y = o.y();
        z = o.z();
        ux = u.x();
        uy = u.y();
        uz = u.z();
        vx = v.x();
        vy = v.y();
        vz = v.z();
        wx = w.x();
        wy = w.y();
        wz = w.z();
    }

    /** From one corner to the one across. */
    static double length(Bounds box) {
        double a = box.maxX() - box.minX();
        double b = box.maxY() - box.minY();
        double c = box.maxZ() - box.minZ();
        return Math.sqrt(a * a + b * b + c * c);
    }

    /** By what the ways along U and V of a point are multiplied, which lies so far along W. */
    double factor(double along) {
        return isFar ? 1 : 1 / along;
    }
}
