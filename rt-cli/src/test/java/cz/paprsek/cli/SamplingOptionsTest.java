package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** How many rays a pixel takes, by the command line. */
class SamplingOptionsTest {
    @TempDir
    private Path folder;
    private Path scene;

    @BeforeEach
    void writeAScene() throws IOException {
        scene = Scenes.ball(folder.resolve("ball.xml"));
    }

    @Test
    void thePictureIsThatOfTheLibraryAndTellsItsSettings() throws Exception {
        Path picture = folder.resolve("a.png");
        Run run = Run.cli("render", scene, "-o", picture, "--samples", "2..4", "--error", "4/255", "--confidence", "0.9", "--filter", "gauss", "--quiet");
        assertThat(run.code()).as(run.err()).isZero();
        Scene read = SceneFiles.read(scene);
        RenderSettings settings = read.settings().withSamples(2, 4).withError(4.0 / 255).withConfidence(0.9).withFilter(PixelFilter.GAUSS);
        Path expected = folder.resolve("b.png");
        ImageFiles.write(Renderer.render(read.withSettings(settings)), expected);
        assertThat(Run.cli("compare", picture, expected, "--tolerance", "0").code()).isZero();
        assertThat(Files.readString(picture, StandardCharsets.ISO_8859_1))
                .contains("--samples 2..4 --max-depth 5 --error 0.01568627450980392 --confidence 0.9 --filter gauss");
    }

    @Test
    void numbersSayHowManyRaysEachPixelTook() throws Exception {
        Path counts = folder.resolve("counts.txt");
        assertThat(Run.cli("render", scene, "-o", counts, "--samples", "2..4", "--mode", "samples", "--quiet").code()).isZero();
        String[] numbers = Files.readString(counts).trim().split("\\s+");
        assertThat(numbers).hasSize(16 * 8).contains("4", "16").allMatch(number -> Arrays.asList("4", "8", "16").contains(number));
    }

    @Test
    void fixedRandomNumbersAreOthersThanScrambledOnes() throws Exception {
        Path fixed = folder.resolve("fixed.pfm");
        Path scrambled = folder.resolve("scrambled.pfm");
        assertThat(Run.cli("render", scene, "-o", fixed, "--samples", "2..2", "--sampler", "fixed", "--quiet").code()).isZero();
        assertThat(Run.cli("render", scene, "-o", scrambled, "--samples", "2..2", "--quiet").code()).isZero();
        assertThat(fixed).exists();
        assertThat(Files.mismatch(fixed, scrambled)).isNotNegative();
        Image one = ImageFiles.read(fixed);
        assertThat(one.width()).isEqualTo(16);
    }

    /** Also of a scene with one ray, or a grid: it is not judged otherwise. */
    @ParameterizedTest
    @CsvSource({"--error, 1/255, '', 2..16", "--confidence, 0.5, '', 2..16", "--error, 1/255, samples='3', 3..16", "--error, 1/255, samples='2..4', 2..4"})
    void whoSaysHowNearAPixelShallBeGetsTheRaysForIt(String option, String value, String attribute, String said) throws Exception {
        Files.writeString(scene, Files.readString(scene).replaceAll("<render ", "<render " + attribute + ' '));
        Path picture = folder.resolve("a.png");
        Path expected = folder.resolve("b.png");
        assertThat(Run.cli("render", scene, "-o", picture, option, value, "--quiet").code()).isZero();
        assertThat(Run.cli("render", scene, "-o", expected, option, value, "--samples", said, "--quiet").code()).isZero();
        assertThat(picture).hasSameBinaryContentAs(expected);
        assertThat(Files.readString(picture, StandardCharsets.ISO_8859_1)).contains("--samples " + said + " ");
    }

    @Test
    void aPixelOfManyRaysListsThem() {
        Run run = Run.cli("explain", scene, "8,4", "--samples", "2..3");
        assertThat(run.code()).isZero();
        assertThat(run.out()).contains("ray 4 of").contains(" · 0.").contains("the average of");
    }
}
