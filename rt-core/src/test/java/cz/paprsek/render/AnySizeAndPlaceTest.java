package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PlacedLight;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.Placement;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.function.UnaryOperator;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The shipped scenes and the hard ones, moved far away, made tiny and huge, and seen from far away: the same pictures. */
class AnySizeAndPlaceTest {
    private static final Vec3 FAR = new Vec3(5.5e6, -5.5e6, 5.5e6);

    @ParameterizedTest
    @ValueSource(strings = {
        "showcase", "primitives", "csg", "glass", "lens", "mirrors", "checkers", "lights", "placement", "dice", "chess", "pane0", "stand-1e-7", "far1e5"
    })
    void aSceneIsTheSameAtAnyPlaceAndOfAnySize(String name) throws Exception {
        Scene scene = small(name);
        Image picture = Renderer.render(scene);
        assertThat(apart(picture, Renderer.render(mapped(scene, p -> p.plus(FAR), 1)))).as("moved").isLessThanOrEqualTo(0.001);
        for (double factor : new double[] {1e-6, 1e-3, 1e6}) {
            assertThat(apart(picture, Renderer.render(mapped(scene, p -> p.times(factor), factor)))).as("scaled by %s", factor)
                    .isLessThanOrEqualTo(0.001);
        }
        assertThat(apart(picture, Renderer.render(mapped(scene, p -> p.times(1e-6).plus(new Vec3(3, 2, 1)), 1e-6))))
                .as("tiny, a million of its sizes from the origin").isLessThanOrEqualTo(0.001);
    }

    @ParameterizedTest
    @ValueSource(strings = {"showcase", "primitives", "csg", "lens", "checkers", "lights", "placement", "dice", "stand-1e-7"})
    void aSceneSeenFromAMillionAwayIsTheOneSeenFromATenthOfThat(String name) throws Exception {
        assertThat(apart(Renderer.render(from(small(name), 1e5)), Renderer.render(from(small(name), 1e6)))).isLessThanOrEqualTo(0.001);
    }

    /** The share of pixels that differ by more than 1/255 in a channel. */
    static double apart(Image a, Image b) {
        int[] first = a.toArgb();
        int[] second = b.toArgb();
        int beyond = 0;
        for (int i = 0; i < first.length; i++) {
            boolean differs = false;
            for (int shift = 0; shift < 24; shift += 8) {
                differs |= Math.abs((first[i] >> shift & 255) - (second[i] >> shift & 255)) > 1;
            }
            beyond += differs ? 1 : 0;
        }
        return (double) beyond / first.length;
    }

    /** A size such that no ray through a pixel's centre runs exactly along a line of the scene, where rounding alone decides. */
    private static Scene small(String name) throws Exception {
        Path shipped = Path.of("../scenes", name + ".xml");
        Scene scene = SceneFiles.read(shipped.toFile().exists() ? shipped : Path.of("src/test/resources/cz/paprsek/render/touching", name + ".xml"));
        return scene.withSettings(scene.settings().withSize(113, 83).withSamples(1));
    }

    private static Scene from(Scene scene, double distance) {
        Camera camera = scene.camera();
        Vec3 target = camera.position().plus(camera.forward().times(camera.position().length()));
        double height = camera.lens().heightAt(camera.position().length());
        return scene.withCamera(camera.withPosition(target.minus(camera.forward().times(distance)))
                .withAim(new Camera.Direction(camera.forward())).withFovy(2 * Math.toDegrees(Math.atan(height / 2 / distance))));
    }

    private static Scene mapped(Scene scene, UnaryOperator<Vec3> point, double factor) {
        Camera camera = scene.camera();
        return scene.withObjects(scene.objects().stream().map(object -> {
                    Placement placement = object.placement();
                    return object.placed(placement.withPosition(point.apply(placement.position())).withScale(placement.scale().times(factor)));
                }).toList())
                .withLights(scene.lights().stream().map(PlacedLight.class::cast).<Light>map(light -> light.withPosition(point.apply(light.position()))).toList())
                .withCamera(camera.withPosition(point.apply(camera.position())).withAim(new Camera.Direction(camera.forward())));
    }
}
