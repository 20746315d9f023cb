package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.eye.SetAside;
import cz.paprsek.render.integrate.Paths;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.surface.World;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Points of a light alone (one that no ray sees), directions of surfaces alone (a body that glows in its place, made such that nobody looks for it) and both together (a light that is seen, or a body that
 * is looked for) have the same mean in every pixel: then the p-values of Welch's test are spread evenly, by the test of Kolmogorov and Smirnov. What is random is fixed, and so is the answer.
 * Each estimator has sequences of its own in each pixel, of which it shares none: eight times -Dpaths.sequences. Fewer are too few where a light is met by chance, and seldom.
 *
 * @see <a href="https://jcgt.org/published/0009/02/01/">Jung, Hanika, Dachsbacher, Detecting Bias in Monte Carlo Renderers using Welch's t-test, JCGT 9(2), 2020</a>
 */
class WelchTest {
    private static final int SIDE = Integer.getInteger("paths.welch", 12);
    /** Of one sequence. */
    private static final int POINTS = Integer.getInteger("paths.points", 32);
    private static final int PLACES = Integer.getInteger("paths.sequences", 2);
    private static final int GROUPS = Sampler.SCRAMBLES * PLACES;
    private static final double RADIANCE = 3;
    private static final double AREA = 1.5;

    @ParameterizedTest
    @CsvSource({"POINTS, BOTH, 0", "DIRECTIONS, BOTH, 0", "POINTS, DIRECTIONS, 0", "POINTS, BOTH, 0.6", "DIRECTIONS, BOTH, 0.6",
        "BALL_BY_CHANCE, BALL, 0", "BLOCK_BY_CHANCE, BLOCK, 0", "BLOCK_BY_CHANCE, BLOCK, 0.6",
        "SKY_BY_CHANCE, SKY, 0", "SKY_BY_CHANCE, SKY, 0.5"})
    void allWaysToFindALightHaveTheSameMean(Estimator one, Estimator other, double roughness) {
        assertThat(kolmogorov(pValues(one.means(roughness, 0), other.means(roughness, 1), 1))).as("how probable even p-values are to be as uneven as these").isGreaterThan(0.001);
    }

    /** A sun of one point of the sky's picture, which few paths meet. */
    @Test
    void aSkyThatIsLookedForHasFarLessGrain() {
        double[][] sought = Estimator.SKY.means(0, 0);
        double[][] met = Estimator.SKY_BY_CHANCE.means(0, 0);
        assertThat(Arrays.stream(sought).mapToDouble(WelchTest::variance).sum()).isLessThan(0.06 * Arrays.stream(met).mapToDouble(WelchTest::variance).sum());
    }

    /** The same test finds a light that is a fiftieth too bright: it can fail. */
    @ParameterizedTest
    @CsvSource("0.02")
    void anEstimateThatIsOffIsFound(double by) {
        assertThat(kolmogorov(pValues(Estimator.POINTS.means(0, 0), Estimator.BOTH.means(0, 1), 1 + by))).isLessThan(1e-6);
    }

    /** Lamps from large to small, seen in plates from smooth to rough: some are found by their points almost alone, others by directions almost alone. */
    @Test
    void platesAreAsBrightWhicheverWayTheLampsAreFound() throws Exception {
        Scene seen = SceneFiles.read(Path.of("../scenes/plates.xml"));
        // Past the lamps, which not all ways show.
        Scene plates = seen.withCamera(Camera.lookingAt(new Vec3(0, 2.2, 12), new Vec3(0, 1.1, 1)).withFovy(16));
        Scene dark = plates.withLights(List.of());
        for (Light light : plates.lights()) {
            SphereLight lamp = (SphereLight) light;
            double radiance = lamp.intensity() * lamp.referenceDistance() * lamp.referenceDistance() / (lamp.radius() * lamp.radius());
            dark = dark.plus(Estimator.byChance(SceneObject.of(new Sphere(lamp.radius())).at(lamp.position().x(), lamp.position().y(), lamp.position().z())
                    .madeOf(Material.DEFAULT.withDiffusion(0).withHighlight(0, 1).withEmission(lamp.color(), radiance))));
        }
        double[] points = sums(means(plates.withLights(plates.lights().stream().<Light>map(light -> ((SphereLight) light).withVisible(false)).toList()), 3, 0));
        double[] both = sums(means(plates, 3, 1));
        double[] directions = sums(means(dark, 3, 0));
        assertThat(welch(points, both)).isGreaterThan(0.001);
        assertThat(welch(directions, both)).isGreaterThan(0.001);
        assertThat(variance(both)).as("found both ways").isLessThan(variance(directions)).isLessThan(variance(points));
    }

    /** Of all pixels, by independent sequences. */
    private static double[] sums(double[][] means) {
        return IntStream.range(0, GROUPS).mapToDouble(group -> Arrays.stream(means).mapToDouble(pixel -> pixel[group]).sum()).toArray();
    }

    /** Of all pixels that see anything. */
    private static double[] pValues(double[][] a, double[][] b, double factor) {
        double[] p = IntStream.range(0, a.length).filter(i -> variance(a[i]) + variance(b[i]) > 0)
                .mapToDouble(i -> welch(Arrays.stream(a[i]).map(x -> factor * x).toArray(), b[i])).toArray();
        assertThat(p).hasSizeGreaterThan(a.length / 2);
        return p;
    }

    enum Estimator {
        POINTS, DIRECTIONS, BOTH, BALL, BALL_BY_CHANCE, BLOCK, BLOCK_BY_CHANCE, SKY, SKY_BY_CHANCE;

        private static final Material GLOW = Material.DEFAULT.withDiffusion(0).withHighlight(0, 1).withEmission(Rgb.WHITE, RADIANCE);
        /** Above and behind the scene, turned and stretched. */
        private static final SceneObject BLOCK_BODY = SceneObject.of(new Block(new Vec3(-0.4, -0.3, -0.2), new Vec3(0.2, 0.3, 0.4), 0)).scaled(1, 2, 1).rotated(20, 30, 40).at(-0.7, 1.9, 0.2).madeOf(GLOW);
        private static final SceneObject BALL_BODY = SceneObject.of(new Sphere(0.5)).at(-0.7, 1.9, 0.2).madeOf(GLOW);

        private static final Assets SKY_PICTURE = skyPicture();

        private static Assets skyPicture() {
            Image picture = new Image(32, 16);
            for (int i = 0; i < 32 * 16; i++) {
                double light = i == 32 * 3 + 20 ? 200 : 0.2 + 0.01 * (i % 32);
                picture.set(i % 32, i / 32, light, light, light);
            }
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            try {
                ImageFiles.write(picture, bytes, ImageFormat.PFM);
            } catch (IOException impossible) {
                throw new UncheckedIOException(impossible);
            }
            return Assets.of(Map.of("sky.pfm", bytes.toByteArray()));
        }

        /** The floor alone: where footprints are small, the picture is looked up the same way by all. */
        private static Scene underSky(Scene scene) {
            return scene.withObjects(scene.objects().subList(0, 1)).withSky(new Scene.Sky.Picture("sky.pfm", 40, 1.5));
        }

        private static SceneObject byChance(SceneObject body) {
            return body.withShape(Csg.union((Solid) body.shape()));
        }


        private Scene scene(double roughness) {
            Material floor = roughness == 0 ? Material.DEFAULT.withDiffusion(0.8) : Material.DEFAULT.withDiffusion(0.3).withReflection(0.6).withRoughness(roughness);
            Scene dark = Scene.EMPTY.withCamera(Camera.lookingAt(new Vec3(0, 1.6, 3), Vec3.ZERO))
                    .plus(SceneObject.of(new Rectangle(-4, -4, 4, 4)).rotated(-90, 0, 0).madeOf(floor))
                    .plus(SceneObject.of(new Sphere(0.4)).at(0.3, 0.4, 0).madeOf(floor));
            AreaLight lamp = AreaLight.rectangle(new Vec3(0, 3, 0), AREA, 1).withRotation(new Vec3(90, 0, 0)).withIntensity(RADIANCE * AREA / Math.PI);
            return switch (this) {
                case POINTS -> dark.withLights(List.of(lamp.withVisible(false)));
                case BOTH -> dark.withLights(List.of(lamp.withVisible(true)));
                // A sheet as thin as nothing.
                case DIRECTIONS -> dark.plus(byChance(SceneObject.of(new Block(new Vec3(-AREA / 2, -0.5, 0), new Vec3(AREA / 2, 0.5, 1e-6), 0)).rotated(90, 0, 0).at(0, 3, 0).madeOf(GLOW)));
                case BALL -> dark.plus(BALL_BODY);
                case BALL_BY_CHANCE -> dark.plus(byChance(BALL_BODY));
                case BLOCK -> dark.plus(BLOCK_BODY);
                case SKY -> underSky(dark);
                // Behind glass that leaves all as it is, paths find light alone.
                case SKY_BY_CHANCE -> underSky(dark).plus(SceneObject.of(new Sphere(50)).madeOf(Material.DEFAULT.withDiffusion(0).withTransparency(1, 1).withThin(true)));
                case BLOCK_BY_CHANCE -> dark.plus(byChance(BLOCK_BODY));
            };
        }

        /**
         * Of each pixel the means of independent sequences.
         *
         * @param which of the two estimators that are compared
         */
        double[][] means(double roughness, int which) {
            return WelchTest.means(scene(roughness), this == SKY_BY_CHANCE ? 3 : 2, which);
        }
    }

    private static double[][] means(Scene scene, int depth, int which) {
        RenderSettings settings = new RenderSettings(SIDE, SIDE, 2, 1).withIntegrator(Integrator.PATH).withSamples(POINTS * Sampler.SCRAMBLES);
        Paths paths = new Paths(new World(scene, new Textures(Estimator.SKY_PICTURE), () -> false), depth, new Passes(settings, false));
        paths.begin(() -> false);
        double[][] means = new double[SIDE * SIDE][GROUPS];
        for (int pixel = 0; pixel < SIDE * SIDE; pixel++) {
            for (int place = 0; place < PLACES; place++) {
                SetAside eye = SetAside.of(scene.camera(), SIDE, (2 * pixel + which) * PLACES + place);
                for (int i = 0; i < POINTS * Sampler.SCRAMBLES; i++) {
                    paths.traceAlone(eye, eye.left + pixel % SIDE, eye.top + pixel / SIDE, i);
                    means[pixel][place * Sampler.SCRAMBLES + Sampler.scramble(i)] += paths.alone().red / POINTS;
                }
            }
        }
        return means;
    }

    /** The p-value of Welch's test: that two means as far apart, or farther, are of the same mean. */
    private static double welch(double[] a, double[] b) {
        double u = variance(a) / a.length;
        double v = variance(b) / b.length;
        double t = Math.abs(mean(a) - mean(b)) / Math.sqrt(u + v);
        double freedom = (u + v) * (u + v) / (u * u / (a.length - 1) + v * v / (b.length - 1));
        return 2 * tail(t, freedom);
    }

    private static double mean(double[] x) {
        return Arrays.stream(x).average().orElseThrow();
    }

    private static double variance(double[] x) {
        double mean = mean(x);
        return Arrays.stream(x).map(one -> (one - mean) * (one - mean)).sum() / (x.length - 1);
    }

    /** The probability that a t is above a value, by Simpson's rule in s = t/√(freedom + t²). */
    private static double tail(double t, double freedom) {
        DoubleUnaryOperator density = s -> Math.pow(1 - s * s, freedom / 2 - 1);
        double to = t / Math.sqrt(freedom + t * t);
        return 0.5 - integral(density, to) / (2 * integral(density, 1 - 1e-9));
    }

    private static double integral(DoubleUnaryOperator f, double to) {
        int n = 400;
        double h = to / n;
        double sum = f.applyAsDouble(0) + f.applyAsDouble(to);
        for (int i = 1; i < n; i++) {
            sum += (i % 2 == 1 ? 4 : 2) * f.applyAsDouble(i * h);
        }
        return sum * h / 3;
    }

    /** How probable numbers spread evenly from 0 to 1 are to be as uneven as these: Kolmogorov's distribution, with Stephens' correction. */
    private static double kolmogorov(double[] values) {
        double[] sorted = Arrays.stream(values).sorted().toArray();
        double most = 0;
        int n = sorted.length;
        for (int i = 0; i < n; i++) {
            most = Math.max(most, Math.max((i + 1.0) / n - sorted[i], sorted[i] - (double) i / n));
        }
        double x = (Math.sqrt(n) + 0.12 + 0.11 / Math.sqrt(n)) * most;
        double sum = 0;
        for (int k = 1; k <= 100; k++) {
            sum += (k % 2 == 1 ? 2 : -2) * Math.exp(-2.0 * k * k * x * x);
        }
        return Math.min(1, Math.max(0, sum));
    }
}
