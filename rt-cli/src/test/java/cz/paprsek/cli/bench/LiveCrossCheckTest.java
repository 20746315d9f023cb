package cz.paprsek.cli.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import cz.paprsek.image.Image;
import cz.paprsek.image.ImageComparison;
import cz.paprsek.image.StoredImage;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Pictures against those that POV-Ray 3.7 makes now, where it is installed, of a recorded scene and of some that nobody has seen before: no
 * channel more than two steps of 65535 apart, except in one pixel of a thousand. The system property {@code crosscheck.seed} repeats a run,
 * {@code crosscheck.scenes} makes it longer.
 */
@Tag("live")
class LiveCrossCheckTest {
    private static final Path FOLDER = Path.of("../rt-core/src/test/resources/crosscheck");
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

    static LongStream seeds() {
        return LongStream.range(SEED, SEED + FRESH);
    }

    /** One scene that has most in it: that the recorded pictures are what POV-Ray makes of today's export. */
    @Test
    void povRayStillMakesTheRecordedPicture() throws Exception {
        compare(SceneFiles.read(FOLDER.resolve("combined-room.xml")));
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void aFreshSceneIsTheSame(long seed) throws Exception {
        compare(CrossCheckScenes.random(seed));
    }

    /** Five sixths of it are one background, whose colour lies almost half way between two steps: 0.42 of one on the average. */
    @Test
    void aPictureOfOneColourIsRoundedOneWay() throws Exception {
        compare(CrossCheckScenes.random(165_615));
    }

    /** Their edges are of another form in POV-Ray: but where ours are lighter than a flat wall, so are its, and its are dark where ours are. */
    @ParameterizedTest
    @ValueSource(strings = {"<brick size='0.6 0.3 1' mortar='0.08'/>", "<checker size='0.4' position='0.1 0 0.2'/>", "<stripes size='0.4' scale='1.5'/>"})
    void bumpsWithEdgesGoTheSameWay(String pattern) throws Exception {
        assumeTrue(POVRAY.isPresent(), "povray is not installed");
        Image flat = Renderer.render(wall(""));
        Scene bumpy = wall("<bump strength='0.1'>" + pattern + "</bump>");
        Image ours = Renderer.render(bumpy);
        Image theirs = POVRAY.get().render(bumpy, 1).image();
        double same = 0;
        double other = 0;
        for (int y = 0; y < flat.height(); y++) {
            for (int x = 0; x < flat.width(); x++) {
                double both = (ours.green(x, y) - flat.green(x, y)) * (theirs.green(x, y) - flat.green(x, y));
                same += Math.max(0, both);
                other -= Math.min(0, both);
            }
        }
        assertThat(same).isGreaterThan(0.1);
        assertThat(other).isLessThan(0.1 * same);
    }

    private static Scene wall(String bump) throws Exception {
        return SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><render width='160' height='120'/><camera position='0 0 4' target='0 0 0'/><point-light position='-5 4 3'/>"
                + "<block min='-2 -2 -0.2' max='2 2 0.13'><material>" + bump + "</material></block></scene>");
    }

    private static Image theirs(PovRay povRay, Scene scene) throws Exception {
        boolean isBlurred = scene.camera().lens() instanceof Lens.Perspective lens && lens.aperture() > 0;
        return isBlurred ? Pinholes.mean(povRay, scene) : povRay.render(scene, 1).image();
    }

    private static void compare(Scene scene) throws Exception {
        assumeTrue(POVRAY.isPresent(), "povray is not installed");
        StoredImage theirs = new StoredImage(theirs(POVRAY.get(), scene), Precision.SIXTEEN_BIT, false);
        ImageComparison comparison = ImageComparison.of(StoredImage.of(Renderer.render(RenderScene.of(scene), RenderOptions.of(scene).withFixedSampler(), RenderMonitor.NONE).image()), theirs, STEPS);
        assertThat(comparison.shareBeyond()).as(comparison.toString()).isLessThanOrEqualTo(SHARE);
        // Rounding alone is at most half a step, and a quarter on the average unless a picture is of few colours.
        assertThat(comparison.beyond() > 0 || comparison.mean() < 0.4 || comparison.largest() <= 0.5).as(comparison.toString()).isTrue();
    }
}
