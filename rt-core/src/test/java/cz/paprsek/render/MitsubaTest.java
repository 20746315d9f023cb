package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Pictures of paths against those of Mitsuba 3, which were recorded by {@code mitsuba/record.py} among the tests' resources: of the same scene built there (diffuse, roughconductor with material none,
 * roughdielectric, area, point and constant; point intensities times π, α = roughness², max_depth one larger, box filter, no roulette), block by block of 8 × 8 pixels the mean of many independent renders,
 * and its variance.
 */
class MitsubaTest {
    private static final List<String> SHIPPED = List.of("cornell", "plates");
    private static final int BLOCKS = 8;
    private static final int SIDE = 8;
    private static final boolean IS_PROOF = System.getProperty("paprsek.proof") != null;
    private static final int FEW = 12;
    private static final Pattern RENDERS = Pattern.compile(" (\\d+) renders of (\\d+) paths;");

    /**
     * In every build a few paths, which are as bright as their number tells; with {@code -Dpaprsek.proof}, a minute and a half of a processor, as many as tell 0.3 % in each channel.
     *
     * @param many of which the deviation of the whole, by independent pictures of ours, was below 0.08 % in each channel
     */
    @ParameterizedTest
    @CsvSource({"cornell, 4096", "table, 2048", "glow, 1024", "plates, 8192"})
    void picturesOfPathsAreThoseOfMitsuba(String name, int many) throws Exception {
        compare(name, IS_PROOF ? many : FEW);
    }

    private static void compare(String name, int paths) throws Exception {
        Path folder = Path.of("src/test/resources/mitsuba");
        Scene scene = SceneFiles.read(SHIPPED.contains(name) ? Path.of("../scenes", name + ".xml") : folder.resolve(name + ".xml"));
        Image image = Renderer.render(scene.withSettings(scene.settings().withSize(BLOCKS * SIDE, BLOCKS * SIDE).withSamples(paths)));
        List<String> lines = Files.readAllLines(folder.resolve(name + ".txt"));
        Matcher renders = RENDERS.matcher(lines.get(0));
        assertThat(renders.find()).as(lines.get(0)).isTrue();
        double recordedPaths = Double.parseDouble(renders.group(1)) * Double.parseDouble(renders.group(2));
        List<double[]> recorded = lines.stream().skip(1).map(line -> Stream.of(line.split(" ")).mapToDouble(Double::parseDouble).toArray()).toList();
        double[] all = new double[3];
        double[] expected = new double[3];
        double[] variance = new double[3];
        double[] recordedVariance = new double[3];
        for (int block = 0; block < BLOCKS * BLOCKS; block++) {
            double[] ours = mean(image, block % BLOCKS * SIDE, block / BLOCKS * SIDE);
            double[] theirs = recorded.get(block);
            for (int channel = 0; channel < 3; channel++) {
                // Ours is less, as our points are spread more evenly.
                double own = theirs[3 + channel] * (1 + recordedPaths / paths);
                // Where nothing is random there is rounding.
                assertThat(Math.abs(ours[channel] - theirs[channel])).as("%s, block %d, channel %d: %f, not %f", name, block, channel, ours[channel], theirs[channel])
                        .isLessThanOrEqualTo(4 * Math.sqrt(own) + 1e-5 * theirs[channel]);
                all[channel] += ours[channel];
                expected[channel] += theirs[channel];
                variance[channel] += own;
                recordedVariance[channel] += theirs[3 + channel];
            }
        }
        for (int channel = 0; channel < 3; channel++) {
            double off = Math.abs(all[channel] - expected[channel]);
            double most = IS_PROOF ? 0.003 * expected[channel] : Double.POSITIVE_INFINITY;
            assertThat(off).as("%s, channel %d, %f of %f", name, channel, off, expected[channel]).isLessThanOrEqualTo(Math.min(most, 4 * Math.sqrt(variance[channel])));
            assertThat(Math.sqrt(recordedVariance[channel])).as("%s, channel %d: what was recorded tells 0.3 %%", name, channel).isLessThan(0.001 * expected[channel]);
        }
    }

    private static double[] mean(Image image, int x, int y) {
        double[] sum = new double[3];
        for (int i = 0; i < SIDE * SIDE; i++) {
            sum[0] += image.red(x + i % SIDE, y + i / SIDE);
            sum[1] += image.green(x + i % SIDE, y + i / SIDE);
            sum[2] += image.blue(x + i % SIDE, y + i / SIDE);
        }
        return Stream.of(0, 1, 2).mapToDouble(channel -> sum[channel] / (SIDE * SIDE)).toArray();
    }
}
