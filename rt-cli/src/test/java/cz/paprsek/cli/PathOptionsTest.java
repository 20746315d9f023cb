package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.process.ExitCode;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pictures of paths on the command line. */
class PathOptionsTest {
    @TempDir
    Path folder;

    private Path scene;

    @BeforeEach
    void write() throws Exception {
        scene = Scenes.ball(folder.resolve("a.xml"));
    }

    private Run render(Path picture, Object... options) {
        return Run.cli(Stream.concat(Stream.of("render", scene, "--integrator", "path", "-o", picture), Arrays.stream(options)).toArray());
    }

    @Test
    void whoResumesWithMorePathsGetsTheBytesOfAllAtOnce() throws Exception {
        Path picture = folder.resolve("a.png");
        Path atOnce = folder.resolve("b.png");
        assertThat(render(picture, "--samples", 100, "--resume").code()).isEqualTo(ExitCode.DONE);
        Run later = render(picture, "--samples", 200, "--resume");
        assertThat(later.err()).contains("going on with the paths of an earlier render");
        assertThat(render(picture, "--samples", 200, "--resume", "-q").err()).as("asked to be quiet").isEmpty();
        render(atOnce, "--samples", 200);
        assertThat(picture).hasSameBinaryContentAs(atOnce);
        Run fewer = render(picture, "--samples", 100, "--resume");
        assertThat(fewer.code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(fewer.err()).contains("has pixels of 192 paths already, more than --samples 100");
    }

    @Test
    void whatIsDenoisedIsWholeAndItsBytesDoNotTellHowItWasMade() throws Exception {
        Path picture = folder.resolve("a.pfm");
        Path atOnce = folder.resolve("b.pfm");
        assertThat(render(picture, "--denoise", "--samples", 64, "--resume", "--size", "24x16").err()).containsPattern("traced after \\d+ s, taking the noise out");
        assertThat(render(picture, "--denoise", "--samples", 128, "--resume", "--size", "24x16").code()).isEqualTo(ExitCode.DONE);
        render(atOnce, "--denoise", "--samples", 128, "--size", "24x16", "--threads", 1);
        assertThat(picture).hasSameBinaryContentAs(atOnce);
        assertThat(render(picture, "--denoise", "--region", "0,0,9,8").err()).contains("a denoiser needs the whole picture, not a region of it");
        assertThat(render(picture, "--denoise", "--samples", 100).err()).contains("whole passes: samples of a multiple of 64, not 100");
        assertThat(Run.cli("render", scene, "--denoise", "-o", picture).err()).contains("a denoiser is for integrator path");
    }

    @Test
    void timeEndsAPictureAfterWholePasses() throws Exception {
        Path picture = folder.resolve("a.ppm");
        assertThat(render(picture, "--time", "0.2").code()).isEqualTo(ExitCode.DONE);
        assertThat(picture).exists();
        assertThat(Run.cli("render", scene, "--time", 1, "-o", picture).err()).contains("--integrator path");
        assertThat(render(picture, "--time", 0).err()).contains("above 0");
    }

    @Test
    void whoAsksForAnErrorIsToldHowNearThePixelsAre() {
        Run json = render(folder.resolve("a.png"), "--samples", "128", "--error", "4/255", "--json");
        assertThat(json.out()).containsPattern("\"certainty\":\\{\"within\":[01](\\.\\d+)?,\"farthest\":[01](\\.\\d+)?(E-\\d+)?,\"untrusted\":[01](\\.\\d+)?}");
        assertThat(render(folder.resolve("a.png"), "--samples", "64..128").out()).contains("of the pixels within the error");
        assertThat(render(folder.resolve("a.png"), "--samples", "64").out()).doesNotContain("within the error");
    }

    @Test
    void layersOpacityAndHeatMapsAreOfPathsAsOfRays() throws Exception {
        Path layers = folder.resolve("a.exr");
        assertThat(render(layers, "--aov", "normal,error,light,direct,indirect,samples", "--transparent", "--samples", 100, "--resume").code()).isEqualTo(ExitCode.DONE);
        assertThat(render(layers, "--aov", "normal,error,light,direct,indirect,samples", "--transparent", "--samples", 200, "--resume").code()).isEqualTo(ExitCode.DONE);
        Path atOnce = folder.resolve("b.exr");
        assertThat(render(atOnce, "--aov", "normal,error,light,direct,indirect,samples", "--transparent", "--samples", 200).code()).isEqualTo(ExitCode.DONE);
        assertThat(layers).hasSameBinaryContentAs(atOnce);
        Run heat = render(folder.resolve("a.png"), "--mode", "error", "--exposure", 1);
        assertThat(heat.code()).as(heat.err()).isEqualTo(ExitCode.DONE);
        assertThat(heat.out()).contains("of the pixels within the error");
        assertThat(render(folder.resolve("a.txt"), "--mode", "samples").code()).isEqualTo(ExitCode.DONE);
        assertThat(Files.readString(folder.resolve("a.txt"))).startsWith("64 64");
        assertThat(Run.cli("render", scene, "--aov", "error", "-o", layers).err()).contains("samples A..B");
        assertThat(Run.cli("render", scene, "--mode", "error", "-o", folder.resolve("a.png")).err()).contains("samples A..B");
    }

    @Test
    void aPixelOfPathsIsExplained() throws Exception {
        Path drawing = folder.resolve("a.svg");
        Run text = Run.cli("explain", scene, "6,4", "--integrator", "path", "--samples", 64, "--svg", drawing);
        assertThat(text.code()).as(text.err()).isEqualTo(ExitCode.DONE);
        assertThat(text.out()).contains("By which ways light came:", " > eye", "the average of 64 paths = ");
        assertThat(Files.readString(drawing)).startsWith("<svg");
        Run json = Run.cli("explain", scene, "6,4", "--integrator", "path", "--samples", 64, "--json");
        assertThat(json.out()).contains("\"ways\":[{\"way\":[", "\"sources\":[", "\"examples\":[");
        assertThat(Run.cli("explain", scene, "99,4", "--integrator", "path").code()).isEqualTo(ExitCode.WRONG_USAGE);
    }

    @Test
    void theDepthAndTheSamplesOfAFileArePaths() throws Exception {
        Files.writeString(scene, Files.readString(scene).replace("height=\"8\"", "height=\"8\" integrator=\"path\""));
        Path picture = folder.resolve("a.png");
        Path other = folder.resolve("b.png");
        assertThat(Run.cli("render", scene, "-o", picture).code()).isEqualTo(ExitCode.DONE);
        assertThat(Run.cli("render", scene, "--samples", 64, "-o", other).code()).isEqualTo(ExitCode.DONE);
        assertThat(picture).hasSameBinaryContentAs(other);
        assertThat(Run.cli("info", scene).out()).contains("path");
        assertThat(Run.cli("render", scene, "--integrator", "whitted", "-o", other).code()).isEqualTo(ExitCode.DONE);
        assertThat(Files.mismatch(picture, other)).isNotEqualTo(-1);
    }
}
