package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.integrate.Paths;
import cz.paprsek.render.sample.PassSums;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.surface.World;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;

/**
 * How often the truth is as near as a pixel says, and that few say nothing: of scenes whose brightness is known, all pixels looking at one point. Some pixels in the gate;
 * with -Dpaths.pixels=100000 as many as tell the last percent.
 */
class CoverageTest {
    private static final int PIXELS = Integer.getInteger("paths.pixels", 100);
    private static final double CONFIDENCE = 0.95;
    /** Of a lamp 2 above a mirror. */
    private static final double SMALL = 0.15;
    private static final Material GREY = Material.DEFAULT.withDiffusion(0.6);

    private final TestReporter reporter;

    CoverageTest(TestReporter reporter) {
        this.reporter = reporter;
    }

    @Test
    void anIntegratingSphereIsAsNearAsItsPixelsSay() {
        Vec3 lamp = new Vec3(0.5, 0.2, 0.1);
        Scene sphere = Scene.EMPTY.plus(SceneObject.of(new Sphere(1)).madeOf(GREY)).withLights(List.of(new PointLight("lamp", lamp, Rgb.WHITE, 0.3, 1)));
        Vec3 towards = lamp.minus(Vec3.Z);
        double direct = 0.3 * -towards.normalized().z() / towards.dot(towards);
        cover(sphere, 40, Vec3.ZERO, Vec3.Z, 0.6 * (direct + 0.6 / 0.4 * 0.3));
    }

    /** By points of the lamp and by directions of the surface. */
    @Test
    void theLightOfARectangleIsAsNearAsItsPixelsSay() {
        AreaLight light = AreaLight.rectangle(new Vec3(0, 2, 0), 1.5, 1).withRotation(new Vec3(90, 0, 0)).withIntensity(0.5).withReferenceDistance(2);
        cover(floor().withLights(List.of(light)), 1, new Vec3(0, 1, 0), new Vec3(0, -1, 0), straightBelow(Math.PI * 0.5 * 4 / 1.5) / Math.PI);
    }

    /** Nothing but chance finds a body that glows, small and bright: few paths bring all the light. */
    @Test
    void theLightThatFewPathsBringIsAsNearAsItsPixelsSay() {
        SceneObject body = SceneObject.of(new Rectangle(-0.75, -0.5, 0.75, 0.5)).rotated(90, 0, 0).at(0, 2, 0)
                .madeOf(Material.DEFAULT.withDiffusion(0).withEmission(Rgb.WHITE, 4));
        cover(floor().plus(body), 1, new Vec3(0, 1, 0), new Vec3(0, -1, 0), straightBelow(4) / Math.PI);
    }

    /** A small bright lamp in a rough mirror, by points of it and by directions of the mirror; the truth is by points alone, as of a lamp that no ray sees. */
    @Test
    void aLampInARoughMirrorIsAsNearAsItsPixelsSay() {
        SphereLight lamp = SphereLight.of(new Vec3(0, 2, 0), SMALL).withIntensity(1);
        double truth = mean(mirror().withLights(List.of(lamp.withVisible(false))));
        cover(mirror().withLights(List.of(lamp.withVisible(true))), 1, new Vec3(0.1, 1, 0), new Vec3(0, -1, 0), truth);
    }

    /** The same of a ball that glows, which nothing but directions of the mirror finds: one path of some fifty, each with very much light. */
    @Test
    void aBallThatGlowsInARoughMirrorIsAsNearAsItsPixelsSay() {
        double radiance = 1 / (SMALL * SMALL);
        double truth = mean(mirror().withLights(List.of(SphereLight.of(new Vec3(0, 2, 0), SMALL).withIntensity(1).withVisible(false))));
        SceneObject ball = SceneObject.of(new Sphere(SMALL)).at(0, 2, 0).madeOf(Material.DEFAULT.withDiffusion(0).withEmission(Rgb.WHITE, radiance));
        cover(mirror().plus(ball), 1, new Vec3(0.1, 1, 0), new Vec3(0, -1, 0), truth);
    }

    private static Scene mirror() {
        Material rough = Material.color(255, 255, 255).withDiffusion(0).withHighlight(0, 1).withReflection(0.02).withRoughness(0.5);
        return Scene.EMPTY.plus(SceneObject.of(new Rectangle(-100, -100, 100, 100)).rotated(-90, 0, 0).madeOf(rough));
    }

    /** What the point is seen to be by many paths. */
    private static double mean(Scene scene) {
        RenderSettings settings = new RenderSettings(1, 1, 1, 1).withIntegrator(Integrator.PATH).withSamples(1 << 14);
        Image image = Renderer.render(RenderScene.of(scene.withCamera(Camera.looking(new Vec3(0.1, 1, 0), new Vec3(0, -1, 0)).withFovy(0.001))), RenderOptions.of(settings), RenderMonitor.NONE).image();
        return image.red(0, 0);
    }

    private static Scene floor() {
        return Scene.EMPTY.plus(SceneObject.of(new Rectangle(-100, -100, 100, 100)).rotated(-90, 0, 0).madeOf(GREY.withDiffusion(1)));
    }

    /** E below the middle of a rectangle of 1.5 × 1, 2 above: four times that of a quarter, Lambert's formula. */
    private static double straightBelow(double radiance) {
        double a = 0.75 / 2;
        double b = 0.5 / 2;
        double p = a / Math.sqrt(1 + a * a);
        double q = b / Math.sqrt(1 + b * b);
        return 4 * radiance / 2 * (p * Math.atan(b / Math.sqrt(1 + a * a)) + q * Math.atan(a / Math.sqrt(1 + b * b)));
    }

    private void cover(Scene scene, int depth, Vec3 from, Vec3 towards, double truth) {
        int side = (int) Math.ceil(Math.sqrt(PIXELS));
        Camera camera = Camera.looking(from, towards).withFovy(0.001);
        RenderSettings settings = new RenderSettings(side, side, depth, 1).withIntegrator(Integrator.PATH).withSamples(64, 512).withError(4.0 / 255).withConfidence(CONFIDENCE);
        Passes passes = new Passes(settings, false);
        Paths paths = new Paths(new World(scene, new Textures(Assets.none()), () -> false), depth, passes);
        paths.begin(() -> false);
        Film film = new Film(new Image(side, side), 0, 0, 0, passes.kept());
        do {
            paths.block(Eye.of(camera, side, side), 0, 0, side, side, film);
        } while (film.beginPass() > 0);
        PassSums sums = passes.newSums();
        float[] kept = new float[passes.kept()];
        int covered = 0;
        int within = 0;
        int untrusted = 0;
        for (int i = 0; i < side * side; i++) {
            film.kept(i % side, i / side, kept);
            sums.load(kept, 0);
            double half = sums.interval();
            double off = Math.abs(shown(film.red(i % side, i / side)) - shown(truth));
            covered += half >= 0 && off <= half ? 1 : 0;
            within += half >= 0 && half <= settings.error() ? 1 : 0;
            untrusted += half < 0 ? 1 : 0;
        }
        String figures = String.format(Locale.ROOT, "of a brightness of %f: of %d pixels %d say how near they are, %d are as near as they say, %d within the error", truth, side * side, side * side - untrusted, covered, within);
        reporter.publishEntry(figures);
        assertThat(covered).as(figures).isGreaterThanOrEqualTo((int) (CONFIDENCE * (side * side - untrusted)));
        assertThat(untrusted).as(figures).isLessThanOrEqualTo((int) (0.05 * side * side));
    }

    private static double shown(double light) {
        return light <= 0 ? 0 : light >= 1 ? 1 : light <= 0.0031308 ? 12.92 * light : 1.055 * Math.pow(light, 1 / 2.4) - 0.055;
    }
}
