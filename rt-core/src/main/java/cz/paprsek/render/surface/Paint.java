package cz.paprsek.render.surface;

import cz.paprsek.material.CustomPattern;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.text.Numbers;

/** A pattern ready to be asked for its colour at a point. */
public abstract class Paint {
    private final boolean mapped;

    private Paint(Pattern pattern) {
        this.mapped = pattern.isMapped();
    }

    /** @param toPattern from the world to the space the pattern is stated in */
    public static Paint of(Pattern pattern, Affine toPattern) {
        if (pattern instanceof Pattern.Checkerboard board) {
            return new Board(board);
        }
        if (pattern instanceof Pattern.Checker checker) {
            return new Cubes(checker, toPattern);
        }
        return pattern instanceof CustomPattern custom ? new Custom(custom, toPattern) : new Plain((Pattern.Plain) pattern);
    }

    /** Whether its colours depend on where in space the pattern is declared. */
    public static boolean isPlaced(Pattern pattern) {
        return pattern instanceof Pattern.Checker || pattern instanceof CustomPattern;
    }

    /** Whether it asks for the map of the hit: u, v and the tangent. */
    public final boolean isMapped() {
        return mapped;
    }

    /** Writes the colour at the level's hit into the level, linear light. */
    public abstract void color(Level level);

    /** Two colours in linear light, and which of them lies where. */
    private abstract static class TwoColors extends Paint {
        private final double[] linear;

        TwoColors(Pattern pattern, Rgb even, Rgb odd) {
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
    }

    private static final class Plain extends TwoColors {
        Plain(Pattern.Plain plain) {
            super(plain, plain.color(), plain.color());
        }

        @Override
        boolean isOdd(Hit hit) {
            return false;
        }
    }

    private static final class Board extends TwoColors {
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

    private static final class Cubes extends TwoColors {
        /** What a face lying on a boundary between cells is moved by at least, in cells, so that rounding does not speckle it. */
        private static final double NUDGE = 1e-10;
        /** How far rounding moves a point, relative to the numbers behind it. */
        private static final double ROUNDING = 2e-15;

        private final Affine toCells;
        private final double rounding;

        Cubes(Pattern.Checker checker, Affine toPattern) {
            super(checker, checker.even(), checker.odd());
            double k = 1 / checker.size();
            toCells = Affine.scaling(Vec3.ONE.times(k))
                    .after(Affine.translation(checker.origin().negated()))
                    .after(toPattern);
            rounding = ROUNDING * Math.max(toCells.direction(Vec3.X).length(),
                    Math.max(toCells.direction(Vec3.Y).length(), toCells.direction(Vec3.Z).length()));
        }

        @Override
        boolean isOdd(Hit hit) {
            double nudge = rounding * hit.size > NUDGE ? rounding * hit.size : NUDGE;
            double cells = Math.floor(toCells.pointX(hit.px, hit.py, hit.pz) + nudge)
                    + Math.floor(toCells.pointY(hit.px, hit.py, hit.pz) + nudge)
                    + Math.floor(toCells.pointZ(hit.px, hit.py, hit.pz) + nudge);
            // Not cells % 2: the remainder of doubles is slow.
            return cells != 2 * Math.floor(cells / 2);
        }
    }

    private static final class Custom extends Paint {
        /** More would not be finite once it is lit. */
        private static final double BRIGHTEST = 1e20;

        private final CustomPattern pattern;
        private final Affine toPattern;

        Custom(CustomPattern pattern, Affine toPattern) {
            super(pattern);
            this.pattern = pattern;
            this.toPattern = toPattern;
        }

        @Override
        public void color(Level level) {
            Hit hit = level.hit;
            pattern.color(toPattern.pointX(hit.px, hit.py, hit.pz), toPattern.pointY(hit.px, hit.py, hit.pz), toPattern.pointZ(hit.px, hit.py, hit.pz), hit);
            // Also false for what is not a number.
            if (!(Math.abs(hit.red) <= BRIGHTEST && Math.abs(hit.green) <= BRIGHTEST && Math.abs(hit.blue) <= BRIGHTEST)) {
                throw new IllegalStateException("the pattern \"" + pattern.kind() + "\", which is made in code, has the colour " + hit.red + " " + hit.green + " " + hit.blue
                        + " at " + Numbers.text(new Vec3(hit.px, hit.py, hit.pz)) + " in the world; it must be of finite numbers");
            }
            level.colorRed = hit.red;
            level.colorGreen = hit.green;
            level.colorBlue = hit.blue;
        }
    }
}
