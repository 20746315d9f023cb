package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.asset.Assets;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.text.Decoration;
import cz.paprsek.render.explain.text.TreeText;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The worked numbers of <i>The Ray Tracer Challenge</i> (Buck, 2019), as scenes that are explained: docs/textbooks.md. */
class TextbookScenesTest {
    private static final Path SCENES = Path.of("../scenes/textbooks");
    private static final double BOOK = 1e-4;

    private static Pixel pixel(String file, int column, int row) throws Exception {
        Scene scene = SceneFiles.read(SCENES.resolve(file + ".xml"));
        return RenderScene.of(scene, Assets.none(), RenderMonitor.NONE).explain(column, row);
    }

    private static List<TracedRay> along(TracedRay ray) {
        List<TracedRay> all = new ArrayList<>(List.of(ray));
        ray.children().forEach(child -> all.addAll(along(child)));
        return all;
    }

    /** With single blanks. */
    private static String text(Pixel pixel) {
        return String.join("\n", TreeText.lines(pixel, 0, Decoration.NONE)).replaceAll(" +", " ") + "\n";
    }

    @ParameterizedTest
    @CsvSource({"sphere-hits", "cube-hits"})
    void solidsAreMetAtFourAndLeftAtSix(String file) throws Exception {
        Pixel pixel = pixel(file, 0, 0);
        List<TracedRay> rays = along(pixel.rays().get(0));
        double in = rays.get(0).encounter().orElseThrow().place().distance();
        assertThat(in).isCloseTo(4, within(BOOK));
        assertThat(in + rays.get(1).encounter().orElseThrow().place().distance()).isCloseTo(6, within(BOOK));
        assertThat(text(pixel)).contains(" t = 4\n", " t = 2\n");
    }

    @Test
    void glassInGlassHasTheBooksIndices() throws Exception {
        Pixel pixel = pixel("nested-glass", 0, 0);
        assertThat(along(pixel.rays().get(0)).stream().map(ray -> ray.medium().refractiveIndex())).containsExactly(1.0, 1.5, 2.0, 2.5, 2.5, 1.5, 1.0);
        assertThat(text(pixel)).contains("= 1 / 1.5 ", "= 1.5 / 2 ", "= 2 / 2.5 ", "= 2.5 / 1.5 ", "= 1.5 / 1 ");
    }

    @Test
    void aCamerasRaysGoWhereTheBookSays_columnsCountedFromTheOtherSide() throws Exception {
        assertDirection(pixel("camera-rays", 100, 50), new Vec3(0, 0, -1));
        assertDirection(pixel("camera-rays", 200, 0), new Vec3(0.66519, 0.33259, -0.66851));
    }

    private static void assertDirection(Pixel pixel, Vec3 book) {
        Vec3 d = pixel.rays().get(0).direction();
        assertThat(d.x()).isCloseTo(book.x(), within(BOOK));
        assertThat(d.y()).isCloseTo(book.y(), within(BOOK));
        assertThat(d.z()).isCloseTo(book.z(), within(BOOK));
    }

    @ParameterizedTest
    @CsvSource({"light-in-front, 1.9, 1.9", "light-aslant, 0.7364, 0.736", "eye-in-the-mirrored-light, 1.6364, 1.64", "light-behind, 0.1, 0.1"})
    void phongsLightIsTheBooks(String file, double book, String shown) throws Exception {
        Pixel pixel = pixel(file, 0, 0);
        assertThat(pixel.light().red()).isCloseTo(book, within(BOOK));
        assertThat(pixel.light().blue()).isCloseTo(book, within(BOOK));
        assertThat(text(pixel)).contains("the light of E = (" + shown + ", " + shown + ", " + shown + ")");
    }

    @Test
    void thePlaneMirrorsTheBooksColour() throws Exception {
        Pixel pixel = pixel("mirrored-plane", 0, 0);
        TracedRay mirrored = pixel.rays().get(0).encounter().orElseThrow().reflected().orElseThrow();
        LinearRgb added = mirrored.light().times(mirrored.weight());
        assertThat(added.distance(new LinearRgb(0.19033, 0.23791, 0.14274))).isLessThan(3 * BOOK);
        assertThat(text(pixel)).contains("(0.19, 0.238, 0.143)");
    }

    @Test
    void everySceneIsInTheTableOfTheDocumentation() throws Exception {
        String page = Files.readString(Path.of("../docs/textbooks.md"));
        try (Stream<Path> files = Files.list(SCENES)) {
            assertThat(files.toList()).isNotEmpty().allSatisfy(file -> assertThat(page).contains("`" + file.getFileName().toString().replace(".xml", "") + "`"));
        }
    }
}
