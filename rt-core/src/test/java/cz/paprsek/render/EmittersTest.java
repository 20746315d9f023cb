package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import cz.paprsek.image.Image;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
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
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.mesh.Triangles;
import cz.paprsek.warning.SceneWarning;
import cz.paprsek.warning.SceneWarnings;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Bodies that shine are looked for by paths as lights are. */
class EmittersTest {
    private static final double RADIANCE = 3;
    private static final double HEIGHT = 2;
    private static final double ALBEDO = 0.5;
    private static final Material GLOW = Material.DEFAULT.withDiffusion(0).withHighlight(0, 1).withEmission(new Rgb(255, 200, 90), RADIANCE);
    private static final Scene FLOOR = Scene.EMPTY.withCamera(Camera.lookingAt(new Vec3(0, 1, 4), Vec3.ZERO))
            .plus(SceneObject.of(new Rectangle(-9, -9, 9, 9)).rotated(-90, 0, 0).madeOf(Material.DEFAULT.withDiffusion(ALBEDO)))
            .plus(SceneObject.of(new Sphere(0.3)).at(0.8, 0.3, 0).madeOf(Material.DEFAULT.withDiffusion(0.3).withReflection(0.4).withRoughness(0.5)));

    private static SceneObject hung(Shape shape) {
        return SceneObject.of(shape).rotated(90, 0, 0).at(0, HEIGHT, 0).madeOf(GLOW);
    }

    private static Image picture(Scene scene, int side, int paths) {
        return Renderer.render(scene.withSettings(new RenderSettings(side, side, 3, 1).withIntegrator(Integrator.PATH).withSamples(paths)));
    }

    static Stream<Arguments> bodiesAndLights() {
        AreaLight sheet = AreaLight.rectangle(new Vec3(0, HEIGHT, 0), 1.5, 1).withRotation(new Vec3(90, 0, 0));
        AreaLight disc = AreaLight.disc(new Vec3(0, HEIGHT, 0), 0.6).withRotation(new Vec3(90, 0, 0));
        return Stream.of(Arguments.of(hung(new Rectangle(-0.75, -0.5, 0.75, 0.5)), sheet.withIntensity(RADIANCE * 1.5 / Math.PI)),
                Arguments.of(hung(new Disc(0.6)), disc.withIntensity(RADIANCE * 0.36)),
                Arguments.of(hung(new Disc(1)).scaled(0.6, 0.6, 2), disc.withIntensity(RADIANCE * 0.36)),
                Arguments.of(hung(new Sphere(0.5)), SphereLight.of(new Vec3(0, HEIGHT, 0), 0.5).withIntensity(RADIANCE * 0.25)),
                Arguments.of(hung(new Sphere(1)).scaled(0.5, 0.5, 0.5), SphereLight.of(new Vec3(0, HEIGHT, 0), 0.5).withIntensity(RADIANCE * 0.25)));
    }

    /** What is random for the first light is so for the first body that shines where there are no lights: the pictures differ by rounding only. */
    @ParameterizedTest
    @MethodSource("bodiesAndLights")
    void aBodyThatShinesIsALightOfItsRadiance(SceneObject body, Light light) {
        Image one = picture(FLOOR.plus(body), 16, 16);
        Image other = picture(FLOOR.withLights(List.of(light.withColor(new Rgb(255, 200, 90)))), 16, 16);
        for (int i = 0; i < 16 * 16; i++) {
            assertThat(one.red(i % 16, i / 16)).isCloseTo(other.red(i % 16, i / 16), within(1e-5f));
            assertThat(one.blue(i % 16, i / 16)).isCloseTo(other.blue(i % 16, i / 16), within(1e-5f));
        }
    }

    static Stream<Arguments> closedForms() {
        // From a corner of a rectangle a·b at the distance 1: Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-4.
        double a = 0.75 / HEIGHT;
        double b = 0.5 / HEIGHT;
        double corner = (a / Math.sqrt(1 + a * a) * Math.atan(b / Math.sqrt(1 + a * a)) + b / Math.sqrt(1 + b * b) * Math.atan(a / Math.sqrt(1 + b * b))) / (2 * Math.PI);
        return Stream.of(Arguments.of(new Rectangle(-0.75, -0.5, 0.75, 0.5), 4 * corner), Arguments.of(new Block(new Vec3(-0.75, -0.5, -1), new Vec3(0.75, 0.5, 0), 0), 4 * corner),
                Arguments.of(new Disc(0.6), 0.36 / (HEIGHT * HEIGHT + 0.36)), Arguments.of(new Sphere(0.5), 0.25 / (HEIGHT * HEIGHT)));
    }

    @ParameterizedTest
    @MethodSource("closedForms")
    void whatFallsBelowItIsThatOfTheClosedForm(Shape shape, double share) {
        Scene scene = FLOOR.withObjects(FLOOR.objects().subList(0, 1)).withCamera(Camera.lookingAt(new Vec3(0, 0.1, 0), Vec3.ZERO).withFovy(0.1)).plus(hung(shape));
        Image image = Renderer.render(scene.withSettings(new RenderSettings(1, 1, 1, 1).withIntegrator(Integrator.PATH).withSamples(2048)));
        double expected = ALBEDO * RADIANCE * share;
        assertThat((double) image.red(0, 0)).isCloseTo(expected, within(0.002 * expected));
    }

    /** A sheet 1.5 × 1 in squares of two triangles each. */
    private static Mesh sheet(int columns, int rows) {
        double[] places = new double[3 * (columns + 1) * (rows + 1)];
        for (int i = 0; i < places.length / 3; i++) {
            int row = i / (columns + 1);
            places[3 * i] = 1.5 * (i % (columns + 1)) / columns - 0.75;
            places[3 * i + 1] = (double) row / rows - 0.5;
        }
        int[] corners = new int[6 * columns * rows];
        for (int i = 0; i < columns * rows; i++) {
            int at = i / columns * (columns + 1) + i % columns;
            System.arraycopy(new int[] {at, at + 1, at + columns + 2, at, at + columns + 2, at + columns + 1}, 0, corners, 6 * i, 6);
        }
        return Mesh.of(Triangles.of(places, corners));
    }

    /** Few triangles are looked for each; of many one is chosen at a time. */
    @ParameterizedTest
    @ValueSource(ints = {1, 12})
    void trianglesShineAsTheSheetThatTheyAre(int perSide) {
        whatFallsBelowItIsThatOfTheClosedForm(sheet(perSide, perSide), (double) closedForms().findFirst().orElseThrow().get()[1]);
    }

    /** A light of its own for each of many balls, all out of sight, gives the same as one of them at a time. */
    @Test
    void ofManyBallsOneIsLookedForAndCountsForAll() {
        Scene each = FLOOR;
        Scene chosen = FLOOR;
        for (int i = 0; i < 40; i++) {
            int row = i / 8;
            Vec3 place = new Vec3(0.9 * (i % 8) - 3, 3.5 + 0.3 * (i % 3), 0.8 * row - 3);
            each = each.withLights(Stream.concat(each.lights().stream(), Stream.of((Light) SphereLight.of(place, 0.1).withColor(new Rgb(255, 200, 90)).withIntensity(RADIANCE * 0.01))).toList());
            chosen = chosen.plus(SceneObject.of(new Sphere(0.1)).at(place.x(), place.y(), place.z()).madeOf(GLOW));
        }
        assertThat(brightness(picture(chosen, 3, 1024))).isCloseTo(brightness(picture(each, 3, 256)), withinPercentage(2));
    }

    private static double brightness(Image image) {
        double sum = 0;
        for (int i = 0; i < image.width() * image.height(); i++) {
            sum += image.red(i % image.width(), i / image.width());
        }
        return sum;
    }

    @Test
    void whatPathsOnlyFindByChanceIsWarnedOf() {
        Scene scene = FLOOR.plus(hung(Csg.union((Solid) new Sphere(1))).named("lamp")).plus(hung(new Disc(1)).named("disc")).plus(hung(sheet(9, 9)).named("sheet"))
                .withSettings(RenderSettings.DEFAULT.withIntegrator(Integrator.PATH));
        assertThat(warned(scene)).containsExactly("union \"lamp\"");
        assertThat(warned(scene.withSettings(RenderSettings.DEFAULT))).isEmpty();
    }

    private static List<String> warned(Scene scene) {
        return SceneWarnings.of(scene).stream().filter(warning -> warning.kind().equals("shines-by-chance")).map(SceneWarning::object).toList();
    }
}
