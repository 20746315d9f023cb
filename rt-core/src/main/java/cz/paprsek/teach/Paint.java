package cz.paprsek.teach;

import static cz.paprsek.teach.mistake.Mistake.CHECKER_CONSTANT;
import static cz.paprsek.teach.mistake.Mistake.CHECKER_SWAPPED;
import static cz.paprsek.teach.mistake.Mistake.CHECKER_TRUNCATED;
import static cz.paprsek.teach.mistake.Mistake.COLORS_NOT_DECODED;

import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.List;

/** What a primitive is made of, and its colour at each point. */
final class Paint {
    /** What a point on the border of two cells is moved by, in cells, so that rounding does not speckle it. */
    private static final double NUDGE = 1e-10;
    private static final double ROUNDING = 2e-15;

    final Material material;
    private final Affine toCells;
    private final double rounding;
    private final Vec even;
    private final Vec odd;
    private final Mistakes made;

    /** @param toDeclared from the world to the space of the object that declares the material */
    Paint(Material material, Affine toDeclared, Mistakes made) {
        this.material = material;
        this.made = made;
        this.toCells = material.pattern() instanceof Pattern.Checker cubes ? cells(cubes, toDeclared) : Affine.IDENTITY;
        this.rounding = ROUNDING * Math.max(toCells.direction(Vec3.X).length(), Math.max(toCells.direction(Vec3.Y).length(), toCells.direction(Vec3.Z).length()));
        List<Rgb> palette = material.pattern().palette();
        this.even = light(palette.get(0), made);
        this.odd = light(palette.get(palette.size() - 1), made);
    }

    private static Affine cells(Pattern.Checker cubes, Affine toDeclared) {
        Affine toOwn = cubes.lay().equals(Pattern.Lay.NONE) ? toDeclared : cubes.lay().toParent().inverse().after(toDeclared);
        return Affine.scaling(new Vec3(1 / cubes.size().x(), 1 / cubes.size().y(), 1 / cubes.size().z()))
                .after(Affine.translation(cubes.origin().negated())).after(toOwn);
    }

    /** The colour at a point, in linear light. */
    Vec color(Primitive primitive, Vec point, double size) {
        if (material.pattern() instanceof Pattern.Checkerboard board) {
            return isOdd(board, primitive.place(point)) ? odd : even;
        }
        return material.pattern() instanceof Pattern.Checker && isOdd(point.through(toCells), size) ? odd : even;
    }

    static Vec light(Rgb color, Mistakes made) {
        return made.has(COLORS_NOT_DECODED) ? new Vec(color.red() / 255, color.green() / 255, color.blue() / 255) : Vec.light(color);
    }

    private boolean isOdd(Pattern.Checkerboard board, double[] place) {
        double u = made.has(CHECKER_CONSTANT) ? 1 : place[0];
        double v = made.has(CHECKER_CONSTANT) ? 1 : place[1];
        int column = Math.min((int) (u * board.columns()), board.columns() - 1);
        int row = Math.min((int) (v * board.rows()), board.rows() - 1);
        return (column + row) % 2 != 0 != made.has(CHECKER_SWAPPED);
    }

    private boolean isOdd(Vec cell, double size) {
        double nudge = Math.max(rounding * size, NUDGE);
        double sum = made.has(CHECKER_CONSTANT) ? 0 : whole(cell.x() + nudge) + whole(cell.y() + nudge) + whole(cell.z() + nudge);
        return sum != 2 * Math.floor(sum / 2) != made.has(CHECKER_SWAPPED);
    }

    private double whole(double number) {
        return made.has(CHECKER_TRUNCATED) ? (long) number : Math.floor(number);
    }
}
