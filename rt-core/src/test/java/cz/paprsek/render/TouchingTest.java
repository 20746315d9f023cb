package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Rays know what they left: nothing shades itself, and nothing that touches it is lost. */
class TouchingTest {
    private static final Material GLASS = Material.color(240, 250, 255).withDiffusion(0.1).withHighlight(0.5, 60).withReflection(0.1)
            .withTransparency(0.8, 1.5);
    private static final Material WATER = GLASS.withTransparency(0.75, 1.33).withReflection(0.05);
    private static final Material MIRROR = Scenes.matte(0.6, 0.3).withReflection(0.6);
    private static final double GAP = 1e-7;

    private static Scene read(String name) throws Exception {
        return SceneFiles.read(Path.of("src/test/resources/cz/paprsek/render/touching", name + ".xml"));
    }

    @ParameterizedTest
    @CsvSource({"pane0, pane5.5e6, 60, 45, 207 144 140", "stand, stand-1e-7, 70, 28, 201 204 210", "slabs, slabs6, 50, 50, 0 0 255", "far1e5, far1e6, 60, 45, "})
    void pairsOfScenesThatShouldNotDifferDoNot(String one, String other, int column, int row, String srgb) throws Exception {
        assertThat(AnySizeAndPlaceTest.apart(Renderer.render(read(one)), Renderer.render(read(other)))).isLessThanOrEqualTo(0.001);
        for (String name : srgb == null ? new String[0] : new String[] {one, other}) {
            Image picture = Renderer.render(read(name));
            int argb = picture.toArgb()[row * picture.width() + column];
            assertThat((argb >> 16 & 255) + " " + (argb >> 8 & 255) + " " + (argb & 255)).as(name).isEqualTo(srgb);
        }
    }

    @Test
    void glassLyingFlushOnWaterLetsTheRayOutAtTheAngleItCameInAt() throws Exception {
        TracedRay ray = RenderScene.of(read("slabs")).explain(50, 50).rays().get(0);
        while (ray.encounter().orElseThrow().refracted().isPresent()) {
            ray = ray.encounter().orElseThrow().refracted().get();
        }
        assertThat(ray.encounter().orElseThrow().place().cosine()).isCloseTo(Math.sqrt(0.5), org.assertj.core.api.Assertions.within(1e-9));
    }

    /** So little of a ring ten thousand times as large as it is thick is a straight rod: evenly lit, without spots. */
    @Test
    void aStretchOfAVastRingIsARod() throws Exception {
        Scene ring = read("t1e4");
        Scene rod = ring.withObjects(List.of(SceneObject.of(new Cylinder(1, 40)).rotated(0, 0, 90).at(20, 0, 0)));
        assertThat(AnySizeAndPlaceTest.apart(Renderer.render(ring), Renderer.render(rod))).isLessThanOrEqualTo(0.001);
        int[] middle = Arrays.copyOfRange(Renderer.render(ring).toArgb(), 60 * 12, 60 * 28);
        assertThat(Arrays.stream(middle)).as("none is black").allMatch(argb -> (argb & 255) > 30);
    }

    /** Shapes, the point to look at, and how large a stretch about it. */
    static Stream<Arguments> hardShapes() {
        return Stream.of(
                Arguments.of("ring 10 000 : 1", SceneObject.of(new Torus(1e4, 1)).at(-1e4, 0, 0), Vec3.ZERO, 4),
                Arguments.of("ring 1 000 000 : 1", SceneObject.of(new Torus(1e6, 1)).at(0, 0, -1e6), Vec3.ZERO, 4),
                Arguments.of("fat ring of 1e7", turned(new Torus(2e7, 1e7)), Vec3.ZERO, 6e7),
                Arguments.of("ring without a hole", turned(new Torus(1, 1)), Vec3.ZERO, 4),
                Arguments.of("needle", turned(new Cone(1e-3, 1)), Vec3.ZERO, 4e-3),
                Arguments.of("tip of a long needle", SceneObject.of(new Cone(1e-2, 1e4)).at(0, -1e4 + 10, 0), Vec3.ZERO, 1e-4),
                Arguments.of("coin thinner than a hair", turned(new Cylinder(1, 1e-9)), Vec3.ZERO, 2),
                Arguments.of("wire", turned(new Cylinder(1e-6, 1)), Vec3.ZERO, 4e-6),
                Arguments.of("sheet", turned(new Block(new Vec3(-1, -1, 0), new Vec3(1, 1, 1e-9))), Vec3.ZERO, 2),
                Arguments.of("hole cut flush", turned(Csg.difference(new Block(new Vec3(-1, 0, -1), new Vec3(1, 1, 1)), new Cylinder(0.5, 1))),
                        Vec3.ZERO, 3),
                Arguments.of("lens of two balls", turned(Csg.intersection(Operand.of(new Sphere(1)), Operand.of(new Sphere(1)).at(0, 1.9, 0)))
                        .at(0, -0.9, 0), Vec3.ZERO, 1),
                Arguments.of("nested", turned(Csg.difference(Operand.of(Csg.union(new Sphere(1), new Cylinder(0.5, 2))),
                        Operand.of(Csg.intersection(new Torus(0.8, 0.3), new Block(new Vec3(0, -1, -1), new Vec3(1, 1, 1)))))), Vec3.ZERO, 3),
                Arguments.of("ball far away", SceneObject.of(new Sphere(1e-3)).at(1e4, 1e4, 1e4), new Vec3(1e4, 1e4, 1e4), 2e-3),
                Arguments.of("tiny, far from the origin", turned(new Torus(1e-6, 4e-7)).at(3, 2, 1), new Vec3(3, 2, 1), 3e-6),
                Arguments.of("stretched ball", SceneObject.of(new Sphere(1)).scaled(1, 1e-4, 1).rotated(30, 20, 10), Vec3.ZERO, 2));
    }

    private static SceneObject turned(Shape shape) {
        return SceneObject.of(shape).rotated(35, 20, 10);
    }

    /** From a lamp in the eye, light goes the way the eye's rays come. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("hardShapes")
    void whatIsSeenFromALampIsLitByIt(String name, SceneObject object, Vec3 middle, double size) {
        for (Vec3 from : List.of(new Vec3(0, 0.3, 1), new Vec3(1, 0.8, 0.2), new Vec3(0.2, -1, -0.6))) {
            Vec3 eye = middle.plus(from.times(2 * size));
            RenderScene scene = RenderScene.of(Scene.EMPTY.withSettings(new RenderSettings(30, 20, 1, 1))
                    .withCamera(Camera.lookingAt(eye, middle).withFovy(30))
                    .plus(Light.at(eye.x(), eye.y(), eye.z())).plus(object.madeOf(Scenes.matte(1, 1))));
            int seen = 0;
            for (int i = 0; i < 600; i++) {
                var met = scene.explain(i % 30, i / 30).rays().get(0).encounter();
                if (met.isPresent() && met.get().lights().get(0).ray().facing() > 0) {
                    seen++;
                    assertThat(met.get().lights().get(0).visibility()).as("%s from %s at %d", name, from, i).isEqualTo(1);
                }
            }
            assertThat(seen).as("pixels of %s from %s", name, from).isGreaterThan(10);
        }
    }

    /** Bodies that touch, and the same with a gap, or an overlap, too small to see. */
    static Stream<Arguments> touchingBodies() {
        Block cube = new Block(new Vec3(-0.7, 0, -0.7), new Vec3(0.7, 1.4, 0.7));
        SceneObject glass = SceneObject.of(cube).rotated(0, 30, 0).madeOf(GLASS);
        SceneObject floor = SceneObject.of(new Plane()).madeOf(Scenes.matte(0.7, 0.8));
        SceneObject rectangle = SceneObject.of(new Rectangle(-9, -9, 9, 9)).rotated(-90, 0, 0).madeOf(MIRROR);
        SceneObject ball = SceneObject.of(new Sphere(1000)).at(0, -1000, 0).madeOf(Scenes.matte(0.7, 0.8));
        SceneObject room = SceneObject.of(new Block(new Vec3(-9, 0, -9), new Vec3(9, 9, 9))).madeOf(Scenes.matte(0.6, 0.7));
        SceneObject label = SceneObject.of(new Disc(0.5)).rotated(-90, 0, 0).at(0, 1.4, 0).madeOf(Material.color(200, 60, 60));
        SceneObject tumbler = SceneObject.of(Csg.difference(Operand.of(new Cylinder(0.8, 1.6)), Operand.of(new Cylinder(0.7, 2)).at(0, 0.1, 0)))
                .madeOf(GLASS);
        return Stream.of(
                Arguments.of("glass on a half-space", List.of(glass, floor), List.of(glass.at(0, GAP, 0), floor)),
                Arguments.of("glass on a mirror", List.of(rectangle, glass), List.of(rectangle, glass.at(0, GAP, 0))),
                Arguments.of("glass on a large ball", List.of(glass, ball), List.of(glass, ball.at(0, -1000 - GAP, 0))),
                Arguments.of("glass in a room", List.of(room, glass), List.of(room, glass.at(0, GAP, 0))),
                Arguments.of("an opaque block on a mirror", List.of(rectangle, glass.madeOf(MIRROR)), List.of(rectangle, glass.madeOf(MIRROR).at(0, GAP, 0))),
                Arguments.of("a label told before what it lies on", List.of(label, glass, floor), List.of(label.at(0, 1.4 + GAP, 0), glass.at(0, 0, 0), floor)),
                Arguments.of("a label told after what it lies on", List.of(glass, label, floor), List.of(glass, label.at(0, 1.4 + GAP, 0), floor)),
                Arguments.of("a mirror told after what it lies on", List.of(glass, label.madeOf(MIRROR), floor), List.of(glass, label.madeOf(MIRROR).at(0, 1.4 + GAP, 0), floor)),
                Arguments.of("two panes", List.of(glass, SceneObject.of(cube).rotated(0, 30, 0).at(0, 1.4, 0).madeOf(WATER), floor),
                        List.of(glass, SceneObject.of(cube).rotated(0, 30, 0).at(0, 1.4 - GAP, 0).madeOf(WATER), floor)),
                Arguments.of("water in a tumbler", List.of(floor, tumbler, water(0.7, 0.1)), List.of(floor, tumbler, water(0.7 + GAP, 0.1 - GAP))),
                Arguments.of("water in a tumbler, told first", List.of(water(0.7, 0.1), tumbler, floor), List.of(water(0.7 + GAP, 0.1 - GAP), tumbler, floor)));
    }

    /** Each a ten thousandth of the distance within which rounding may decide: a pile that is left is not entered again from where it was. */
    @Test
    void aPileOfPanesThinnerThanContactsFarAwayIsTheOneHere() {
        Material clear = new Material(new Pattern.Plain(Rgb.BLACK), 0, 0, 30, 0, 1, 1.5);
        List<SceneObject> pile = new ArrayList<>(List.of(SceneObject.of(new Plane()).madeOf(Scenes.matte(0.7, 0.8))));
        for (int i = 0; i < 5; i++) {
            pile.add(SceneObject.of(new Block(new Vec3(-1, 1e-7 * i, -1), new Vec3(1, 1e-7 * (i + 1), 1))).rotated(17, 21, 5).at(0, 1, 0).madeOf(clear));
        }
        Image here = Renderer.render(onTable(pile, Vec3.ZERO).withSettings(new RenderSettings(97, 71, 25, 1)));
        Image far = Renderer.render(onTable(pile, new Vec3(5.5e6, -5.5e6, 5.5e6)).withSettings(new RenderSettings(97, 71, 25, 1)));
        assertThat(AnySizeAndPlaceTest.apart(here, far)).isLessThanOrEqualTo(0.001);
    }

    private static SceneObject water(double radius, double from) {
        return SceneObject.of(new Cylinder(radius, 1.2 - from)).at(0, from, 0).madeOf(WATER);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("touchingBodies")
    void bodiesThatTouchLookLikeThoseTooNearToSeeBetween(String name, List<SceneObject> touching, List<SceneObject> apart) {
        for (Vec3 moved : List.of(Vec3.ZERO, new Vec3(0.1, 0.3, 0.7), new Vec3(1000.1, 0.7, -2000.3))) {
            Image one = Renderer.render(onTable(touching, moved));
            Image other = Renderer.render(onTable(apart, moved));
            assertThat(AnySizeAndPlaceTest.apart(one, other)).as("%s, moved by %s", name, moved).isLessThanOrEqualTo(0.001);
        }
    }

    private static Scene onTable(List<SceneObject> objects, Vec3 moved) {
        Vec3 target = moved.plus(new Vec3(0, 0.7, 0));
        return Scene.EMPTY.withSettings(new RenderSettings(97, 71, 9, 1)).withBackground(new Rgb(90, 130, 190)).withAmbient(Rgb.grey(60))
                .withCamera(Camera.lookingAt(target.plus(new Vec3(1.3, 1.7, 4.1)), target).withFovy(35))
                .plus(Light.at(moved.x() + 3, moved.y() + 5, moved.z() + 4).withIntensity(0.7))
                .plus(Light.at(moved.x() - 4, moved.y() + 3, moved.z() + 2).withIntensity(0.3))
                .withObjects(objects.stream().map(o -> o.placed(o.placement().withPosition(o.placement().position().plus(moved)))).toList());
    }

    /** Figures in one plane, each turned and placed in its own way: of every pixel that both cover the first one is seen, without speckles. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 1, 1e5})
    void ofFiguresInOnePlaneTheFirstIsSeen(double size) {
        SceneObject disc = SceneObject.of(new Disc(size)).rotated(90, 25, 0).at(0.3, 0.7, 0.1).madeOf(Material.color(200, 60, 60));
        SceneObject square = SceneObject.of(new Rectangle(-3, -3, 3, 3)).scaled(size, size, size).rotated(-90, 0, 0).at(0.3, 0.7, 0.1)
                .madeOf(Scenes.matte(0.8, 0.8));
        SceneObject block = SceneObject.of(new Block(new Vec3(-2, -1, -2), new Vec3(2, 0, 2))).scaled(size, size, size).rotated(0, 40, 0)
                .at(0.3, 0.7, 0.1).madeOf(MIRROR);
        Vec3 middle = new Vec3(0.3, 0.7, 0.1);
        Scene scene = Scene.EMPTY.withSettings(new RenderSettings(80, 60, 3, 1))
                .withCamera(Camera.lookingAt(middle.plus(new Vec3(1, 0.4, 4).times(size)), middle).withFovy(30))
                .plus(Light.at(0.3 + size, 0.7 + 3 * size, size));
        for (List<SceneObject> order : List.of(List.of(disc, square, block), List.of(disc, block, square), List.of(block, disc, square))) {
            RenderScene all = RenderScene.of(scene.withObjects(order));
            RenderScene first = RenderScene.of(scene.withObjects(order.subList(0, 1)));
            int seen = 0;
            for (int i = 0; i < 4800; i++) {
                var alone = first.explain(i % 80, i / 80).rays().get(0).encounter();
                if (alone.isPresent() && Math.abs(alone.get().place().normal().y()) > 0.9) {
                    seen++;
                    var met = all.explain(i % 80, i / 80).rays().get(0).encounter().orElseThrow();
                    assertThat(met.place().surface().part().object().index()).as("at pixel %d", i).isZero();
                    assertThat(met.lights().get(0).visibility()).as("light at pixel %d", i).isEqualTo(1);
                }
            }
            assertThat(seen).isGreaterThan(100);
        }
    }
}
