package cz.paprsek.cli.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import cz.paprsek.image.Image;
import cz.paprsek.image.ImageComparison;
import cz.paprsek.image.StoredImage;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A thin lens against the mean of 25 pinholes of POV-Ray's. */
@Tag("live")
class LensCrossCheckTest {

    @Test
    void depthOfFieldIsTheMeanOfPinholes() throws Exception {
        Optional<PovRay> povRay = PovRay.installed();
        assumeTrue(povRay.isPresent(), "povray is not installed");
        Scene scene = SceneFiles.read(Path.of("../rt-core/src/test/resources/crosscheck/combined-table.xml")).withSettings(new RenderSettings(64, 48, 8, 5));
        Scene blurred = scene.withCamera(scene.camera().withLens(new Lens.Perspective(40, 0.25, 6)));
        Image mean = Pinholes.mean(povRay.get(), blurred);
        Image ours = Renderer.render(blurred, RenderOptions.of(blurred).withFixedSampler(), RenderMonitor.NONE).image();
        ImageComparison comparison = ImageComparison.of(StoredImage.of(ours), new StoredImage(mean, Precision.SIXTEEN_BIT, false), 2);
        assertThat(comparison.shareBeyond()).as(comparison.toString()).isLessThanOrEqualTo(0.001);
    }
}
