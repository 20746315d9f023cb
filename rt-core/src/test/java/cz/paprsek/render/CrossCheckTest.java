package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import cz.paprsek.image.ImageComparison;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.StoredImage;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.pov.PovRay;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Pictures against those of POV-Ray 3.7, pixel by pixel, in 16-bit linear light: no channel more than two steps apart, except in one pixel
 * of a thousand, for the sake of outlines. POV-Ray's recorded pictures lie beside the scenes; where it is installed, it also renders some of
 * them anew, and scenes that nobody has seen before. The system property {@code crosscheck.seed} repeats a run, {@code crosscheck.scenes}
 * makes it longer.
 */
class CrossCheckTest {
    private static final Path FOLDER = Path.of("src/test/resources/crosscheck");
    private static final double STEPS = 2;
    private static final double SHARE = 0.001;
    private static final int FRESH = Integer.getInteger("crosscheck.scenes", 8);
    private static final long SEED = Long.getLong("crosscheck.seed", new Random().nextInt(1_000_000));
    private static final Optional<PovRay> POVRAY = PovRay.installed();

    @BeforeAll
    static void sayWhatIsChecked() {
        System.out.println(POVRAY.map(pov -> "Cross-check: live against POV-Ray " + pov.version() + ", fresh scenes from -Dcrosscheck.seed=" + SEED)
                .orElse("Cross-check: povray is not installed, so the LIVE CHECK IS SKIPPED; its recorded pictures are compared."));
    }

    static List<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.filter(file -> file.toString().endsWith(".xml")).sorted().toList();
        }
    }

    static LongStream seeds() {
        return LongStream.range(SEED, SEED + FRESH);
    }

    @Test
    void thereIsASceneForEveryFeature() throws IOException {
        assertThat(scenes()).hasSizeGreaterThanOrEqualTo(44);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void theRecordedPictureIsTheSame(Path file) throws Exception {
        StoredImage recorded = ImageFiles.readStored(Path.of(file.toString().replace(".xml", ".png")));
        assertThat(recorded.precision()).isEqualTo(Precision.SIXTEEN_BIT);
        compare(SceneFiles.read(file), recorded);
    }

    /** One scene that has most in it: that the recorded pictures are what POV-Ray makes of today's export. */
    @Test
    @Tag("live")
    void povRayStillMakesTheRecordedPicture() throws Exception {
        Scene scene = SceneFiles.read(FOLDER.resolve("combined-room.xml"));
        compare(scene, live(scene));
    }

    @ParameterizedTest
    @Tag("live")
    @MethodSource("seeds")
    void aFreshSceneIsTheSame(long seed) throws Exception {
        Scene scene = CrossCheckScenes.random(seed);
        compare(scene, live(scene));
    }

    private static StoredImage live(Scene scene) throws Exception {
        assumeTrue(POVRAY.isPresent(), "povray is not installed");
        return new StoredImage(POVRAY.get().render(scene, 1).image(), Precision.SIXTEEN_BIT, false);
    }

    private static void compare(Scene scene, StoredImage theirs) {
        ImageComparison comparison = ImageComparison.of(StoredImage.of(Renderer.render(scene)), theirs, STEPS);
        assertThat(comparison.shareBeyond()).as(comparison.toString()).isLessThanOrEqualTo(SHARE);
        // Rounding alone is a quarter of a step on the average.
        assertThat(comparison.beyond() > 0 || comparison.mean() < 0.4).as(comparison.toString()).isTrue();
    }
}
