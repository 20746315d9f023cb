package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.material.Material;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Lights with a size by another way: what a shiny point of the floor sends on, half in the shadow of a ball, added up in this test over a fine grid of
 * directions or of the light's area. Of places and sizes that nobody has chosen; {@code -Dlights.seed} repeats a run, {@code -Dlights.points} makes it longer.
 */
class QuadratureTest {
    private static final long SEED = Long.getLong("lights.seed", new Random().nextInt(1_000_000));
    private static final int POINTS = Integer.getInteger("lights.points", 8);
    private static final int STEPS = 400;
    private static final int SAMPLES = 4096;
    private static final double DIFFUSION = 0.6;
    private static final double SPECULAR = 0.5;
    private static final int SHININESS = 12;

    static LongStream seeds() {
        return LongStream.range(SEED, SEED + POINTS);
    }

    /** What is looked at, a point of the floor y = 0, and the ball that stands in the light's way. */
    private record View(Vec3 point, Vec3 from, Vec3 ball, double radius) {
        static View random(Random random, Vec3 light) {
            Vec3 point = new Vec3(between(random, -2, 2), 0, between(random, -2, 2));
            // About the way to the light, neither around the point nor within the light.
            Vec3 way = light.minus(point);
            double radius = between(random, 0.04, 0.1) * way.length();
            Vec3 ball = point.plus(way.times(between(random, 0.25, 0.4))).plus(new Vec3(between(random, -1, 1), between(random, 0, 1), between(random, -1, 1)).times(radius));
            return new View(point, new Vec3(between(random, -1, 1), between(random, 0.5, 1), between(random, -1, 1)).normalized(), ball, radius);
        }

        /** Cosine and highlight of light from a direction of length 1; nothing if the ball is in its way. */
        double sent(Vec3 direction) {
            Vec3 to = ball.minus(point);
            double along = to.dot(direction);
            boolean isFree = along < 0 || to.dot(to) - along * along > radius * radius;
            Vec3 mirrored = new Vec3(-from.x(), from.y(), -from.z());
            return isFree && direction.y() > 0 ? DIFFUSION * direction.y() + SPECULAR * Math.pow(Math.max(0, mirrored.dot(direction)), SHININESS) : 0;
        }

        double rendered(Light light) {
            Material material = Material.DEFAULT.withDiffusion(DIFFUSION).withHighlight(SPECULAR, SHININESS);
            Scene scene = Scene.EMPTY.plus(light).plus(SceneObject.of(new Rectangle(-100, -100, 100, 100)).rotated(-90, 0, 0).madeOf(material),
                    SceneObject.of(new Sphere(radius)).at(ball.x(), ball.y(), ball.z()));
            return RenderScene.of(scene).explainRay(point.plus(from.times(1e-6)), from.negated(), 1).light().red();
        }
    }

    private static double between(Random random, double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    private static Vec3 place(Random random) {
        return new Vec3(between(random, -2, 2), between(random, 1, 4), between(random, -2, 2));
    }

    /** Over the cone that the ball fills; it may reach below the floor. */
    @ParameterizedTest
    @MethodSource("seeds")
    void balls(long seed) {
        Random random = new Random(seed);
        Vec3 middle = place(random);
        View view = View.random(random, middle);
        Vec3 axis = middle.minus(view.point()).normalized();
        double distance = middle.minus(view.point()).length();
        SphereLight light = SphereLight.of(middle, between(random, 0.05, 0.3) * distance).withReferenceDistance(3).withIntensity(0.7).withSamples(SAMPLES).withVisible(false);
        Vec3 side = axis.cross(Math.abs(axis.y()) < 0.9 ? Vec3.Y : Vec3.X).normalized();
        Vec3 other = axis.cross(side);
        double cosine = Math.sqrt(1 - Math.pow(light.radius() / distance, 2));
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            double c = 1 - (1 - cosine) * (i + 0.5) / STEPS;
            double s = Math.sqrt(1 - c * c);
            for (int j = 0; j < STEPS; j++) {
                double turn = 2 * Math.PI * (j + 0.5) / STEPS;
                sum += view.sent(axis.times(c).plus(side.times(s * Math.cos(turn))).plus(other.times(s * Math.sin(turn))));
            }
        }
        double cone = 2 * Math.PI * (1 - cosine);
        double radiance = 0.7 * 9 / (light.radius() * light.radius());
        assertNear(view.rendered(light), radiance / Math.PI * cone * sum / (STEPS * STEPS), radiance / Math.PI * cone);
    }

    /** Over the area of a rectangle or disc, each piece of which brings L·cos θ/d² of itself. */
    @ParameterizedTest
    @MethodSource("seeds")
    void flatLights(long seed) {
        Random random = new Random(seed);
        Vec3 middle = place(random);
        View view = View.random(random, middle);
        boolean isDisc = random.nextBoolean();
        double width = between(random, 0.3, 2);
        double height = isDisc ? width : between(random, 0.3, 2);
        AreaLight light = (isDisc ? AreaLight.disc(middle, width / 2) : AreaLight.rectangle(middle, width, height)).withReferenceDistance(3).withIntensity(0.7)
                .withSamples(SAMPLES).withVisible(false).shiningAt(view.point().plus(new Vec3(between(random, -1, 1), 0, between(random, -1, 1))));
        Affine toWorld = light.placement().toParent();
        Vec3 normal = light.direction();
        double sum = 0;
        double all = 0;
        for (int i = 0; i < STEPS; i++) {
            for (int j = 0; j < STEPS; j++) {
                double a = (i + 0.5) / STEPS - 0.5;
                double b = (j + 0.5) / STEPS - 0.5;
                if (!isDisc || a * a + b * b < 0.25) {
                    Vec3 way = toWorld.point(new Vec3(a * width, b * height, 0)).minus(view.point());
                    Vec3 direction = way.normalized();
                    double brings = Math.max(0, -normal.dot(direction)) / way.dot(way);
                    sum += brings * view.sent(direction);
                    all += brings;
                }
            }
        }
        double piece = width * height / (STEPS * STEPS);
        double radiance = 0.7 * Math.PI * 9 / light.form().area();
        assertNear(view.rendered(light), radiance / Math.PI * piece * sum, radiance / Math.PI * piece * all);
    }

    /** To half a percent of what the light brings where nothing is in its way, seen by a white point that faces it. */
    private static void assertNear(double rendered, double expected, double whole) {
        assertThat(Math.abs(rendered - expected) / whole).as("%s for %s of %s, -Dlights.seed=%d", rendered, expected, whole, SEED).isLessThan(0.005);
    }
}
