package cz.paprsek.shape.outline;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Vec3;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Outlines as Bézier curves, arcs among them. */
class CurvesTest {
    /** Both ways round, more than a half and less, and with lines between: all arcs are of the circle around the origin, or of an ellipse made one by its scale. */
    @ParameterizedTest
    @CsvSource({"M5 0A5 5 0 0 1 -5 0A5 5 0 0 1 5 0Z, 1", "M5 0A5 5 0 0 0 -5 0A5 5 0 0 0 5 0Z, 1", "M3 4A5 5 0 1 1 3 -4L0 0Z, 1", "M3 -4A5 5 0 1 0 3 4L0 0Z, 1", "M5 0A5 2 0 0 1 0 2A5 2 0 0 1 -5 0Z, 2.5"})
    void arcsAreAsNearAsNobodyCanTell(String path, double stretch) {
        List<Vec3> points = Outline.of("extrude", path, "").curves();
        assertThat(points).hasSizeGreaterThan(8);
        int onCircle = 0;
        for (int i = 0; i < points.size(); i += 4) {
            Vec3 next = points.get((i + 4) % points.size());
            assertThat(points.get(i + 3)).isEqualTo(next);
            if (radius(points.get(i), stretch) > 4.9 && radius(points.get(i + 3), stretch) > 4.9 && radius(middle(points, i, 0.5), stretch) > 4.9) {
                onCircle++;
                for (double t = 0; t <= 1; t += 0.125) {
                    assertThat(radius(middle(points, i, t), stretch)).isCloseTo(5, within(5e-7));
                }
            }
        }
        assertThat(onCircle).isGreaterThanOrEqualTo(8);
    }

    private static double radius(Vec3 point, double stretch) {
        return Math.hypot(point.x(), point.y() * stretch);
    }

    private static Vec3 middle(List<Vec3> points, int first, double t) {
        double s = 1 - t;
        return points.get(first).times(s * s * s).plus(points.get(first + 1).times(3 * s * s * t)).plus(points.get(first + 2).times(3 * s * t * t)).plus(points.get(first + 3).times(t * t * t));
    }
}
