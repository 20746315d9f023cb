package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;
import static cz.paprsek.text.Numbers.text;

import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Bump;
import cz.paprsek.material.Material.NormalMap;
import cz.paprsek.material.Material.Relief;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share.ColorChannel;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Bumps in POV-Ray's words. Its amount of a bump is 7.5 times the height: found by trying. */
final class PovBumps {
    private static final double AMOUNT = 7.5;
    /** How far apart POV-Ray looks for slopes, where ours are exact. */
    private static final double NEAR = 1e-4;

    /** A point, wherever it is. */
    static final String[] ANYWHERE = {"x", "y", "z"};

    private PovBumps() {}

    /** What stands in a texture, after a blank. */
    static String normal(Relief relief, Shape shape) {
        if (!(relief instanceof Bump bump) || !isTold(relief)) {
            return "";
        }
        double amount = AMOUNT * bump.strength();
        return " normal { " + (hasEdges(relief) ? cells(bump.pattern(), amount)
                : "function { " + height(bump.pattern(), onto(shape).orElse(ANYWHERE)) + " } " + text(amount) + " accuracy " + text(NEAR)) + " }";
    }

    private static boolean isTold(Relief relief) {
        return relief instanceof Bump bump && PovPatterns.isTold(bump.pattern()) && !(bump.pattern() instanceof Pattern.Checkerboard);
    }

    private static boolean hasEdges(Relief relief) {
        return relief instanceof Bump bump && isTold(relief) && PovPatterns.isOfCells(bump.pattern());
    }

    /** What POV-Ray will show otherwise, in words that follow the name of the object. */
    static List<String> lost(Material material, Shape shape) {
        List<String> lost = new ArrayList<>();
        Relief relief = material.relief();
        if (relief instanceof NormalMap) {
            lost.add("POV-Ray is not told the normal-map of its material");
        } else if (relief instanceof Bump && !isTold(relief)) {
            lost.add("POV-Ray is not told the bump of its material, which goes by a picture or a checkerboard");
        } else if (hasEdges(relief)) {
            lost.add("the edges of its bumps are of a slightly different form in POV-Ray");
        } else if (relief instanceof Bump && onto(shape).isEmpty()) {
            lost.add("POV-Ray counts the slope of its bumps across the surface, too");
        }
        if (isTold(relief) && (material.transparency() > 0 || !shape.hasInside())) {
            lost.add("POV-Ray turns its bumps round where they are met from " + (shape.hasInside() ? "within" : "behind"));
        }
        return lost;
    }

    /** The point of a surface that is nearest to one beside it. */
    private static Optional<String[]> onto(Shape shape) {
        if (shape instanceof Sphere ball) {
            String factor = "(" + text(ball.radius()) + "/sqrt(x*x + y*y + z*z))*";
            return Optional.of(new String[] {factor + "x", factor + "y", factor + "z"});
        } else if (shape instanceof Rectangle || shape instanceof Disc) {
            return Optional.of(new String[] {"x", "y", "0"});
        }
        return shape instanceof Plane ? Optional.of(new String[] {"x", "0", "z"}) : Optional.empty();
    }

    private static double luminance(Rgb color) {
        return ColorChannel.LUMINANCE.of(color);
    }

    /** The height in the space of the object: POV-Ray would scale bumps as it scales the pattern. */
    private static String height(Pattern pattern, String[] point) {
        List<Pattern.Stop> stops = pattern.colors().stops();
        String value = PovPatterns.function(pattern);
        StringBuilder height = new StringBuilder(text(luminance(stops.get(0).color())));
        for (int i = 1; i < stops.size(); i++) {
            double from = stops.get(i - 1).at();
            double width = stops.get(i).at() - from;
            double rise = luminance(stops.get(i).color()) - luminance(stops.get(i - 1).color());
            height.append(" + ").append(text(rise)).append(width > 0 ? "*min(1, max(0, ((" + value + ") - " + text(from) + ")/" + text(width) + "))"
                    : "*select((" + value + ") - " + text(from) + ", 0, 1)");
        }
        return within(height.toString(), PovPatterns.lay(pattern), point);
    }

    /** A function of a point in the space of a pattern, as one of a point in the space around it. */
    static String within(String function, Pattern.Lay lay, String[] point) {
        Affine map = lay.toParent().inverse();
        String[] inside = lay.equals(Pattern.Lay.NONE) ? point : new String[] {
            sum(point, map.xx(), map.xy(), map.xz(), map.xt()), sum(point, map.yx(), map.yy(), map.yz(), map.yt()), sum(point, map.zx(), map.zy(), map.zz(), map.zt())};
        StringBuilder written = new StringBuilder();
        for (int i = 0; i < function.length(); i++) {
            char c = function.charAt(i);
            boolean isAlone = c >= 'x' && c <= 'z' && (i == 0 || !isWord(function.charAt(i - 1))) && (i + 1 == function.length() || !isWord(function.charAt(i + 1)));
            written.append(isAlone ? "(" + inside[c - 'x'] + ")" : String.valueOf(c));
        }
        return written.toString();
    }

    private static String sum(String[] point, double x, double y, double z, double constant) {
        return text(x) + "*" + point[0] + " + " + text(y) + "*" + point[1] + " + " + text(z) + "*" + point[2] + " + " + text(constant);
    }

    private static boolean isWord(char c) {
        return Character.isLetterOrDigit(c) || c == '_';
    }

    private static String cells(Pattern pattern, double amount) {
        List<Rgb> palette = pattern.palette();
        String rise = text(amount * (luminance(palette.get(1)) - luminance(palette.get(0))));
        String fall = text(amount * (luminance(palette.get(0)) - luminance(palette.get(1))));
        if (pattern instanceof Pattern.Brick brick) {
            return "brick " + fall + " brick_size " + vector(brick.size()) + " mortar " + text(brick.mortar()) + " accuracy " + text(brick.mortar() / 4)
                    + PovPatterns.laid(brick.lay()) + " no_bump_scale";
        } else if (pattern instanceof Pattern.Checker checker) {
            return "checker " + rise + " scale " + vector(checker.size()) + (checker.origin().equals(Vec3.ZERO) ? "" : " translate " + vector(checker.origin()))
                    + PovPatterns.laid(checker.lay()) + " no_bump_scale";
        }
        Pattern.Stripes stripes = (Pattern.Stripes) pattern;
        return "checker " + rise + " scale " + vector(stripes.size(), PovPatterns.HIGH, PovPatterns.HIGH) + " translate " + vector(0, -PovPatterns.HIGH / 2, -PovPatterns.HIGH / 2)
                + PovPatterns.laid(stripes.lay()) + " no_bump_scale";
    }
}
