package cz.paprsek.math;

import java.util.List;

/** A line in space through points, straight from each to the next. */
public record Curve(List<Vec3> points) {
    public Curve {
        points = List.copyOf(points);
        Require.that(points.size() >= 2, "a curve needs at least two points, but has " + points.size());
    }

    public static Curve through(Vec3... points) {
        return new Curve(List.of(points));
    }
}
