package cz.paprsek.render.surface;

import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;

/** Two colours in linear light, and which of them lies where. */
abstract class TwoColors extends Paint {
    /** What a face lying on a boundary between cells is moved by at least, in cells, so that rounding does not speckle it. */
    private static final double NUDGE = 1e-10;
    /** How far rounding moves a point, relative to the numbers behind it. */
    private static final double ROUNDING = 2e-15;

    private final double[] linear;

    private TwoColors(Pattern pattern, Rgb even, Rgb odd) {
        super(pattern);
        this.linear = new double[] {
            even.linearRed(), even.linearGreen(), even.linearBlue(), odd.linearRed(), odd.linearGreen(), odd.linearBlue()
        };
    }

    /** Whether the odd colour lies at the hit. */
    abstract boolean isOdd(Hit hit);

    @Override
    public final void color(Level level) {
        int i = isOdd(level.hit) ? 3 : 0;
        level.colorRed = linear[i];
        level.colorGreen = linear[i + 1];
        level.colorBlue = linear[i + 2];
    }

    static final class Plain extends TwoColors {
        Plain(Pattern.Plain plain) {
            super(plain, plain.color(), plain.color());
        }

        @Override
        boolean isOdd(Hit hit) {
            return false;
        }
    }

    static final class Board extends TwoColors {
        private final int columns;
        private final int rows;

        Board(Pattern.Checkerboard board) {
            super(board, board.even(), board.odd());
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
    }

    /** Patterns of cells in space. */
    private abstract static class Cells extends TwoColors {
        final Affine toCells;
        private final double rounding;

        Cells(Pattern pattern, Rgb even, Rgb odd, Affine toCells) {
            super(pattern, even, odd);
            this.toCells = toCells;
            rounding = ROUNDING * Math.max(toCells.direction(Vec3.X).length(),
                    Math.max(toCells.direction(Vec3.Y).length(), toCells.direction(Vec3.Z).length()));
        }

        final double nudge(Hit hit) {
            return rounding * hit.size > NUDGE ? rounding * hit.size : NUDGE;
        }

        static boolean isOdd(double cells) {
            // Not cells % 2: the remainder of doubles is slow.
            return cells != 2 * Math.floor(cells / 2);
        }
    }

    static final class Cubes extends Cells {
        Cubes(Pattern.Checker checker, Affine toDeclared) {
            super(checker, checker.even(), checker.odd(),
                    Affine.scaling(new Vec3(1 / checker.size().x(), 1 / checker.size().y(), 1 / checker.size().z()))
                            .after(Affine.translation(checker.origin().negated()))
                            .after(toOwn(checker.lay(), toDeclared)));
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
        Layers(Pattern.Stripes stripes, Affine toDeclared) {
            super(stripes, stripes.even(), stripes.odd(),
                    Affine.scaling(Vec3.ONE.times(1 / stripes.size())).after(toOwn(stripes.lay(), toDeclared)));
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
        /** Where in its cell a brick ends. */
        private final double endX;
        private final double endY;
        private final double endZ;

        Bricks(Pattern.Brick brick, Affine toDeclared) {
            super(brick, brick.even(), brick.odd(),
                    Affine.scaling(new Vec3(1 / brick.size().x(), 1 / brick.size().y(), 1 / brick.size().z())).after(toOwn(brick.lay(), toDeclared)));
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
