package cz.paprsek.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import java.util.Random;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;

/** Bodies of formulas: no hole where rays graze them. */
class IsosurfaceTest {
    /** -Dgrazing.rays=1000000 for all of them. */
    private static final int RAYS = Integer.getInteger("grazing.rays", 2000);
    private static final int SAMPLES = 200;
    private static final Vec3 CORNER = new Vec3(1.3, 1.3, 1.3);

    @Test
    void noHoleInABall() {
        grazed("x^2 + y^2 + z^2 - 1", p -> p.dot(p) - 1);
    }

    @Test
    void noHoleInATorus() {
        grazed("(hypot(x, z) - 0.8)^2 + y^2 - 0.09", p -> Math.pow(Math.hypot(p.x(), p.z()) - 0.8, 2) + p.y() * p.y() - 0.09);
    }

    @Test
    void noHoleInAGyroid() {
        double turn = Math.PI;
        grazed("cos(180*x)*sin(180*y) + cos(180*y)*sin(180*z) + cos(180*z)*sin(180*x)", p -> Math.cos(turn * p.x()) * Math.sin(turn * p.y())
                + Math.cos(turn * p.y()) * Math.sin(turn * p.z()) + Math.cos(turn * p.z()) * Math.sin(turn * p.x()));
    }

    /** Rays along the surface, lifted from it a little more or less: all along, the body is where its formula is below 0. */
    private static void grazed(String expression, ToDoubleFunction<Vec3> formula) {
        Volume body = new Isosurface(expression, CORNER.negated(), CORNER).place(Affine.IDENTITY, new TestParts());
        Random random = new Random(4);
        Spans spans = new Spans();
        Ray ray = new Ray(new Spans());
        int met = 0;
        for (int i = 0; i < RAYS; i++) {
            Vec3 on = onSurface(formula, random);
            Vec3 n = gradient(formula, on).normalized();
            Vec3 along = n.cross(direction(random)).normalized();
            Vec3 from = on.minus(n.times(Math.pow(10, -1 - 11 * random.nextDouble()) * (random.nextInt(3) - 1))).minus(along.times(4));
            ray.start(from.x(), from.y(), from.z(), along.x(), along.y(), along.z());
            spans.release(0);
            body.spans(ray, spans);
            assertThat(spans.size() % 2).isZero();
            met += spans.size() / 2;
            int passed = 0;
            for (int k = 0; k < SAMPLES; k++) {
                double t = 4 + 2.4 * (2 * (k + random.nextDouble()) / SAMPLES - 1);
                Vec3 p = from.plus(along.times(t));
                double value = formula.applyAsDouble(p);
                while (passed < spans.size() && spans.t(passed) <= t) {
                    passed++;
                }
                if (Math.abs(value) > 1e-12 && Math.max(Math.abs(p.x()), Math.max(Math.abs(p.y()), Math.abs(p.z()))) < 1.299) {
                    assertThat(passed % 2 != 0).as("ray %d of %s, inside at %s, where it is %s", i, expression, p, value).isEqualTo(value < 0);
                }
            }
            body.nearest(ray);
            assertThat(ray.max).isEqualTo(spans.size() > 0 ? spans.t(0) : Double.POSITIVE_INFINITY);
        }
        assertThat(met).isGreaterThan(RAYS / 3);
    }

    private static Vec3 onSurface(ToDoubleFunction<Vec3> formula, Random random) {
        while (true) {
            Vec3 a = direction(random).times(1.2 * random.nextDouble());
            Vec3 b = direction(random).times(1.2 * random.nextDouble());
            boolean inA = formula.applyAsDouble(a) < 0;
            if (inA == formula.applyAsDouble(b) < 0) {
                continue;
            }
            for (int i = 0; i < 60; i++) {
                Vec3 middle = a.plus(b).times(0.5);
                if (formula.applyAsDouble(middle) < 0 == inA) {
                    a = middle;
                } else {
                    b = middle;
                }
            }
            return a;
        }
    }

    private static Vec3 gradient(ToDoubleFunction<Vec3> formula, Vec3 p) {
        double step = 1e-6;
        return new Vec3(formula.applyAsDouble(p.plus(Vec3.X.times(step))) - formula.applyAsDouble(p.minus(Vec3.X.times(step))),
                formula.applyAsDouble(p.plus(Vec3.Y.times(step))) - formula.applyAsDouble(p.minus(Vec3.Y.times(step))),
                formula.applyAsDouble(p.plus(Vec3.Z.times(step))) - formula.applyAsDouble(p.minus(Vec3.Z.times(step))));
    }

    private static Vec3 direction(Random random) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
    }

    /** Every function of the language may stand there; what jumps, and what is no number, ends. */
    @Test
    void everyFunctionEndsInTime() {
        for (String expression : new String[] {"floor(3*x) + y", "x % 0.3 - 0.1", "mod(y, 0.4) - 0.2", "x > 0.2 and y < 0.3 ? -1 : 1", "rand(x, y) - 0.5", "sqrt(x) - 0.5", "ln(y) + 1",
            "atan2(y, x) - 30", "asin(x) - 10", "acos(y) - 80", "tan(100*x) - y", "1/x - 2", "x^y - 0.5", "x^-3 - y", "cbrt(x) + y", "exp(x) - 2*exp(y)", "clamp(x, -0.2, 0.2) + y", "mix(x, y, 0.3)",
            "min(x, y, z)", "max(abs(x), abs(y)) - 0.5", "sign(x)", "not x", "0", "x - x", "round(x*5)/5 + y", "log10(x + 2) - 0.3", "ceil(x) - 0.5"}) {
            Volume body = new Isosurface(expression, CORNER.negated(), CORNER).place(Affine.IDENTITY, new TestParts());
            Random random = new Random(6);
            Spans spans = new Spans();
            Ray ray = new Ray(new Spans());
            for (int i = 0; i < 10; i++) {
                Vec3 from = direction(random).times(4);
                Vec3 d = direction(random).times(random.nextDouble()).minus(from).normalized();
                ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
                spans.release(0);
                body.spans(ray, spans);
                assertThat(spans.size() % 2).as(expression).isZero();
            }
        }
    }

    @Test
    void whatIsNoFormulaIsRefusedByASentence() {
        assertThatThrownBy(() -> new Isosurface("x +", CORNER.negated(), CORNER)).hasMessageStartingWith("isosurface expression must be a formula, but at character 4:");
        assertThatThrownBy(() -> new Isosurface("q*x", CORNER.negated(), CORNER)).hasMessage("isosurface expression must be a formula of x, y and z, but has \"q\"");
        assertThatThrownBy(() -> new Isosurface("x", CORNER, CORNER.negated())).hasMessageContaining("min must be below max along every axis");
    }
}
