package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Pictures of paths against those of Mitsuba 3, which were recorded: of the same scene built there (diffuse, roughconductor with material none, roughdielectric, area, point
 * and constant; point intensities times π, α = roughness², max_depth one larger, box filter, no roulette), block by block of 8 × 8 pixels the mean of many independent
 * renders, and its variance.
 */
class MitsubaTest {
    private static final List<String> SHIPPED = List.of("cornell", "plates");
    private static final int BLOCKS = 8;
    private static final int SIDE = 8;
    private static final int PATHS = Integer.getInteger("paths.samples", 12);
    private static final int ENOUGH = 512;
    private static final int RECORDED_PATHS = 24 * 64;

    /** A few paths are as bright as their number tells; with -Dpaths.samples=512 or more they tell 0.3 %. */
    @ParameterizedTest
    @ValueSource(strings = {"cornell", "table", "glow", "plates"})
    void picturesOfPathsAreThoseOfMitsuba(String name) throws Exception {
        compare(name, PATHS, PATHS < ENOUGH ? 1 : 0.003);
    }

    private static void compare(String name, int paths, double most) throws Exception {
        Path folder = Path.of("src/test/resources/mitsuba");
        Scene scene = SceneFiles.read(SHIPPED.contains(name) ? Path.of("../scenes", name + ".xml") : folder.resolve(name + ".xml"));
        Image image = Renderer.render(scene.withSettings(scene.settings().withSize(BLOCKS * SIDE, BLOCKS * SIDE).withSamples(paths)));
        List<double[]> recorded = Files.readAllLines(folder.resolve(name + ".txt")).stream().filter(line -> !line.startsWith("#"))
                .map(line -> Stream.of(line.split(" ")).mapToDouble(Double::parseDouble).toArray()).toList();
        double[] all = new double[3];
        double[] expected = new double[3];
        double[] variance = new double[3];
        for (int block = 0; block < BLOCKS * BLOCKS; block++) {
            double[] ours = mean(image, block % BLOCKS * SIDE, block / BLOCKS * SIDE);
            double[] theirs = recorded.get(block);
            for (int channel = 0; channel < 3; channel++) {
                double own = theirs[3 + channel] * (1 + (double) RECORDED_PATHS / paths);
                // Where nothing is random there is rounding.
                assertThat(Math.abs(ours[channel] - theirs[channel])).as("%s, block %d, channel %d: %f, not %f", name, block, channel, ours[channel], theirs[channel])
                        .isLessThanOrEqualTo(4 * Math.sqrt(own) + 1e-5 * theirs[channel]);
                all[channel] += ours[channel];
                expected[channel] += theirs[channel];
                variance[channel] += own;
            }
        }
        for (int channel = 0; channel < 3; channel++) {
            double off = Math.abs(all[channel] - expected[channel]);
            assertThat(off).as("%s, channel %d, %f of %f", name, channel, off, expected[channel])
                    .isLessThanOrEqualTo(Math.min(most * expected[channel], 4 * Math.sqrt(variance[channel])));
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
