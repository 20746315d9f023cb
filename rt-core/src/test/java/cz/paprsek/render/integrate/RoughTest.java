package cz.paprsek.render.integrate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.placed.Spans;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Rough surfaces against the integrals that hold of any, the formulas as Mitsuba has them, and themselves: chosen at random or lit by lamps. */
class RoughTest {
    private static final Material BLACK = Material.color(Rgb.BLACK).withDiffusion(0);
    private static final int STEPS = 400;

    private interface OfDirection {
        double at(double x, double y, double z);
    }

    /** ∫ over a half of all directions, in cos θ² and φ: dω = sin θ dθ dφ. Denser where cos θ is near 1. */
    private static double integral(double sign, OfDirection f) {
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            double s = (i + 0.5) / STEPS;
            double sine = s * s * (3 - 2 * s);
            double z = Math.sqrt(1 - sine * sine);
            double weight = sine / z * 6 * s * (1 - s) / STEPS;
            for (int j = 0; j < STEPS; j++) {
                double angle = 2 * Math.PI * (j + 0.5) / STEPS;
                sum += weight * 2 * Math.PI / STEPS * f.at(sine * Math.cos(angle), sine * Math.sin(angle), sign * z);
            }
        }
        return sum;
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.04, 0.25, 0.5, 1})
    void facetsCoverTheSurfaceOnce(double alpha) {
        assertThat(integral(1, (x, y, z) -> Ggx.spread(z, alpha) * z)).isCloseTo(1, within(2e-3));
    }

    /** What is seen of the facets is what is seen of the surface: Heitz, Understanding the Masking-Shadowing Function, JCGT 3(2), 2014, equation 14. */
    @ParameterizedTest
    @CsvSource({"0.25, 0", "0.25, 70", "0.5, 40", "1, 20", "1, 80"})
    void asMuchIsSeenOfFacetsAsOfTheSurface(double alpha, double degrees) {
        double cosine = Math.cos(Math.toRadians(degrees));
        double sine = Math.sin(Math.toRadians(degrees));
        assertThat(integral(1, (x, y, z) -> Ggx.seen(cosine, alpha) * Ggx.spread(z, alpha) * Math.max(0, x * sine + z * cosine))).isCloseTo(cosine, within(2e-3));
    }

    /** Mitsuba 3, microfacet.h: D = 1/(π·α²·cos⁴·(1 + tan²/α²)²), G₁ = 2/(1 + √(1 + α²·tan²)). */
    @ParameterizedTest
    @CsvSource({"0.1, 0.3", "0.1, 0.99", "0.5, 0.7", "1, 0.2", "0.02, 1"})
    void formulasAreThoseOfMitsuba(double alpha, double cosine) {
        double c2 = cosine * cosine;
        double tan2 = (1 - c2) / c2;
        double root = 1 + tan2 / (alpha * alpha);
        assertThat(Ggx.spread(cosine, alpha)).isCloseTo(1 / (Math.PI * alpha * alpha * c2 * c2 * root * root), within(1e-9 / (alpha * alpha)));
        assertThat(Ggx.seen(cosine, alpha)).isCloseTo(2 / (1 + Math.sqrt(1 + alpha * alpha * tan2)), within(1e-12));
    }

    /** A rectangle of a material seen at an angle; what its lobe sends of light from a direction, f·cos. */
    private static final class Probe {
        private final Level level = new Level(new Spans());
        private final Finish finish;
        private final Lobe lobe;
        private final Arrival light = new Arrival();

        Probe(Material material, boolean isSolid, double vx, double vy, double vz) {
            World world = new World(Scene.EMPTY.plus((isSolid ? SceneObject.of(new Plane()).rotated(90, 0, 0) : SceneObject.of(new Rectangle(-1, -1, 1, 1))).madeOf(material)), new Textures(Assets.none()), () -> false);
            finish = world.parts().finish(world.parts().firstOf(0));
            level.ray.part = world.parts().firstOf(0);
            level.ray.dx = -vx;
            level.ray.dy = -vy;
            level.ray.dz = -vz;
            level.hit.unitNormal(0, 0, 1);
            level.light(0, 0, 0);
            level.colorRed = 1;
            level.colorGreen = 1;
            level.colorBlue = 1;
            lobe = new Lobe(world);
            lobe.at(level, finish);
        }

        double value(double x, double y, double z) {
            light.along(x, y, z);
            lobe.look(level, finish, light, z);
            return lobe.valueRed / Math.PI;
        }
    }

    static Stream<String> mitsuba() throws IOException {
        try (InputStream recorded = Objects.requireNonNull(RoughTest.class.getResourceAsStream("mitsuba-ggx.txt"))) {
            return new String(recorded.readAllBytes(), StandardCharsets.UTF_8).lines().filter(line -> !line.startsWith("#")).toList().stream();
        }
    }

    /** Numbers of single precision, of angles that are. */
    @ParameterizedTest
    @MethodSource("mitsuba")
    void lampsBringWhatMitsubaSays(String line) {
        String[] words = line.split(" ");
        double[] n = Stream.of(words).skip(1).mapToDouble(Double::parseDouble).toArray();
        Material material = (words[0].equals("mirror") ? BLACK.withPattern(new Pattern.Plain(Rgb.WHITE)).withReflection(1).withFresnel(Fresnel.METAL)
                : BLACK.withReflection(1).withTransparency(1, 1.5).withFresnel(Fresnel.TRUE)).withRoughness(n[0]);
        double view = Math.toRadians(n[1]);
        double light = Math.toRadians(n[2]);
        double turn = Math.toRadians(n[3]);
        Probe probe = new Probe(material, true, Math.sin(view), 0, Math.cos(view));
        double found = probe.value(Math.sin(light) * Math.cos(turn), Math.sin(light) * Math.sin(turn), Math.cos(light));
        assertThat(found / n[4]).isCloseTo(1, within(2e-4));
    }

    /** The mean of what random rays weigh that go through glass of an index. */
    private static double chosenThrough(double alpha, double index, double vx, double vz) {
        Ggx facets = new Ggx();
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            for (int j = 0; j < STEPS; j++) {
                facets.choose(0, 0, 1, vx, 0, vz, alpha, (i + 0.5) / STEPS, (j + 0.5) / STEPS);
                double c = vx * facets.x + vz * facets.z;
                double beyond = Math.sqrt(1 - (1 - c * c) / (index * index));
                double z = vz / index - (c / index - beyond) * facets.z;
                sum += z > 0 ? (1 - Shares.reflectance(1, index, c, beyond)) * Ggx.seen(z, alpha) : 0;
            }
        }
        return sum / (STEPS * STEPS);
    }

    private static double chosen(double alpha, double vx, double vz) {
        Ggx facets = new Ggx();
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            for (int j = 0; j < STEPS; j++) {
                facets.choose(0, 0, 1, vx, 0, vz, alpha, (i + 0.5) / STEPS, (j + 0.5) / STEPS);
                double twice = 2 * (vx * facets.x + vz * facets.z);
                double z = twice * facets.z - vz;
                sum += z > 0 ? Ggx.seen(z, alpha) : 0;
            }
        }
        return sum / (STEPS * STEPS);
    }

    /** The mean of what random rays weigh is the integral of what lamps are given: the albedo, which is nowhere above 1. */
    @ParameterizedTest
    @CsvSource({"0.5, 0", "0.5, 45", "0.7, 75", "1, 0", "1, 60"})
    void randomRaysBringWhatLampsBring(double roughness, double degrees) {
        double sine = Math.sin(Math.toRadians(degrees));
        double cosine = Math.cos(Math.toRadians(degrees));
        Probe probe = new Probe(BLACK.withReflection(1).withRoughness(roughness), false, sine, 0, cosine);
        double albedo = integral(1, probe::value);
        assertThat(albedo).isLessThanOrEqualTo(1 + 1e-3);
        assertThat(chosen(roughness * roughness, sine, cosine)).isCloseTo(albedo, within(4e-3));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.6, 1})
    void lightGoesEitherWayAlike(double roughness) {
        Material metal = Material.color(Rgb.ofLinear(0.6, 0.6, 0.6)).withDiffusion(0).withReflection(1).withFresnel(Fresnel.METAL).withRoughness(roughness);
        Vec3 one = new Vec3(0.3, 0.2, 0.5).normalized();
        Vec3 other = new Vec3(-0.4, 0.1, 0.8).normalized();
        double there = new Probe(metal, false, one.x(), one.y(), one.z()).value(other.x(), other.y(), other.z()) / other.z();
        double back = new Probe(metal, false, other.x(), other.y(), other.z()).value(one.x(), one.y(), one.z()) / one.z();
        assertThat(there).isPositive().isCloseTo(back, within(1e-12 * there));
    }

    /** Of glass, what is mirrored and what is let through together: at most all of it, and hardly less if it is smooth. */
    @ParameterizedTest
    @CsvSource({"0.5, 0, 0.95", "0.5, 50, 0.9", "0.9, 30, 0.7"})
    void glassGivesBackNoMoreThanItGets(double roughness, double degrees, double least) {
        double sine = Math.sin(Math.toRadians(degrees));
        double cosine = Math.cos(Math.toRadians(degrees));
        Material glass = BLACK.withReflection(1).withTransparency(1, 1.5).withFresnel(Fresnel.TRUE).withRoughness(roughness);
        Probe probe = new Probe(glass, true, sine, 0, cosine);
        double through = integral(-1, probe::value);
        assertThat(through).isCloseTo(chosenThrough(roughness * roughness, 1.5, sine, cosine), within(4e-3));
        assertThat(integral(1, probe::value) + through).isBetween(least, 1 + 1e-3);
        Probe pane = new Probe(glass, false, sine, 0, cosine);
        assertThat(integral(1, pane::value) + integral(-1, pane::value)).as("a pane strews what it lets through as far as what it mirrors").isBetween(least - 0.4, 1 + 1e-3);
    }

    private static double mean(Scene scene, int samples) {
        Image image = Renderer.render(scene.withSettings(new RenderSettings(8, 8, 6, samples)));
        double sum = 0;
        for (int i = 0; i < 64; i++) {
            sum += image.red(i % 8, i / 8);
        }
        return sum / 64;
    }

    /** One light, which rays see, or which they do not, so that it is looked for from the surface. */
    @ParameterizedTest
    @CsvSource({"0.6, false", "0.8, true"})
    void aLampThatIsSeenBringsWhatOneThatIsNotBrings(double roughness, boolean isThrough) {
        Material material = isThrough ? BLACK.withReflection(1).withTransparency(1, 1.5).withFresnel(Fresnel.TRUE).withRoughness(roughness)
                : BLACK.withReflection(0.8).withRoughness(roughness);
        AreaLight light = AreaLight.rectangle(isThrough ? new Vec3(0, 0, -3) : new Vec3(-2, 0, 5), 3, 3).withSamples(64);
        light = isThrough ? light : light.withRotation(new Vec3(0, 180, 0));
        Scene scene = Scene.EMPTY.withCamera(Camera.looking(new Vec3(0, 0, 5), new Vec3(0, 0, -1)).withFovy(4))
                .plus(SceneObject.of(new Rectangle(-1, -1, 1, 1)).madeOf(material));
        double seen = mean(scene.plus(light.withVisible(true)), 16);
        assertThat(seen).isGreaterThan(0.01);
        assertThat(mean(scene.plus(light.withVisible(false)), 4)).isCloseTo(seen, within(0.02 * seen));
    }

    /** A furnace: in white light a rough ball of glass or metal is nowhere brighter than what is around. */
    @ParameterizedTest
    @CsvSource({"0.3, true, false", "0.8, true, false", "0.5, false, false", "0.4, true, true"})
    void nothingIsBrighterThanWhatIsAround(double roughness, boolean isGlass, boolean isThin) {
        Material material = isGlass ? BLACK.withReflection(1).withTransparency(1, 1.5).withFresnel(Fresnel.TRUE) : BLACK.withReflection(1);
        Scene scene = Scene.EMPTY.withBackground(Rgb.WHITE).withCamera(Camera.looking(new Vec3(0, 0, 5), new Vec3(0, 0, -1)))
                .withSettings(new RenderSettings(16, 16, 24, 4)).plus(SceneObject.of(new Sphere(1)).madeOf(material.withRoughness(roughness).withThin(isThin)));
        Image image = Renderer.render(scene);
        for (int i = 0; i < 256; i++) {
            assertThat(image.red(i % 16, i / 16)).isBetween(0.25f, 1 + 1e-5f);
        }
    }

    /** A thin ball of glass bends nothing: the background behind it stays where it is, and of both its walls 4F/(1 + 3F) is mirrored. */
    @Test
    void aThinBodyIsAPaneAllAround() {
        Material bubble = BLACK.withReflection(1).withTransparency(1, 1.5).withFresnel(Fresnel.TRUE).withThin(true);
        Scene scene = Scene.EMPTY.withBackground(Rgb.WHITE).withCamera(Camera.looking(new Vec3(0, 0, 5), new Vec3(0, 0, -1)))
                .withSettings(new RenderSettings(33, 33, 3, 1)).plus(SceneObject.of(new Sphere(1)).madeOf(bubble));
        double pane = 2 * 0.04 / 1.04;
        // Mirrored at the front, and through both walls; what is mirrored within is beyond the depth.
        assertThat((double) Renderer.render(scene).red(16, 16)).isCloseTo(pane + (1 - pane) * (1 - pane), within(1e-6));
    }
}
