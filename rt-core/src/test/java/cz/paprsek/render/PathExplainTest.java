package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.image.Image;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.Pixel.PathPixel;
import cz.paprsek.render.explain.Pixel.PathPixel.Way;
import cz.paprsek.render.explain.text.Decoration;
import cz.paprsek.render.explain.text.PathJson;
import cz.paprsek.render.explain.text.PathLines;
import cz.paprsek.render.explain.text.PathWords;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.words.Words;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Why a pixel of paths has its colour: the sums are those of the picture, and the ways those that light can come. */
class PathExplainTest {
    private static final RenderSettings SETTINGS = PathLayersTest.SCENE.settings().withSize(24, 20).withMaxDepth(4).withIntegrator(Integrator.PATH);
    private static final int[][] PIXELS = {{12, 14}, {8, 11}, {14, 15}, {18, 13}, {2, 1}, {12, 19}};

    private static PathPixel explain(Scene scene, RenderSettings settings, int column, int row) {
        return RenderScene.of(scene).explainPaths(RenderOptions.of(settings), column, row, RenderMonitor.NONE);
    }

    /** Whole passes and a part of one, and as many as a pixel takes. */
    @ParameterizedTest
    @CsvSource({"64, 0, BOX", "100, 0, BOX", "192, 0, MITCHELL", "64, 512, TENT"})
    void aPixelIsThatOfThePictureAndItsPartsAreItsSum(int samples, int most, PixelFilter filter) {
        RenderSettings settings = SETTINGS.withSamples(samples, most).withFilter(filter);
        Image picture = Renderer.render(RenderScene.of(PathLayersTest.SCENE), RenderOptions.of(settings), RenderMonitor.NONE).image();
        for (int[] at : PIXELS) {
            PathPixel pixel = explain(PathLayersTest.SCENE, settings, at[0], at[1]);
            assertThat(List.of((float) pixel.light().red(), (float) pixel.light().green(), (float) pixel.light().blue()))
                    .containsExactly(picture.red(at[0], at[1]), picture.green(at[0], at[1]), picture.blue(at[0], at[1]));
            for (List<Way> parts : List.of(pixel.ways(), pixel.sources())) {
                LinearRgb sum = parts.stream().map(Way::light).reduce(LinearRgb.BLACK, LinearRgb::plus);
                assertThat(sum.distance(pixel.light())).isLessThanOrEqualTo(1e-12 * (1 + pixel.light().most()));
            }
        }
    }

    /** A pass is 64 samples summed in order, and of whole passes the sum is kept as two floats. */
    @Test
    void theSamplesSumToThePixelBitForBit() {
        for (int[] at : PIXELS) {
            PathPixel pixel = explain(PathLayersTest.SCENE, SETTINGS.withSamples(160), at[0], at[1]);
            double all = 0;
            double pass = 0;
            for (int i = 0; i < 160; i++) {
                pass += pixel.samples().get(i).green();
                if (i % 64 == 63) {
                    double sum = all + pass;
                    all = (float) sum + (double) (float) (sum - (float) sum);
                    pass = 0;
                }
            }
            assertThat((all + pass) * (1.0 / 160)).isEqualTo(pixel.light().green());
        }
    }

    /** A lamp above a floor beside a wall: at depth 2 light comes at once, or by one of the two. */
    @Test
    void waysAreThoseThatLightCanCome() {
        Scene scene = Scene.EMPTY.withLights(List.of(SphereLight.of(new Vec3(0, 2, 0), 0.2).named("lamp").withIntensity(2)))
                .plus(SceneObject.of(new Rectangle(-3, -3, 3, 3)).rotated(-90, 0, 0).named("floor"))
                .plus(SceneObject.of(new Rectangle(-3, 0, 3, 3)).at(0, 0, -2).named("wall"))
                .withCamera(Camera.lookingAt(new Vec3(0, 2, 4), new Vec3(0, 0, -1)));
        PathPixel pixel = explain(scene, SETTINGS.withSize(9, 9).withMaxDepth(2).withSamples(256), 4, 4);
        PathWords words = new PathWords(Words.ENGLISH);
        assertThat(pixel.ways()).extracting(words::of).containsExactly("lamp > floor > eye", "lamp > wall > floor > eye");
        assertThat(pixel.sources()).extracting(words::source).containsExactly("lamp");
        assertThat(pixel.ways()).allSatisfy(way -> assertThat(way.halfWidth()).isPresent());
        PathPixel closely = explain(scene, SETTINGS.withSize(9, 9).withMaxDepth(2).withSamples(4096), 4, 4);
        for (int i = 0; i < 2; i++) {
            double off = Math.abs(pixel.ways().get(i).light().red() - closely.ways().get(i).light().red());
            assertThat(off).as("within three times its interval").isLessThan(3 * pixel.ways().get(i).halfWidth().orElseThrow().red());
        }
        assertThat(pixel.examples()).allSatisfy(example -> assertThat(example.ray().light()).isEqualTo(pixel.samples().get(example.sample())));
        assertThat(String.join("\n", PathLines.lines(pixel, 0, Decoration.NONE, Words.ENGLISH))).contains("lamp > wall > floor > eye", "256 paths", "steps of 255");
        assertThat(String.join("\n", PathLines.lines(pixel, 0, Decoration.NONE, Words.in(Locale.forLanguageTag("cs"))))).contains("lamp > wall > floor > oko");
        assertThat(PathJson.of(pixel).toString()).contains("\"way\":[\"lamp\",\"wall\",\"floor\",\"eye\"]", "\"half-width\":", "\"trusted\":");
    }

    /** The body that glows, the background seen in a mirror and through glass, and lamps. */
    @Test
    void sourcesAreAllThatShines() {
        PathWords words = new PathWords(Words.ENGLISH);
        PathPixel pixel = explain(PathLayersTest.SCENE, SETTINGS.withSamples(1024), 12, 16);
        assertThat(pixel.sources()).extracting(words::source).contains("left", "light #1", "background", "sphere #4");
        PathPixel sky = explain(PathLayersTest.SCENE, SETTINGS.withSamples(64), 2, 1);
        assertThat(sky.ways()).extracting(words::of).containsExactly("background > eye");
    }

    @Test
    void whatCannotBeExplainedIsRefusedInASentence() {
        assertThatThrownBy(() -> explain(PathLayersTest.SCENE, SETTINGS, 24, 1)).hasMessageContaining("24,1 must lie inside");
        assertThatThrownBy(() -> explain(PathLayersTest.SCENE, RenderSettings.DEFAULT, 1, 1)).hasMessageContaining("not of paths");
    }
}
