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
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * How often the truth is as near as a pixel says: of scenes whose brightness has a closed form, all pixels looking at one point. Some pixels in the gate;
 * with -Dpaths.pixels=100000 as many as tell the last percent.
 */
class CoverageTest {
    private static final int PIXELS = Integer.getInteger("paths.pixels", 100);
    private static final double CONFIDENCE = 0.95;
    private static final Material GREY = Material.DEFAULT.withDiffusion(0.6);

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

    private static void cover(Scene scene, int depth, Vec3 from, Vec3 towards, double truth) {
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
        for (int i = 0; i < side * side; i++) {
            film.kept(i % side, i / side, kept);
            sums.load(kept, 0);
            double half = Math.abs(sums.interval());
            double off = Math.abs(shown(film.red(i % side, i / side)) - shown(truth));
            covered += off <= half ? 1 : 0;
            within += half <= settings.error() ? 1 : 0;
        }
        assertThat((double) covered / (side * side)).as("truth %f, %d of %d pixels within the error", truth, within, side * side).isGreaterThanOrEqualTo(CONFIDENCE);
    }

    private static double shown(double light) {
        return light <= 0 ? 0 : light >= 1 ? 1 : light <= 0.0031308 ? 12.92 * light : 1.055 * Math.pow(light, 1 / 2.4) - 0.055;
    }
}
