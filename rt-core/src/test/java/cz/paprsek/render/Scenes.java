package cz.paprsek.render;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Ellipsoid;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Small scenes for the tests of the renderer. */
final class Scenes {
    private Scenes() {}

    /** Black around, no ambient light, the camera at z = 5 looking along −z, an odd number of pixels so that one is in the middle. */
    static Scene empty() {
        return Scene.EMPTY.withSettings(new RenderSettings(33, 25, 8, 1))
                .withCamera(Camera.looking(new Vec3(0, 0, 5), new Vec3(0, 0, -1)));
    }

    static Material matte(double light, double diffusion) {
        return Material.color(Rgb.ofLinear(light, light, light)).withDiffusion(diffusion);
    }

    /** Bodies of every kind and material at random, on a half-space, with three lights. */
    static Scene random(long seed, int bodies) {
        Random random = new Random(seed);
        List<SceneObject> objects = new ArrayList<>();
        objects.add(SceneObject.of(new Plane()).at(0, -4, 0).madeOf(matte(0.5, 0.8)
                .withPattern(new Pattern.Checker(1, new Vec3(0, -0.5, 0), Rgb.WHITE, Rgb.grey(80)))));
        for (int i = 0; i < bodies; i++) {
            objects.add(SceneObject.of(shape(random.nextInt(10)))
                    .at(random.nextDouble() * 8 - 4, random.nextDouble() * 6 - 3, random.nextDouble() * 8 - 9)
                    .rotated(random.nextInt(360), random.nextInt(360), random.nextInt(360))
                    .scaled(0.3 + random.nextDouble(), 0.3 + random.nextDouble(), 0.3 + random.nextDouble())
                    .madeOf(material(random)));
        }
        return empty().withObjects(objects).withBackground(new Rgb(60, 90, 140)).withAmbient(Rgb.grey(40))
                .plus(Light.at(5, 6, 6).withIntensity(0.5).withColor(new Rgb(255, 220, 200)))
                .plus(Light.at(-6, 4, 3).withIntensity(0.4)).plus(Light.at(0, 8, -6).withIntensity(0.3));
    }

    /** The same bodies through a lens of any kind, in lights of any kind, with samples and a filter of any kind. */
    static Scene randomlySeen(long seed, int bodies) {
        Random random = new Random(~seed);
        Scene scene = random(seed, bodies);
        RenderSettings settings = scene.settings().withSamples(1 + random.nextInt(3)).withFilter(List.of(PixelFilter.values()).get(random.nextInt(4)));
        Camera camera = Camera.lookingAt(new Vec3(0, 0, 5), new Vec3(0, 0, -5)).withLens(lens(random));
        List<Light> lights = new ArrayList<>();
        for (int i = 1 + random.nextInt(3); i > 0; i--) {
            lights.add(light(random).withIntensity(0.2 + random.nextDouble() / 2).withColor(new Rgb(255, 128 + random.nextInt(128), random.nextInt(256))));
        }
        return scene.withCamera(camera).withLights(lights).withSettings(random.nextBoolean() ? settings : settings.withSamples(2, 3 + random.nextInt(2)));
    }

    private static Lens lens(Random random) {
        return switch (random.nextInt(5)) {
            case 0 -> new Lens.Orthographic(4 + 6 * random.nextDouble());
            case 1 -> new Lens.Spherical();
            case 2 -> new Lens.Fisheye(60 + random.nextInt(300));
            case 3 -> new Lens.Perspective(50, 0.05 + random.nextDouble() / 2, 3 + 9 * random.nextDouble());
            default -> Lens.Perspective.DEFAULT;
        };
    }

    private static Light light(Random random) {
        Vec3 place = new Vec3(random.nextDouble() * 12 - 6, 3 + random.nextDouble() * 4, random.nextDouble() * 10 - 6);
        Vec3 rotation = new Vec3(60 + random.nextInt(60), random.nextInt(60) - 30, 0);
        boolean isSeen = random.nextBoolean();
        int samples = 1 + random.nextInt(6);
        return switch (random.nextInt(7)) {
            case 0 -> Light.at(place.x(), place.y(), place.z()).withReferenceDistance(6);
            case 1 -> SpotLight.from(place, new Vec3(0, 0, -5)).withAngles(10, 10 + random.nextInt(30));
            case 2 -> SunLight.along(-place.x(), -place.y(), -place.z());
            case 3 -> SunLight.along(-place.x(), -place.y(), -place.z()).withDisc(1 + random.nextInt(20), isSeen);
            case 4 -> AreaLight.rectangle(place, 2, 1).withRotation(rotation).withReferenceDistance(6).withSamples(samples).withVisible(isSeen);
            case 5 -> AreaLight.disc(place, 1).withRotation(rotation).withReferenceDistance(6).withSamples(samples).withVisible(isSeen);
            default -> SphereLight.of(place, 0.5).withReferenceDistance(6).withSamples(samples).withVisible(isSeen);
        };
    }

    private static Shape shape(int kind) {
        return switch (kind) {
            case 0 -> new Sphere(0.8);
            case 1 -> new Block(new Vec3(-0.5, -0.5, -0.5), new Vec3(0.5, 0.7, 0.6));
            case 2 -> new Ellipsoid(new Vec3(0.4, 0.9, 0.6));
            case 3 -> new Cylinder(0.5, 1);
            case 4 -> new Cone(0.6, 0.2, 1);
            case 5 -> new Torus(0.7, 0.25);
            case 6 -> new Rectangle(-0.8, -0.6, 0.8, 0.6);
            case 7 -> new Disc(0.8);
            case 8 -> Csg.difference(Operand.of(new Sphere(0.9)), Operand.of(new Block(Vec3.ZERO, Vec3.ONE)).madeOf(matte(0.9, 0.7)));
            default -> Csg.union(Operand.of(new Sphere(0.6)), Operand.of(new Torus(0.7, 0.2)).rotated(40, 0, 0));
        };
    }

    private static Material material(Random random) {
        Material plain = Material.color(random.nextInt(256), random.nextInt(256), random.nextInt(256)).withHighlight(0.4, 20 + random.nextInt(80));
        return switch (random.nextInt(3)) {
            case 0 -> plain;
            case 1 -> plain.withDiffusion(0.3).withReflection(0.5);
            default -> plain.withDiffusion(0.1).withReflection(0.1).withTransparency(0.8, 1 + random.nextDouble());
        };
    }

    /** The three channels of a pixel. */
    static double[] pixel(Image image, int x, int y) {
        return new double[] {image.red(x, y), image.green(x, y), image.blue(x, y)};
    }

    /** The middle pixel's red channel. */
    static double middle(Scene scene) {
        Image image = Renderer.render(scene);
        return image.red(image.width() / 2, image.height() / 2);
    }

    /** The share of pixels of which a channel differs by more than the tolerance. */
    static double difference(Image a, Image b, double tolerance) {
        int beyond = 0;
        for (int y = 0; y < a.height(); y++) {
            for (int x = 0; x < a.width(); x++) {
                double most = Math.max(Math.abs(a.red(x, y) - b.red(x, y)),
                        Math.max(Math.abs(a.green(x, y) - b.green(x, y)), Math.abs(a.blue(x, y) - b.blue(x, y))));
                // Not <=: a pixel that is not a number must count.
                beyond += most <= tolerance ? 0 : 1;
            }
        }
        return beyond / (double) (a.width() * a.height());
    }
}
