package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
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
    @ValueSource(doubles = {1e-6, 1e-3, 1e3, 1e6})
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
        Scene scene = scene(4).withAmbient(cz.paprsek.material.Rgb.BLACK).withBackground(cz.paprsek.material.Rgb.BLACK);
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
        List<SceneObject> solids = apart.objects().stream().filter(o -> o.shape() instanceof cz.paprsek.shape.Solid).map(o -> o.madeOf(Scenes.matte(0.6, 0.7))).toList();
        Csg union = Csg.union(solids.stream().map(o -> Operand.of((cz.paprsek.shape.Solid) o.shape()).placed(o.placement())
                .madeOf(o.material())).toArray(Operand[]::new));
        // Operands of operands keep a material of their own; leave those bodies out.
        assertThat(Scenes.difference(Renderer.render(apart.withObjects(solids)),
                Renderer.render(apart.withObjects(List.of(SceneObject.of(union)))), CLOSE)).isLessThanOrEqualTo(FEW);
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
                .withLights(scene.lights().stream().map(light -> light.withPosition(point.apply(light.position()))).toList())
                .withCamera(camera.withPosition(point.apply(camera.position())).withAim(new Camera.Direction(direction)));
    }
}
