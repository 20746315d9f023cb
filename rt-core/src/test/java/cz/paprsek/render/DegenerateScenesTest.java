package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Examples;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever a scene that can be made says, its picture consists of finite numbers. */
class DegenerateScenesTest {
    private static final double[] MAGNITUDES = {1e-44, 1e-30, 1e-15, 1e-6, 1, 1e6, 1e15, 1e30, 1e44};
    private static final Material GLASS = Material.color(230, 240, 255).withDiffusion(0.2).withHighlight(0.7, 80).withReflection(0.2)
            .withTransparency(0.7, 1.5);

    static Stream<Shape> shapes() {
        return Examples.ALL.values().stream();
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void shapesOfAnySizeAnywhereGiveFinitePixels(Shape shape) {
        for (double size : MAGNITUDES) {
            for (double away : MAGNITUDES) {
                SceneObject object = SceneObject.of(shape).madeOf(GLASS).scaled(size, size, size);
                assertFinite(seen(object, away), shape + " of size " + size + " seen from " + away);
                // A body of several parts must not be drawn out as far: that is refused.
                double others = shape instanceof Csg ? size : 1;
                assertFinite(seen(object.at(away, -away, away).scaled(size, others, others), 5), shape + " of width " + size + " at " + away);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void operandsOfAnySizeAnywhereGiveFinitePixels(Shape shape) {
        if (shape instanceof Solid solid) {
            for (double size : MAGNITUDES) {
                for (double away : MAGNITUDES) {
                    Operand other = Operand.of(solid).placed(new Placement(new Vec3(away, 0, 0), new Vec3(10, 20, 30), new Vec3(size, size, size)));
                    for (Csg.Operation operation : Csg.Operation.values()) {
                        Csg both = new Csg(operation, List.of(Operand.of(new Sphere(1)), other));
                        assertFinite(seen(SceneObject.of(both).madeOf(GLASS), 4), operation + " with " + shape + " of size " + size + " at " + away);
                    }
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-300, 0.01, 0.5, 1, 1.0000001, 2.4, 100})
    void anyRefractiveIndexGivesFinitePixels(double index) {
        for (double shininess : new double[] {0, 1e-300, 0.5, 1, 1e6}) {
            Material material = GLASS.withTransparency(1, index).withHighlight(1, shininess).withReflection(1);
            SceneObject ball = SceneObject.of(new Sphere(1)).madeOf(material);
            assertFinite(seen(ball, 3), "index " + index);
            assertFinite(seen(ball, 0.5), "index " + index + " from inside");
            assertFinite(seen(ball, 1), "index " + index + " from the surface");
        }
    }

    @Test
    void coincidentObjectsGiveFinitePixels() {
        for (Shape shape : Examples.ALL.values()) {
            SceneObject object = SceneObject.of(shape).madeOf(GLASS);
            Scene scene = seen(object, 3);
            assertFinite(scene.withObjects(List.of(object, object, object.madeOf(Material.DEFAULT), object)), shape + " four times");
        }
    }

    @Test
    void lightsAndCamerasOnAndInAndFarFromBodiesGiveFinitePixels() {
        SceneObject ball = SceneObject.of(new Sphere(1)).madeOf(GLASS);
        for (double where : new double[] {0, 1e-300, 0.5, 1, Math.nextUp(1.0), Math.nextDown(1.0), 2, 1e30, 1e45}) {
            for (double intensity : new double[] {0, 1e-300, 1, 1e12}) {
                Scene scene = seen(ball, 3).withLights(List.of(Light.at(0, 0, where).withIntensity(intensity)));
                assertFinite(scene, "light at " + where + " of intensity " + intensity);
                assertFinite(scene.withCamera(Camera.looking(new Vec3(0, 0, where), new Vec3(0, 0, -1))), "camera and light at " + where);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-300, 1e-9, 179.9999999, 179.99999999999997})
    void anyFieldOfViewGivesFinitePixels(double fovy) {
        Scene scene = seen(SceneObject.of(new Sphere(1)).madeOf(GLASS), 3);
        assertFinite(scene.withCamera(scene.camera().withFovy(fovy)), "fovy " + fovy);
    }

    @Test
    void wildScenesGiveFinitePixels() {
        for (int seed = 0; seed < 200; seed++) {
            Random random = new Random(seed);
            Scene scene = Scenes.random(seed, 5);
            List<SceneObject> wild = new ArrayList<>();
            for (SceneObject object : scene.objects()) {
                Placement placement = new Placement(wild(random), wild(random),
                        object.shape() instanceof Csg ? object.placement().scale() : wild(random));
                wild.add(object.placed(placement));
            }
            Vec3 eye = wild(random);
            Camera camera = Camera.looking(eye, wild(random)).withUp(new Vec3(0.3, 0.5, 0.1));
            assertFinite(scene.withObjects(wild).withCamera(camera), "seed " + seed);
        }
    }

    /** Up to 1e44 in one direction, ordinary in the others. */
    private static Vec3 wild(Random random) {
        double size = Math.pow(10, random.nextInt(88) - 44);
        return new Vec3(size * (1 + random.nextDouble()), random.nextBoolean() ? random.nextGaussian() : size, random.nextGaussian());
    }

    /** The object at the origin, seen from so far along z, with a light behind the camera and one to the side. */
    private static Scene seen(SceneObject object, double away) {
        return Scene.EMPTY.withSettings(new RenderSettings(8, 8, 8, 1)).withObjects(List.of(object))
                .withCamera(Camera.looking(new Vec3(0, 0, away), new Vec3(0.01, 0.02, -1)))
                .plus(Light.at(away, away, away)).plus(Light.at(3, 0, 0.5));
    }

    private static void assertFinite(Scene scene, String what) {
        Image image = Renderer.render(scene);
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                double sum = image.red(x, y) + image.green(x, y) + image.blue(x, y);
                assertThat(Double.isFinite(sum)).as(() -> what).isTrue();
            }
        }
    }
}
