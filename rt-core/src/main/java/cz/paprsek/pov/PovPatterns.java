package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;
import static cz.paprsek.text.Numbers.text;

import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.surface.LatticeNoise;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.text.MadeInCode;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** Patterns in POV-Ray's words: its own where they mean the same, else functions. */
final class PovPatterns {
    /** The noise, as functions that patterns call. Parts of it have names of their own: a function there has no variables. */
    static final List<String> NOISE = List.of(
            "#declare Paprsek_P = function(a) { mod((34*a + 1)*a, 289) }",
            "#declare Paprsek_D = function(h, x, y, z) { (1 - 2*mod(h, 2))*select(h - 7.5, x, y) + (1 - 2*mod(floor(h/2), 2))*select(h - 3.5, y, z) }",
            "#declare Paprsek_S = function(i, j, k, x, y, z) { Paprsek_D(mod(Paprsek_P(Paprsek_P(i + j) + k), 12), x, y, z) }",
            "#declare Paprsek_F = function(a) { a*a*a*(a*(a*6 - 15) + 10) }",
            "#declare Paprsek_M = function(s, a, b) { a + s*(b - a) }",
            "#declare Paprsek_Y = function(i, j, k, x, y, z) { Paprsek_M(Paprsek_F(y), Paprsek_M(Paprsek_F(x), Paprsek_S(Paprsek_P(i), j, k, x, y, z), "
                    + "Paprsek_S(Paprsek_P(i + 1), j, k, x - 1, y, z)), Paprsek_M(Paprsek_F(x), Paprsek_S(Paprsek_P(i), j + 1, k, x, y - 1, z), "
                    + "Paprsek_S(Paprsek_P(i + 1), j + 1, k, x - 1, y - 1, z))) }",
            "#declare Paprsek_Z = function(i, j, k, x, y, z) { Paprsek_M(Paprsek_F(z), Paprsek_Y(i, j, k, x, y, z), Paprsek_Y(i, j, k + 1, x, y, z - 1)) }",
            "#declare Paprsek_W = function(a) { floor(a) - 289*floor(floor(a)/289) }",
            "#declare Paprsek_N = function(x, y, z, i, j, k) { Paprsek_Z(Paprsek_W(x) + i, Paprsek_W(y) + j, Paprsek_W(z) + k, "
                    + "x - floor(x), y - floor(y), z - floor(z)) }");

    /** As high as cells are made that have no end, in scene units, what lies there in their middle. */
    private static final double HIGH = 1e6;

    private final double transmit;

    /** @param transmit the share of light that every colour lets through */
    PovPatterns(double transmit) {
        this.transmit = transmit;
    }

    /** Whether {@link #NOISE} must come before. */
    static boolean isNoise(Pattern pattern) {
        return pattern instanceof Pattern.Marble || pattern instanceof Pattern.Wood || pattern instanceof Pattern.Granite || pattern instanceof Pattern.Noise;
    }

    /** What stands in a pigment, for any pattern but a checkerboard. */
    String pigment(Pattern pattern) {
        if (pattern instanceof Pattern.Plain plain) {
            return color(plain.color());
        } else if (pattern instanceof Pattern.Checker checker) {
            return cells(checker.even(), checker.odd()) + " scale " + (isEven(checker.size()) ? text(checker.size().x()) : vector(checker.size()))
                    + (checker.origin().equals(Vec3.ZERO) ? "" : " translate " + vector(checker.origin())) + laid(checker.lay());
        } else if (pattern instanceof Pattern.Stripes stripes) {
            return cells(stripes.even(), stripes.odd()) + " scale " + vector(stripes.size(), HIGH, HIGH) + " translate " + vector(0, -HIGH / 2, -HIGH / 2)
                    + laid(stripes.lay());
        } else if (pattern instanceof Pattern.Brick brick) {
            return "brick " + color(brick.odd()) + " " + color(brick.even()) + " brick_size " + vector(brick.size()) + " mortar " + text(brick.mortar())
                    + laid(brick.lay());
        } else if (pattern instanceof Pattern.Gradient gradient) {
            return values("min(1, max(0, y))", gradient.colors(), gradient.lay());
        } else if (pattern instanceof Pattern.Marble marble) {
            return values("1 - abs(2*mod(mod(" + text(marble.frequency()) + "*x + " + text(marble.turbulence()) + "*(" + sum(marble.octaves(), marble.seed(), false)
                    + "), 1) + 1, 1) - 1)", marble.colors(), marble.lay());
        } else if (pattern instanceof Pattern.Wood wood) {
            return values("mod(mod(" + text(wood.frequency()) + "*sqrt(x*x + z*z) + " + text(wood.turbulence()) + "*(" + sum(wood.octaves(), wood.seed(), false)
                    + "), 1) + 1, 1)", wood.colors(), wood.lay());
        } else if (pattern instanceof Pattern.Granite granite) {
            return values("min(1, " + sum(granite.octaves(), granite.seed(), true) + ")", granite.colors(), granite.lay());
        } else if (pattern instanceof Pattern.Noise noise) {
            return values("min(1, max(0, 0.5 + 0.5*(" + sum(noise.octaves(), noise.seed(), false) + ")))", noise.colors(), noise.lay());
        }
        throw MadeInCode.refusedBy("a scene for POV-Ray", pattern.kind(), "pattern");
    }

    String board(Pattern.Checkerboard board, Shape shape) {
        Rectangle area = shape instanceof Disc disc
                ? new Rectangle(-disc.radius(), -disc.radius(), disc.radius(), disc.radius())
                : (Rectangle) shape;
        return cells(board.even(), board.odd())
                + " scale " + vector((area.maxX() - area.minX()) / board.columns(), (area.maxY() - area.minY()) / board.rows(), HIGH)
                + " translate " + vector(area.minX(), area.minY(), -HIGH / 2);
    }

    private String cells(Rgb even, Rgb odd) {
        return "checker " + color(even) + " " + color(odd);
    }

    private String values(String function, Pattern.Colors colors, Pattern.Lay lay) {
        return "function { " + function + " } color_map { " + colors.stops().stream().map(stop -> "[" + text(stop.at()) + " " + color(stop.color()) + "]")
                .collect(Collectors.joining(" ")) + " }" + laid(lay);
    }

    private static String sum(int octaves, int seed, boolean ofSizes) {
        LatticeNoise noise = new LatticeNoise(octaves, seed);
        List<String> terms = new ArrayList<>();
        for (int i = 0; i < octaves; i++) {
            double factor = 1L << i;
            String term = "Paprsek_N(" + (i == 0 ? "x, y, z" : text(factor) + "*x, " + text(factor) + "*y, " + text(factor) + "*z") + ", "
                    + noise.shift(i, 0) + ", " + noise.shift(i, 1) + ", " + noise.shift(i, 2) + ")";
            terms.add((ofSizes ? "abs(" + term + ")" : term) + (i == 0 ? "" : "/" + text(factor)));
        }
        return String.join(" + ", terms);
    }

    /** What places a pattern, after a blank. */
    static String laid(Pattern.Lay lay) {
        return (lay.scale().equals(Vec3.ONE) ? "" : " scale " + (isEven(lay.scale()) ? text(lay.scale().x()) : vector(lay.scale())))
                + (lay.rotation().equals(Vec3.ZERO) ? "" : " rotate " + vector(lay.rotation()))
                + (lay.position().equals(Vec3.ZERO) ? "" : " translate " + vector(lay.position()));
    }

    private static boolean isEven(Vec3 scale) {
        return scale.x() == scale.y() && scale.x() == scale.z();
    }

    private String color(Rgb color) {
        return PovMaterials.rgb(color, 1) + (transmit > 0 ? " transmit " + text(transmit) : "");
    }
}
