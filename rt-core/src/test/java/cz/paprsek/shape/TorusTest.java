package cz.paprsek.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** A ring of radii 2 and ½, as it is and placed anyhow, in closed form. */
class TorusTest {
    private static final double SCALE = 3;
    private static final Affine MAP = Affine.translation(new Vec3(7, -5, 4)).after(Affine.rotation(new Vec3(20, 30, 40))).after(Affine.scaling(Vec3.ONE.times(SCALE)));

    private final Torus torus = new Torus(2, 0.5);
    private final TestParts parts = new TestParts();
    private final Volume placed = torus.place(MAP, parts);

    @Test
    void itsBoxTouchesIt() {
        assertThat(torus.bounds()).isEqualTo(new Bounds(-2.5, -0.5, -2.5, 2.5, 0.5, 2.5));
        Bounds box = placed.bounds();
        double x = half(MAP.xx(), MAP.xy(), MAP.xz());
        double y = half(MAP.yx(), MAP.yy(), MAP.yz());
        double z = half(MAP.zx(), MAP.zy(), MAP.zz());
        assertThat(new double[] {box.minX(), box.minY(), box.minZ(), box.maxX(), box.maxY(), box.maxZ()})
                .containsExactly(new double[] {7 - x, -5 - y, 4 - z, 7 + x, -5 + y, 4 + z}, within(1e-12));
    }

    /** How far it reaches in a direction: the ring by what is along its plane, the tube alike in all. */
    private static double half(double x, double y, double z) {
        return 2 * Math.hypot(x, z) + 0.5 * Math.sqrt(x * x + y * y + z * z);
    }

    @Test
    void aLineThroughItsMiddleCrossesItFourTimes() {
        Vec3 from = MAP.point(new Vec3(-5, 0, 0));
        Vec3 d = MAP.direction(Vec3.X).normalized();
        Ray ray = new Ray(new Spans());
        ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
        Spans spans = new Spans();
        placed.spans(ray, spans);
        assertThat(IntStream.range(0, spans.size()).mapToDouble(spans::t).toArray())
                .containsExactly(new double[] {2.5 * SCALE, 3.5 * SCALE, 6.5 * SCALE, 7.5 * SCALE}, within(1e-12));
    }

    @Test
    void itsNormalLeadsAwayFromTheMiddleOfTheTube() {
        for (int i = 0; i < 12; i++) {
            double around = 0.3 + i;
            double across = 1 + 2.1 * i;
            Vec3 out = new Vec3(Math.cos(across) * Math.cos(around), Math.sin(across), Math.cos(across) * Math.sin(around));
            Vec3 at = MAP.point(new Vec3(2 * Math.cos(around), 0, 2 * Math.sin(around)).plus(out.times(0.5)));
            Hit hit = new Hit();
            hit.px = at.x();
            hit.py = at.y();
            hit.pz = at.z();
            parts.all.get(0).describe(0, hit);
            assertThat(new Vec3(hit.nx, hit.ny, hit.nz).minus(MAP.direction(out).normalized()).length()).isLessThan(1e-12);
        }
    }

    @Test
    void itsOutlineIsInItsBox() {
        List<Curve> curves = torus.outline(new Vec3(0.3, -1, 0.2), 32);
        assertThat(curves).isNotEmpty().allSatisfy(curve -> assertThat(curve.points()).allMatch(torus.bounds().padded()::contains));
    }
}
