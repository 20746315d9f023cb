package cz.paprsek.format.openscad;

import cz.paprsek.math.Affine;
import cz.paprsek.shape.Extrude;
import cz.paprsek.shape.Lathe;
import cz.paprsek.text.Numbers;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * A figure as the outline of an {@link Extrude} or a {@link Lathe}.
 *
 * @param path of a circle, as SVG has it; empty if there are points
 * @param points its corners, x and y of each; empty if there is a path
 */
record Outlined(String path, String points) {
    /** Rays are tried with each side of an outline, but with few triangles: of more corners than these, triangles are faster. */
    private static final int MOST_CORNERS = 100;
    /** Relative; files have six digits. */
    private static final double SLACK = 2e-5;

    /** Empty if it is a circle no more, or has too many corners. */
    static Optional<Outlined> of(Figure figure, Affine map) {
        return figure instanceof Figure.Circle circle && circle.isRound() ? circle(circle.radius(), map, Double.NEGATIVE_INFINITY) : corners(figure.corners(map));
    }

    /** The same of a figure that lies right of the axis x = 0, or beyond it by a slack: then right at it. */
    static Optional<Outlined> rightOfAxis(Figure figure, Affine map, double slack) {
        if (figure instanceof Figure.Circle circle && circle.isRound()) {
            return circle(circle.radius(), map, 0);
        }
        double[] corners = figure.corners(map);
        for (int i = 0; i < corners.length; i += 2) {
            corners[i] = Math.abs(corners[i]) <= slack ? 0 : corners[i];
        }
        return corners(corners);
    }

    private static Optional<Outlined> circle(double radius, Affine map, double least) {
        double scale = StrictMath.hypot(map.xx(), map.yx());
        double other = StrictMath.hypot(map.xy(), map.yy());
        double left = map.xt() - radius * scale;
        if (Math.abs(scale - other) > SLACK * scale || Math.abs(map.xx() * map.xy() + map.yx() * map.yy()) > SLACK * scale * scale || left < least) {
            return Optional.empty();
        }
        String y = " " + Numbers.text(map.yt());
        String start = Numbers.text(left) + y;
        String half = "A" + Numbers.text(radius * scale) + " " + Numbers.text(radius * scale) + " 0 0 1 ";
        return Optional.of(new Outlined("M" + start + half + Numbers.text(map.xt() + radius * scale) + y + half + start + "Z", ""));
    }

    private static Optional<Outlined> corners(double[] corners) {
        return corners.length > 2 * MOST_CORNERS ? Optional.empty()
                : Optional.of(new Outlined("", Arrays.stream(corners).mapToObj(Numbers::text).collect(Collectors.joining(" "))));
    }
}
