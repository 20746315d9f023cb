package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PlacedLight;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Solid;
import java.util.List;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Changes of a scene whose effect on the picture is known without knowing the picture. */
class MetamorphicTest {
    private static final double CLOSE = 1e-4;
    private static final double FEW = 0.001;

    private static Scene scene(long seed) {
        return Scenes.random(seed, 12).withSettings(new RenderSettings(80, 60, 5, 1));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6})
    void aSceneOfAnySizeGivesTheSamePicture(double factor) {
        for (long seed = 1; seed <= 3; seed++) {
            Scene scene = scene(seed);
            Scene scaled = mapped(scene, p -> p.times(factor), o -> placed(o, o.placement().position().times(factor), factor));
            assertThat(Scenes.difference(Renderer.render(scene), Renderer.render(scaled), CLOSE)).isLessThanOrEqualTo(0.0005);
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void movingEverythingTogetherChangesNothing(long seed) {
        Scene scene = scene(seed);
        Vec3 by = new Vec3(13, -7, 29);
        Scene moved = mapped(scene, p -> p.plus(by), o -> placed(o, o.placement().position().plus(by), 1));
        assertThat(Scenes.difference(Renderer.render(scene), Renderer.render(moved), CLOSE)).isLessThanOrEqualTo(FEW);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void turningEverythingTogetherChangesNothing(long seed) {
        Scene scene = scene(seed);
        Affine turn = Affine.rotation(new Vec3(0, 0, 37));
        // The turn about z comes last among a placement's own, so that the two add up.
        Scene turned = mapped(scene, turn::point, o -> o.placed(o.placement().withPosition(turn.point(o.placement().position()))
                .withRotation(o.placement().rotation().plus(new Vec3(0, 0, 37)))));
        Camera camera = turned.camera();
        turned = turned.withCamera(camera.withUp(turn.direction(camera.up())));
        assertThat(Scenes.difference(Renderer.render(scene), Renderer.render(turned), CLOSE)).isLessThanOrEqualTo(FEW);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void aMirroredSceneGivesTheMirroredPicture(long seed) {
        Scene scene = scene(seed);
        Image image = Renderer.render(scene);
        // A mirrored body: the same shape scaled by −1 along x in a space of its own, then turned and moved the mirrored way.
        Scene mirrored = mapped(scene, MetamorphicTest::mirrored, o -> o.placed(new Placement(mirrored(o.placement().position()),
                new Vec3(o.placement().rotation().x(), -o.placement().rotation().y(), -o.placement().rotation().z()),
                mirrored(o.placement().scale()))));
        Image other = Renderer.render(mirrored);
        Image back = new Image(image.width(), image.height());
        for (int y = 0; y < image.height(); y++) {
            for (int x = 0; x < image.width(); x++) {
                int from = image.width() - 1 - x;
                back.set(x, y, other.red(from, y), other.green(from, y), other.blue(from, y));
            }
        }
        assertThat(Scenes.difference(image, back, CLOSE)).isLessThanOrEqualTo(FEW);
    }

    @Test
    void lightIsLinear() {
        Scene scene = scene(4).withAmbient(Rgb.BLACK).withBackground(Rgb.BLACK);
        List<Light> doubled = scene.lights().stream().map(light -> light.withIntensity(2 * light.intensity())).toList();
        List<Light> split = scene.lights().stream().map(light -> light.withIntensity(light.intensity() / 2)).toList();
        Image once = Renderer.render(scene);
        Image twice = Renderer.render(scene.withLights(doubled));
        Image halves = Renderer.render(scene.withLights(java.util.stream.Stream.concat(split.stream(), split.stream()).toList()));
        Image sum = new Image(once.width(), once.height());
        for (int y = 0; y < once.height(); y++) {
            for (int x = 0; x < once.width(); x++) {
                sum.set(x, y, 2 * once.red(x, y), 2 * once.green(x, y), 2 * once.blue(x, y));
            }
        }
        assertThat(Scenes.difference(twice, sum, 1e-6)).isZero();
        assertThat(Scenes.difference(once, halves, 1e-6)).isZero();
    }

    @Test
    void opaqueBodiesApartLookTheSameAsTheirUnion() {
        Scene apart = scene(5);
        List<SceneObject> solids = apart.objects().stream().filter(o -> o.shape() instanceof Solid).map(o -> o.madeOf(Scenes.matte(0.6, 0.7))).toList();
        Csg union = Csg.union(solids.stream().map(o -> Operand.of((Solid) o.shape()).placed(o.placement())
                .madeOf(o.material())).toArray(Operand[]::new));
        // Operands of operands keep a material of their own; leave those bodies out.
        assertThat(Scenes.difference(Renderer.render(apart.withObjects(solids)),
                Renderer.render(apart.withObjects(List.of(SceneObject.of(union)))), CLOSE)).isLessThanOrEqualTo(FEW);
    }

    @Test
    void aBodyOfGlassCutIntoPiecesAndPutTogetherAgainIsTheBody() {
        Material glass = Scenes.matte(0.9, 0.1).withReflection(0.1).withTransparency(0.8, 1.5);
        Operand[] pieces = new Operand[8];
        for (int i = 0; i < 8; i++) {
            // Eight blocks with a corner in common, so that their faces coincide.
            pieces[i] = Operand.of(new Block(new Vec3(-1 + (i & 1), -1 + (i >> 1 & 1), -1 + (i >> 2)), new Vec3(i & 1, i >> 1 & 1, i >> 2)));
        }
        assertCoincide(new Block(new Vec3(-1, -1, -1), new Vec3(1, 1, 1)), Csg.union(pieces), glass);
    }

    @Test
    void aHoleCutFlushWithItsFacesIsTheOneCutBeyondThem() {
        Operand plate = Operand.of(new Block(new Vec3(-1, -1, -0.3), new Vec3(1, 1, 0.3)));
        for (Material material : List.of(Scenes.matte(0.8, 0.7), Scenes.matte(0.9, 0.1).withReflection(0.1).withTransparency(0.8, 1.5))) {
            assertCoincide(
                    Csg.difference(plate, Operand.of(new Cylinder(0.6, 0.6)).rotated(90, 0, 0).at(0, 0, -0.3)),
                    Csg.difference(plate, Operand.of(new Cylinder(0.6, 2)).rotated(90, 0, 0).at(0, 0, -1)), material);
            assertCoincide(
                    Csg.difference(plate, Operand.of(new Block(new Vec3(-0.5, -0.5, -0.3), new Vec3(0.5, 0.5, 0.3)))),
                    Csg.difference(plate, Operand.of(new Block(new Vec3(-0.5, -0.5, -2), new Vec3(0.5, 0.5, 2)))), material);
        }
    }

    @Test
    void aBlockWithoutItselfShiftedAlongAFaceIsTheSliceThatIsLeft() {
        Block block = new Block(new Vec3(-1, -1, -1), new Vec3(1, 1, 1));
        Block slice = new Block(new Vec3(-1, -1, -1), new Vec3(-0.6, 1, 1));
        assertCoincide(Csg.difference(Operand.of(block), Operand.of(block).at(0.4, 0, 0)), slice, Scenes.matte(0.8, 0.7));
    }

    /** Two descriptions of one body: the same picture, turned and unturned, but for pixels on its edges, of which few may differ. */
    private static void assertCoincide(Solid one, Solid other, Material material) {
        Scene empty = Scenes.empty().withSettings(new RenderSettings(96, 72, 6, 1)).withBackground(new Rgb(60, 90, 140))
                .plus(Light.at(4, 5, 6).withIntensity(0.6)).plus(Light.at(-3, 2, 5).withIntensity(0.3))
                .plus(SceneObject.of(new Plane()).at(0, -1.5, 0).madeOf(Scenes.matte(0.5, 0.7)));
        for (Vec3 turn : List.of(Vec3.ZERO, new Vec3(20, 30, 0), new Vec3(-35, 50, 15), new Vec3(90, 0, 0))) {
            Image a = Renderer.render(empty.plus(SceneObject.of(one).rotated(turn.x(), turn.y(), turn.z()).madeOf(material)));
            Image b = Renderer.render(empty.plus(SceneObject.of(other).rotated(turn.x(), turn.y(), turn.z()).madeOf(material)));
            assertThat(Scenes.difference(a, b, CLOSE)).as("stray pixels of %s turned by %s", one, turn).isLessThanOrEqualTo(2 / 6912.0);
        }
    }

    private static Vec3 mirrored(Vec3 v) {
        return new Vec3(-v.x(), v.y(), v.z());
    }

    private static SceneObject placed(SceneObject object, Vec3 position, double factor) {
        return object.placed(object.placement().withPosition(position).withScale(object.placement().scale().times(factor)));
    }

    private static Scene mapped(Scene scene, UnaryOperator<Vec3> point, UnaryOperator<SceneObject> object) {
        Camera camera = scene.camera();
        Vec3 direction = point.apply(camera.position().plus(camera.forward())).minus(point.apply(camera.position()));
        return scene.withObjects(scene.objects().stream().map(object).toList())
                .withLights(scene.lights().stream().map(PlacedLight.class::cast).<Light>map(light -> light.withPosition(point.apply(light.position()))).toList())
                .withCamera(camera.withPosition(point.apply(camera.position())).withAim(new Camera.Direction(direction)));
    }
}
