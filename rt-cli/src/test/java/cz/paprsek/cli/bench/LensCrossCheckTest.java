package cz.paprsek.cli.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import cz.paprsek.image.Image;
import cz.paprsek.image.ImageComparison;
import cz.paprsek.image.StoredImage;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A thin lens against the mean of sheared pinholes of POV-Ray's, one for each of the points that the fixed sampler has in every pixel. */
@Tag("live")
class LensCrossCheckTest {
    private static final int PER_SIDE = 5;
    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;

    @Test
    void depthOfFieldIsTheMeanOfPinholes() throws Exception {
        Optional<PovRay> povRay = PovRay.installed();
        assumeTrue(povRay.isPresent(), "povray is not installed");
        Scene scene = SceneFiles.read(Path.of("../rt-core/src/test/resources/crosscheck/combined-table.xml")).withSettings(new RenderSettings(WIDTH, HEIGHT, 8, PER_SIDE));
        Scene blurred = scene.withCamera(scene.camera().withLens(new Lens.Perspective(40, 0.25, 6)));
        StringBuilder words = new StringBuilder();
        PovFiles.write(blurred, words);
        double[][] sums = new double[3][WIDTH * HEIGHT];
        Sampler sampler = Sampler.fixed(PER_SIDE * PER_SIDE);
        for (int k = 0; k < PER_SIDE * PER_SIDE; k++) {
            sampler.start(0, 0, k);
            sampler.lens();
            sampler.next();
            String pinhole = words.toString().replaceFirst("(?m)^camera \\{.*$", "camera { " + pinhole(blurred.camera(), k, sampler) + " }");
            Image theirs = povRay.get().render(pinhole, WIDTH, HEIGHT);
            for (int i = 0; i < WIDTH * HEIGHT; i++) {
                sums[0][i] += theirs.red(i % WIDTH, i / WIDTH);
                sums[1][i] += theirs.green(i % WIDTH, i / WIDTH);
                sums[2][i] += theirs.blue(i % WIDTH, i / WIDTH);
            }
        }
        Image mean = new Image(WIDTH, HEIGHT);
        double share = 1.0 / (PER_SIDE * PER_SIDE);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            mean.set(i % WIDTH, i / WIDTH, (float) (share * sums[0][i]), (float) (share * sums[1][i]), (float) (share * sums[2][i]));
        }
        Image ours = Renderer.render(blurred, RenderOptions.of(blurred).withFixedSampler(), RenderMonitor.NONE).image();
        ImageComparison comparison = ImageComparison.of(StoredImage.of(ours), new StoredImage(mean, Precision.SIXTEEN_BIT, false), 2);
        assertThat(comparison.shareBeyond()).as(comparison.toString()).isLessThanOrEqualTo(0.001);
    }

    /** From the lens's point, through the plane in focus, and through the sample's place within the pixel. */
    private static String pinhole(Camera camera, int k, Sampler sampler) {
        Ray ray = new Ray(new Spans());
        Eye.of(camera, WIDTH, HEIGHT).start(ray, 1, 1, sampler.u, sampler.v);
        Vec3 start = new Vec3(ray.ox, ray.oy, ray.oz);
        double high = 2 * Angles.tan(((Lens.Perspective) camera.lens()).fovy() / 2) * camera.focus();
        Vec3 up = camera.trueUp().times(high);
        Vec3 right = camera.right().times(high * WIDTH / HEIGHT);
        Vec3 aside = right.times(((k % PER_SIDE + 0.5) / PER_SIDE - 0.5) / WIDTH).plus(up.times((0.5 - (rowOf(k) + 0.5) / PER_SIDE) / HEIGHT));
        Vec3 direction = camera.forward().times(camera.focus()).minus(start.minus(camera.position())).plus(aside);
        return "perspective location " + words(start) + " direction " + words(direction) + " up " + words(up) + " right " + words(right);
    }

    private static int rowOf(int sample) {
        return sample / PER_SIDE;
    }

    private static String words(Vec3 v) {
        return String.format(Locale.ROOT, "<%.17g, %.17g, %.17g>", v.x(), v.y(), v.z());
    }
}
