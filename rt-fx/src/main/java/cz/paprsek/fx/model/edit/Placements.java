package cz.paprsek.fx.model.edit;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Placement;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Optional;

/** Finds the placement that makes a given map. */
final class Placements {
    /** How far from perpendicular the axes may be: rounding, not shear. */
    private static final double SHEAR = 1e-9;

    private Placements() {}

    /**
     * The placement whose map is the given one; empty if there is none because the map shears or flattens. A map that mirrors is given a
     * negative scale along z. Numbers that differ from round ones by rounding errors only are made round.
     *
     * @source the rotation about x, then y, then z as a matrix, see {@link Affine#rotation}, solved for its angles
     */
    static Optional<Placement> of(Affine map) {
        Vec3 x = new Vec3(map.xx(), map.yx(), map.zx());
        Vec3 y = new Vec3(map.xy(), map.yy(), map.zy());
        Vec3 z = new Vec3(map.xz(), map.yz(), map.zz());
        double sx = x.length();
        double sy = y.length();
        double sz = Math.copySign(z.length(), x.cross(y).dot(z));
        if (sx == 0 || sy == 0 || sz == 0 || sheared(x, y) || sheared(y, z) || sheared(z, x)) {
            return Optional.empty();
        }
        Vec3 rotation = angles(x.times(1 / sx), y.times(1 / sy), z.times(1 / sz));
        return Optional.of(new Placement(
                round(new Vec3(map.xt(), map.yt(), map.zt()), 1), round(rotation, 1), round(new Vec3(sx, sy, sz), 0)));
    }

    private static boolean sheared(Vec3 a, Vec3 b) {
        return Math.abs(a.dot(b)) > SHEAR * a.length() * b.length();
    }

    /** The angles in degrees of the rotation whose columns are x, y, z. */
    private static Vec3 angles(Vec3 x, Vec3 y, Vec3 z) {
        double aboutY = Math.atan2(-x.z(), Math.hypot(x.x(), x.y()));
        // Looking straight along an axis, only the sum of the other two angles shows: the last is taken to be 0.
        boolean locked = Math.hypot(x.x(), x.y()) < 1e-12;
        double aboutX = locked ? Math.atan2(-z.y(), y.y()) : Math.atan2(y.z(), z.z());
        double aboutZ = locked ? 0 : Math.atan2(x.y(), x.x());
        return new Vec3(Math.toDegrees(aboutX), Math.toDegrees(aboutY), Math.toDegrees(aboutZ));
    }

    private static Vec3 round(Vec3 v, double least) {
        double size = Math.max(least, Math.max(Math.abs(v.x()), Math.max(Math.abs(v.y()), Math.abs(v.z()))));
        return new Vec3(round(v.x(), size), round(v.y(), size), round(v.z(), size));
    }

    /** The nearest number of ten decimals relative to the size, if only rounding errors lie between. */
    static double round(double value, double size) {
        int decimals = 10 - (int) Math.ceil(Math.log10(size));
        double rounded = BigDecimal.valueOf(value).setScale(decimals, RoundingMode.HALF_EVEN).doubleValue();
        return Math.abs(rounded - value) <= size * 1e-13 ? rounded : value;
    }
}
