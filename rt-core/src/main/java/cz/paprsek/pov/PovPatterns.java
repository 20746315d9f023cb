package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;
import static cz.paprsek.text.Numbers.text;

import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.texture.LatticeNoise;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.text.MadeInCode;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;

/** Patterns in POV-Ray's words, of colours or of anything else that each colour stands for: its own where they mean the same, else functions. */
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
    static final double HIGH = 1e6;

    private final Function<Rgb, String> entry;
    private final String map;

    private PovPatterns(Function<Rgb, String> entry, String map) {
        this.entry = entry;
        this.map = map;
    }

    /** Of colours, of which each lets through a share of light. */
    static PovPatterns ofColors(double transmit) {
        return new PovPatterns(color -> PovMaterials.rgb(color, 1) + (transmit > 0 ? " transmit " + text(transmit) : ""), "color_map");
    }

    /** Of what stands in a texture, for each colour another. */
    static PovPatterns ofTextures(Function<Rgb, String> body) {
        return new PovPatterns(body, "texture_map");
    }

    /** Whether it can be written: not pictures here, and nothing made in code. */
    static boolean isTold(Pattern pattern) {
        return !pattern.palette().isEmpty();
    }

    /** Whether {@link #NOISE} must come before. */
    static boolean isNoise(Pattern pattern) {
        return pattern instanceof Pattern.Marble || pattern instanceof Pattern.Wood || pattern instanceof Pattern.Granite || pattern instanceof Pattern.Noise;
    }

    /** What stands in a pigment, for any pattern but a checkerboard. */
    String pigment(Pattern pattern) {
        if (pattern instanceof Pattern.Plain plain) {
            return entry.apply(plain.color());
        } else if (pattern instanceof Pattern.Checker checker) {
            return cells(checker.even(), checker.odd()) + " scale " + (isEven(checker.size()) ? text(checker.size().x()) : vector(checker.size()))
                    + (checker.origin().equals(Vec3.ZERO) ? "" : " translate " + vector(checker.origin())) + laid(checker.lay());
        } else if (pattern instanceof Pattern.Stripes stripes) {
            return cells(stripes.even(), stripes.odd()) + " scale " + vector(stripes.size(), HIGH, HIGH) + " translate " + vector(0, -HIGH / 2, -HIGH / 2)
                    + laid(stripes.lay());
        } else if (pattern instanceof Pattern.Brick brick) {
            return "brick " + entry.apply(brick.odd()) + " " + entry.apply(brick.even()) + " brick_size " + vector(brick.size()) + " mortar " + text(brick.mortar())
                    + laid(brick.lay());
        }
        return "function { " + function(pattern) + " } " + entries(pattern) + laid(lay(pattern));
    }

    /** As {@link #pigment}, also of a checkerboard; whatever stands for the colours stays where it is. */
    String around(Pattern pattern, Shape shape) {
        String function = pattern instanceof Pattern.Checkerboard board ? squares(board, area(shape)) : PovBumps.within(function(pattern), lay(pattern), PovBumps.ANYWHERE);
        return "function { " + function + " } " + entries(pattern);
    }

    private String entries(Pattern pattern) {
        return map + " { " + pattern.colors().stops().stream().map(stop -> "[" + text(stop.at()) + " " + entry.apply(stop.color()) + "]").collect(Collectors.joining(" ")) + " }";
    }

    /** Whether it is of two colours with edges between. */
    static boolean isOfCells(Pattern pattern) {
        return pattern instanceof Pattern.Checker || pattern instanceof Pattern.Stripes || pattern instanceof Pattern.Brick || pattern instanceof Pattern.Checkerboard;
    }

    /** The value of a pattern as a function in its own space; of one of cells 0 for the even ones, and 1 for the odd ones. */
    static String function(Pattern pattern) {
        if (pattern instanceof Pattern.Gradient) {
            return "min(1, max(0, y))";
        } else if (pattern instanceof Pattern.Marble marble) {
            return "1 - abs(2*mod(mod(" + text(marble.frequency()) + "*x + " + text(marble.turbulence()) + "*(" + sum(marble.octaves(), marble.seed(), false)
                    + "), 1) + 1, 1) - 1)";
        } else if (pattern instanceof Pattern.Wood wood) {
            return "mod(mod(" + text(wood.frequency()) + "*sqrt(x*x + z*z) + " + text(wood.turbulence()) + "*(" + sum(wood.octaves(), wood.seed(), false)
                    + "), 1) + 1, 1)";
        } else if (pattern instanceof Pattern.Granite granite) {
            return "min(1, " + sum(granite.octaves(), granite.seed(), true) + ")";
        } else if (pattern instanceof Pattern.Noise noise) {
            return "min(1, max(0, 0.5 + 0.5*(" + sum(noise.octaves(), noise.seed(), false) + ")))";
        } else if (pattern instanceof Pattern.Checker checker) {
            Vec3 size = checker.size();
            Vec3 origin = checker.origin();
            return "mod(abs(" + floor("x", origin.x(), size.x()) + " + " + floor("y", origin.y(), size.y()) + " + " + floor("z", origin.z(), size.z()) + "), 2)";
        } else if (pattern instanceof Pattern.Stripes stripes) {
            return "mod(abs(" + floor("x", 0, stripes.size()) + "), 2)";
        } else if (pattern instanceof Pattern.Brick brick) {
            String shift = "0.5*mod(abs(" + floor("y", 0, brick.size().y()) + "), 2)";
            return "max(" + mortar("y/" + text(brick.size().y()), brick.mortar() / brick.size().y()) + ", max("
                    + mortar("x/" + text(brick.size().x()) + " + " + shift, brick.mortar() / brick.size().x()) + ", "
                    + mortar("z/" + text(brick.size().z()) + " + 0.5 - " + shift, brick.mortar() / brick.size().z()) + "))";
        }
        throw MadeInCode.refusedBy("a scene for POV-Ray", pattern.kind(), "pattern");
    }

    /** 1 where mortar ends a cell. */
    private static String mortar(String place, double share) {
        return "select(" + place + " + 1e-10 - floor(" + place + " + 1e-10) - " + text(1 - share) + ", 0, 1)";
    }

    private static String squares(Pattern.Checkerboard board, Rectangle area) {
        return "mod(abs(" + floor("x", area.minX(), (area.maxX() - area.minX()) / board.columns()) + " + "
                + floor("y", area.minY(), (area.maxY() - area.minY()) / board.rows()) + "), 2)";
    }

    /** How a pattern in space lies. */
    static Pattern.Lay lay(Pattern pattern) {
        return pattern instanceof Pattern.Gradient gradient ? gradient.lay() : pattern instanceof Pattern.Marble marble ? marble.lay()
                : pattern instanceof Pattern.Wood wood ? wood.lay() : pattern instanceof Pattern.Granite granite ? granite.lay()
                : pattern instanceof Pattern.Checker checker ? checker.lay() : pattern instanceof Pattern.Stripes stripes ? stripes.lay()
                : pattern instanceof Pattern.Brick brick ? brick.lay() : ((Pattern.Noise) pattern).lay();
    }

    private static String floor(String coordinate, double origin, double size) {
        return "floor((" + coordinate + " - " + text(origin) + ")/" + text(size) + " + 1e-10)";
    }

    String board(Pattern.Checkerboard board, Shape shape) {
        Rectangle area = area(shape);
        return cells(board.even(), board.odd())
                + " scale " + vector((area.maxX() - area.minX()) / board.columns(), (area.maxY() - area.minY()) / board.rows(), HIGH)
                + " translate " + vector(area.minX(), area.minY(), -HIGH / 2);
    }

    private static Rectangle area(Shape shape) {
        return shape instanceof Disc disc ? new Rectangle(-disc.radius(), -disc.radius(), disc.radius(), disc.radius()) : (Rectangle) shape;
    }

    private String cells(Rgb even, Rgb odd) {
        return "checker " + entry.apply(even) + " " + entry.apply(odd);
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
}
