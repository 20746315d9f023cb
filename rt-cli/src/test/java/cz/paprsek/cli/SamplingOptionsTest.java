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
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
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
    void aPixelOfManyRaysListsThemAndTellsOfOneInFull() {
        Run run = Run.cli("explain", scene, "8,4", "--samples", "2..3");
        assertThat(run.code()).isZero();
        assertThat(run.out()).containsPattern("(?m)^ray \\d of 9, whose light is nearest to the pixel's").containsPattern("(?m)^ray 4 of 9 +\\(.*, .*\\) +\\(.*\\) · 0\\.1111  from the eye, hits sphere #1$")
                .contains("the average of 9 rays").containsOnlyOnce("medium  ");
        assertThat(run.err()).contains("--all tells of each of the 9 rays in full");
        assertThat(Run.cli("explain", scene, "8,4", "--samples", "2..3", "--all").out().split("  medium  ", -1)).hasSize(10);
    }

    /** A lens, lights with sizes, as many rays as it takes, and a filter that takes away: what is explained is what the scene asks for. */
    @Test
    void whatIsExplainedAddsUpToThePictureBitForBit() throws Exception {
        Files.writeString(scene, "<scene xmlns='urn:paprsek:scene:1'><render width='16' height='12' samples='2..4' error='0.002' filter='mitchell'/>"
                + "<camera position='0 1 6' target='0 0.7 0' aperture='0.2'/><background color='30 60 120'/>"
                + "<area-light position='-2 4 3' rotation='60 30 0' size='1.5 1.5' samples='4' reference-distance='3'/>"
                + "<sun-light direction='-1 -1 -0.5' angle='5' intensity='0.3'/><sphere-light radius='0.2' position='1.2 1 1' samples='3' intensity='0.5'/>"
                + "<sphere radius='0.7' position='0 0.7 0'/><rectangle min='-9 -9' max='9 9' rotation='-90 0 0'><material reflection='0.3'/></rectangle></scene>");
        Path picture = folder.resolve("a.pfm");
        for (String[] options : new String[][] {{}, {"--sampler", "fixed"}, {"--samples", "3", "--filter", "box"}}) {
            assertThat(Run.cli(Stream.concat(Stream.of("render", scene, "-o", picture, "--quiet"), Stream.of(options)).toArray()).code()).isZero();
            Image image = ImageFiles.read(picture);
            boolean isSharpened = false;
            for (int i = 0; i < 16 * 12; i += 5) {
                String json = Run.cli(Stream.concat(Stream.of("explain", scene, i % 16 + "," + i / 16, "--json"), Stream.of(options)).toArray()).out();
                double[] weights = numbers(json, "\"weights\":\\[([^\\]]*)").get(0);
                List<double[]> rays = numbers(json, "\"kind\":\"primary\".*?\"light\":\\[([^\\]]*)");
                double light = DoubleStream.of(weights).distinct().map(weight -> weight * IntStream.range(0, weights.length).filter(k -> weights[k] == weight)
                        .mapToDouble(k -> rays.get(k)[2]).reduce(0, Double::sum)).reduce(0, Double::sum);
                isSharpened |= DoubleStream.of(weights).distinct().count() > 1;
                assertThat((float) Math.max(0, light)).as("pixel %d, %d", i % 16, i / 16).isEqualTo(image.blue(i % 16, i / 16));
                assertShadowRaysAddUp(json);
            }
            assertThat(isSharpened).isEqualTo(options.length < 4);
        }
    }

    private static void assertShadowRaysAddUp(String json) {
        double sum = 0;
        int count = 0;
        Matcher ray = Pattern.compile("\"highlight\":[^,]+,\"added\":\\[([^\\]]*)\\]\\}(?:\\],\"added\":\\[([^\\]]*))?").matcher(json);
        while (ray.find()) {
            sum += numbers(ray.group(1))[0];
            count++;
            if (ray.group(2) != null) {
                assertThat(sum * (1.0 / count)).isEqualTo(numbers(ray.group(2))[0]);
                sum = 0;
                count = 0;
            }
        }
        assertThat(count).isZero();
    }

    private static List<double[]> numbers(String json, String pattern) {
        return Pattern.compile(pattern).matcher(json).results().map(found -> numbers(found.group(1))).toList();
    }

    private static double[] numbers(String list) {
        return Stream.of(list.split(",")).mapToDouble(Double::parseDouble).toArray();
    }
}
