package cz.paprsek.render.surface;

import cz.paprsek.material.Pattern;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;

/** Two colours, and which of them lies where. */
abstract class TwoColors extends Paint {
    /** What a face lying on a boundary between cells is moved by at least, in cells, so that rounding does not speckle it. */
    private static final double NUDGE = 1e-10;
    /** How far rounding moves a point, relative to the numbers behind it. */
    private static final double ROUNDING = 2e-15;

    /** As bumps, an edge between two colours is a slope: on each side of it this share of a cell. */
    private static final double EDGE = 0x1p-5;

    private final double[] channels;

    private TwoColors(Pattern pattern, boolean isLight) {
        super(pattern);
        this.channels = channels(pattern.palette(), isLight);
    }

    /** How much the luminance of the odd colour is above that of the even one. */
    final double rise() {
        return luminance(channels, 3) - luminance(channels, 0);
    }

    /** Whether the odd colour lies at the hit. */
    abstract boolean isOdd(Hit hit);

    @Override
    public final void color(Level level) {
        int i = isOdd(level.hit) ? 3 : 0;
        level.colorRed = channels[i];
        level.colorGreen = channels[i + 1];
        level.colorBlue = channels[i + 2];
    }

    static final class Plain extends TwoColors {
        Plain(Pattern.Plain plain, boolean isLight) {
            super(plain, isLight);
        }

        @Override
        boolean isOdd(Hit hit) {
            return false;
        }

        @Override
        void slope(Level level) {
            toWorld(Affine.IDENTITY, 0, 0, 0, level.slope);
        }
    }

    static final class Board extends TwoColors {
        private final int columns;
        private final int rows;
        private final Mapping mapping = Mapping.of(Pattern.Mapping.UV, Affine.IDENTITY, Affine.IDENTITY);

        Board(Pattern.Checkerboard board, boolean isLight) {
            super(board, isLight);
            columns = board.columns();
            rows = board.rows();
        }

        /** The far edges belong to the last square, not to one beyond it. */
        @Override
        boolean isOdd(Hit hit) {
            int column = Math.min((int) (hit.u * columns), columns - 1);
            int row = Math.min((int) (hit.v * rows), rows - 1);
            return (column + row) % 2 != 0;
        }

        @Override
        void slope(Level level) {
            level.chart.lay(level, mapping);
            double du = Math.max(EDGE / columns, level.chart.wideU() / 2);
            double dv = Math.max(EDGE / rows, level.chart.wideV() / 2);
            double alongU = (height(level, du, 0) - height(level, -du, 0)) / (2 * du);
            double alongV = (height(level, 0, dv) - height(level, 0, -dv)) / (2 * dv);
            level.chart.slope(rise() * alongU, rise() * alongV, level.slope);
        }

        private double height(Level level, double du, double dv) {
            level.probe.u = Math.min(1, Math.max(0, level.hit.u + du));
            level.probe.v = Math.min(1, Math.max(0, level.hit.v + dv));
            return isOdd(level.probe) ? 1 : 0;
        }
    }

    /** Patterns of cells in space. */
    private abstract static class Cells extends TwoColors {
        final Affine toCells;
        private final Affine toWorld;
        /** How wide the slope of an edge across x, y and z is on each side of it, in cells; 0 where there is none. */
        private final double[] edges;
        private final double rounding;

        Cells(Pattern pattern, boolean isLight, Affine toCells, double... edges) {
            super(pattern, isLight);
            this.toCells = toCells;
            this.toWorld = toCells.inverse();
            this.edges = edges;
            rounding = ROUNDING * Math.max(toCells.direction(Vec3.X).length(),
                    Math.max(toCells.direction(Vec3.Y).length(), toCells.direction(Vec3.Z).length()));
        }

        final double nudge(Hit hit) {
            return rounding * hit.size > NUDGE ? rounding * hit.size : NUDGE;
        }

        /** By differences over the slopes of the edges, or over what a pixel covers if that is wider. */
        @Override
        final void slope(Level level) {
            double x = slope(level, 0, toWorld.xx(), toWorld.yx(), toWorld.zx());
            double y = slope(level, 1, toWorld.xy(), toWorld.yy(), toWorld.zy());
            double z = slope(level, 2, toWorld.xz(), toWorld.yz(), toWorld.zz());
            toWorld(toCells, rise() * x, rise() * y, rise() * z, level.slope);
        }

        private double slope(Level level, int axis, double x, double y, double z) {
            double step = edges[axis];
            for (int i = 0; i < 6 && step > 0; i += 3) {
                double[] beside = level.footprint.point;
                double covered = axis == 0 ? toCells.directionX(beside[i], beside[i + 1], beside[i + 2])
                        : axis == 1 ? toCells.directionY(beside[i], beside[i + 1], beside[i + 2]) : toCells.directionZ(beside[i], beside[i + 1], beside[i + 2]);
                step = Math.max(step, Math.abs(covered) / 2);
            }
            return step > 0 ? (height(level, step, x, y, z) - height(level, -step, x, y, z)) / (2 * step) : 0;
        }

        private double height(Level level, double step, double x, double y, double z) {
            Hit probe = level.probe;
            probe.px = level.hit.px + step * x;
            probe.py = level.hit.py + step * y;
            probe.pz = level.hit.pz + step * z;
            probe.size = level.hit.size;
            return isOdd(probe) ? 1 : 0;
        }

        static boolean isOdd(double cells) {
            // Not cells % 2: the remainder of doubles is slow.
            return cells != 2 * Math.floor(cells / 2);
        }
    }

    static final class Cubes extends Cells {
        Cubes(Pattern.Checker checker, Affine toDeclared, boolean isLight) {
            super(checker, isLight,
                    Affine.scaling(new Vec3(1 / checker.size().x(), 1 / checker.size().y(), 1 / checker.size().z()))
                            .after(Affine.translation(checker.origin().negated()))
                            .after(toOwn(checker.lay(), toDeclared)), EDGE, EDGE, EDGE);
        }

        @Override
        boolean isOdd(Hit hit) {
            double nudge = nudge(hit);
            return isOdd(Math.floor(toCells.pointX(hit.px, hit.py, hit.pz) + nudge)
                    + Math.floor(toCells.pointY(hit.px, hit.py, hit.pz) + nudge)
                    + Math.floor(toCells.pointZ(hit.px, hit.py, hit.pz) + nudge));
        }
    }

    static final class Layers extends Cells {
        Layers(Pattern.Stripes stripes, Affine toDeclared, boolean isLight) {
            super(stripes, isLight, Affine.scaling(Vec3.ONE.times(1 / stripes.size())).after(toOwn(stripes.lay(), toDeclared)), EDGE, 0, 0);
        }

        @Override
        boolean isOdd(Hit hit) {
            return isOdd(Math.floor(toCells.pointX(hit.px, hit.py, hit.pz) + nudge(hit)));
        }
    }

    /**
     * Bricks with their mortar are cells of 1.
     *
     * @source POV-Ray 3.7, pattern.cpp, brick_pattern
     */
    static final class Bricks extends Cells {
        /** On each side of a brick's edge this share of the mortar is a slope. */
        private static final double SLOPE = 0.25;

        /** Where in its cell a brick ends. */
        private final double endX;
        private final double endY;
        private final double endZ;

        Bricks(Pattern.Brick brick, Affine toDeclared, boolean isLight) {
            super(brick, isLight,
                    Affine.scaling(new Vec3(1 / brick.size().x(), 1 / brick.size().y(), 1 / brick.size().z())).after(toOwn(brick.lay(), toDeclared)),
                    SLOPE * brick.mortar() / brick.size().x(), SLOPE * brick.mortar() / brick.size().y(), SLOPE * brick.mortar() / brick.size().z());
            endX = 1 - brick.mortar() / brick.size().x();
            endY = 1 - brick.mortar() / brick.size().y();
            endZ = 1 - brick.mortar() / brick.size().z();
        }

        @Override
        boolean isOdd(Hit hit) {
            double nudge = nudge(hit);
            double y = toCells.pointY(hit.px, hit.py, hit.pz) + nudge;
            double course = Math.floor(y);
            double shift = isOdd(course) ? 0.5 : 0;
            double x = toCells.pointX(hit.px, hit.py, hit.pz) + nudge + shift;
            double z = toCells.pointZ(hit.px, hit.py, hit.pz) + nudge + 0.5 - shift;
            return y - course >= endY || x - Math.floor(x) >= endX || z - Math.floor(z) >= endZ;
        }
    }
}
