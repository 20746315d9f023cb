package cz.paprsek.format.openscad;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Solid;
import java.util.Optional;

/**
 * Maps as placements. Files have six digits: angles are rounded to 1/10 000 of a degree, and scales to six digits. A map that cannot be one scale, turn and move is
 * a turn, a scale, a turn and a move, of one body within another.
 */
final class Placing {
    /** How far from perpendicular axes may be that were meant to be, with six digits each. */
    private static final double SLACK = 2e-5;

    private Placing() {}

    /** The solid where a map puts it; nothing if it flattens it. */
    static Optional<Operand> placed(Solid solid, Affine map) {
        if (!map.isSane()) {
            return Optional.empty();
        }
        Optional<Placement> simple = of(map);
        if (simple.isPresent()) {
            return Optional.of(Operand.of(solid).placed(simple.get()));
        }
        double[][] turn = turnToAxes(map);
        Affine first = new Affine(turn[0][0], turn[1][0], turn[2][0], 0, turn[0][1], turn[1][1], turn[2][1], 0, turn[0][2], turn[1][2], turn[2][2], 0);
        Affine back = new Affine(turn[0][0], turn[0][1], turn[0][2], 0, turn[1][0], turn[1][1], turn[1][2], 0, turn[2][0], turn[2][1], turn[2][2], 0);
        Placement inner = of(first).orElseThrow();
        Optional<Placement> outer = of(map.after(back));
        return outer.map(placement -> Operand.of(Csg.union(Operand.of(solid).placed(inner))).placed(placement));
    }

    /** A map as scale, turn and move, if its axes are perpendicular. */
    static Optional<Placement> of(Affine m) {
        double x = length(m.xx(), m.yx(), m.zx());
        double y = length(m.xy(), m.yy(), m.zy());
        double z = length(m.xz(), m.yz(), m.zz());
        boolean isPerpendicular = Math.abs(m.xx() * m.xy() + m.yx() * m.yy() + m.zx() * m.zy()) <= SLACK * x * y
                && Math.abs(m.xx() * m.xz() + m.yx() * m.yz() + m.zx() * m.zz()) <= SLACK * x * z
                && Math.abs(m.xy() * m.xz() + m.yy() * m.yz() + m.zy() * m.zz()) <= SLACK * y * z;
        if (!isPerpendicular) {
            return Optional.empty();
        }
        double determinant = m.xx() * (m.yy() * m.zz() - m.yz() * m.zy()) - m.xy() * (m.yx() * m.zz() - m.yz() * m.zx()) + m.xz() * (m.yx() * m.zy() - m.yy() * m.zx());
        double sx = determinant < 0 ? -x : x;
        return Optional.of(new Placement(new Vec3(m.xt(), m.yt(), m.zt()), angles(m, sx, y, z), new Vec3(sixDigits(sx), sixDigits(y), sixDigits(z))));
    }

    private static Vec3 angles(Affine m, double sx, double sy, double sz) {
        double xx = m.xx() / sx;
        double yx = m.yx() / sx;
        double zx = m.zx() / sx;
        double cosine = Math.sqrt(xx * xx + yx * yx);
        if (cosine < SLACK) {
            return new Vec3(degrees(-m.yz() / sz, m.yy() / sy), zx > 0 ? -90 : 90, 0);
        }
        return new Vec3(degrees(m.zy() / sy, m.zz() / sz), degrees(-zx, cosine), degrees(yx, xx));
    }

    private static double degrees(double sine, double cosine) {
        double rounded = Math.rint(StrictMath.toDegrees(StrictMath.atan2(sine, cosine)) * 1e4) / 1e4;
        return rounded == 0 ? 0 : rounded;
    }

    private static double length(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }

    private static double sixDigits(double value) {
        double power = 1;
        double size = Math.abs(value);
        while (size * power < 1e5 && power < 1e20) {
            power *= 10;
        }
        double rounded = Math.rint(value * power) / power;
        return rounded == 0 || size > 1e6 ? value : rounded;
    }

    /**
     * A turn whose columns become perpendicular: the eigenvectors of MᵀM.
     *
     * @source Jacobi, Über ein leichtes Verfahren, die in der Theorie der Säcularstörungen vorkommenden Gleichungen numerisch aufzulösen, Crelle 30, 1846
     */
    private static double[][] turnToAxes(Affine m) {
        double[][] rows = {{m.xx(), m.xy(), m.xz()}, {m.yx(), m.yy(), m.yz()}, {m.zx(), m.zy(), m.zz()}};
        double[][] a = new double[3][3];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                a[i][j] = rows[0][i] * rows[0][j] + rows[1][i] * rows[1][j] + rows[2][i] * rows[2][j];
            }
        }
        double[][] v = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (int round = 0; round < 30; round++) {
            turn(a, v, 0, 1);
            turn(a, v, 0, 2);
            turn(a, v, 1, 2);
        }
        return v;
    }

    private static void turn(double[][] a, double[][] v, int p, int q) {
        if (a[p][q] == 0) {
            return;
        }
        double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        double t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
        double c = 1 / Math.sqrt(t * t + 1);
        double s = t * c;
        for (int k = 0; k < 3; k++) {
            double left = a[k][p];
            double right = a[k][q];
            a[k][p] = c * left - s * right;
            a[k][q] = s * left + c * right;
        }
        for (int k = 0; k < 3; k++) {
            double left = a[p][k];
            double right = a[q][k];
            a[p][k] = c * left - s * right;
            a[q][k] = s * left + c * right;
            left = v[k][p];
            right = v[k][q];
            v[k][p] = c * left - s * right;
            v[k][q] = s * left + c * right;
        }
    }
}
