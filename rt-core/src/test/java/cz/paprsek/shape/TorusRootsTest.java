package cz.paprsek.shape;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import java.math.BigDecimal;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where rays meet rings, against the quartic (|p|² + R² − r²)² = 4R²(x² + z²) without rounding. */
class TorusRootsTest {
    /** What rounding the origin, the direction and t may do, relative to the numbers involved: a few units in the last place. */
    private static final double LAST_BITS = 1.5e-15;

    @ParameterizedTest
    @CsvSource({"1, 0.4", "1, 1", "1, 0.01", "1e4, 1", "1e7, 1", "2e7, 1e7", "1e-6, 1e-7", "1e-3, 1e-9", "1, 1.5", "1, 30"})
    void theCrossingsAreThoseOfTheQuartic(double major, double minor) {
        Surface torus = new Torus(major, minor).place(Affine.IDENTITY, new TestParts());
        Random random = new Random(11);
        Spans spans = new Spans();
        int checked = 0;
        for (int i = 0; i < 3000; i++) {
            double angle = random.nextDouble() * 2 * Math.PI;
            Vec3 on = new Vec3(major * Math.cos(angle), 0, major * Math.sin(angle));
            Vec3 target = on.plus(vector(random).times(minor * 0.7));
            Vec3 from = i % 2 == 0 ? vector(random).times(3 * (major + minor)) : on.plus(vector(random).times(5 * minor));
            Vec3 d = target.minus(from).normalized();
            Ray ray = new Ray(spans);
            ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
            torus.crossings(ray, spans);
            for (int k = 0; k < spans.size(); k++) {
                double t = spans.t(k);
                Vec3 p = from.plus(d.times(t));
                double rho = Math.hypot(p.x(), p.z());
                Vec3 normal = new Vec3(p.x() * (1 - major / rho), p.y(), p.z() * (1 - major / rho)).normalized();
                double reach = LAST_BITS * (major + from.length() + t) / Math.abs(normal.dot(d));
                // Where the normal itself is rounded away, or both crossings are within rounding, there is nothing to compare.
                if (Math.abs(normal.dot(d)) > 0.05 && reach < minor / 4) {
                    checked++;
                    assertThat(outside(from, d, t - reach, major, minor)).as("ray %d, crossing %d at %s ± %s", i, k, t, reach)
                            .isEqualTo(-outside(from, d, t + reach, major, minor));
                }
            }
            spans.release(0);
        }
        assertThat(checked).isGreaterThan(1000);
    }

    private static Vec3 vector(Random random) {
        return new Vec3(random.nextDouble() * 2 - 1, random.nextDouble() * 2 - 1, random.nextDouble() * 2 - 1);
    }

    /** The sign of the quartic, exactly. */
    private static int outside(Vec3 o, Vec3 d, double t, double major, double minor) {
        BigDecimal at = new BigDecimal(t);
        BigDecimal x = new BigDecimal(o.x()).add(at.multiply(new BigDecimal(d.x()))).pow(2);
        BigDecimal y = new BigDecimal(o.y()).add(at.multiply(new BigDecimal(d.y()))).pow(2);
        BigDecimal z = new BigDecimal(o.z()).add(at.multiply(new BigDecimal(d.z()))).pow(2);
        BigDecimal bigR = new BigDecimal(major).pow(2);
        BigDecimal left = x.add(y).add(z).add(bigR).subtract(new BigDecimal(minor).pow(2)).pow(2);
        return left.subtract(bigR.multiply(new BigDecimal(4)).multiply(x.add(z))).signum();
    }
}
