package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.ImageComparison;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.StoredImage;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Pictures against those of POV-Ray 3.7, pixel by pixel, in 16-bit linear light: no channel more than two steps apart, except in one pixel
 * of a thousand, for the sake of outlines. POV-Ray's recorded pictures lie beside the scenes; the command line's tests run the program itself.
 */
class CrossCheckTest {
    private static final Path FOLDER = Path.of("src/test/resources/crosscheck");
    private static final double STEPS = 2;
    private static final double SHARE = 0.001;

    static List<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.filter(file -> file.toString().endsWith(".xml")).sorted().toList();
        }
    }

    @Test
    void thereIsASceneForEveryFeature() throws IOException {
        assertThat(scenes()).hasSizeGreaterThanOrEqualTo(62);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void theRecordedPictureIsTheSame(Path file) throws Exception {
        StoredImage recorded = ImageFiles.readStored(Path.of(file.toString().replace(".xml", ".png")));
        assertThat(recorded.precision()).isEqualTo(Precision.SIXTEEN_BIT);
        compare(SceneFiles.read(file), recorded);
    }

    private static void compare(Scene scene, StoredImage theirs) {
        ImageComparison comparison = ImageComparison.of(StoredImage.of(Renderer.render(RenderScene.of(scene, Assets.in(FOLDER), RenderMonitor.NONE), RenderOptions.of(scene).withFixedSampler(), RenderMonitor.NONE).image()), theirs, STEPS);
        assertThat(comparison.shareBeyond()).as(comparison.toString()).isLessThanOrEqualTo(SHARE);
        // Rounding alone is a quarter of a step on the average.
        assertThat(comparison.beyond() > 0 || comparison.mean() < 0.4).as(comparison.toString()).isTrue();
    }
}
