package cz.paprsek.cli.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assumptions.assumeThat;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.image.Image;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.standard.StandardScenes;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MitsubaTest {
    /** A rectangle from 0 to 5.528 and 5.592 that lies is one from −1 to 1, stretched, laid and moved. */
    @Test
    void bodiesAreToldByWhereTheyAre(@TempDir Path folder) throws IOException {
        MitsubaScene.write(StandardScenes.interior(200), folder);
        assertThat(Files.readString(folder.resolve("scene.json"))).contains("\"width\":256,\"height\":256,\"depth\":8,\"samples\":16,\"paths\":true")
                .contains("{\"matrix\":[2.764,0,0,2.764,0,0,-1,0,0,2.796,0,2.796],\"type\":\"rectangle\",\"albedo\":[0.57758")
                .containsOnlyOnce("\"type\":\"ply\"");
        assertThat(Files.readAllBytes(folder.resolve("mesh.ply"))).asString(StandardCharsets.ISO_8859_1).startsWith("ply\nformat binary_little_endian 1.0\nelement vertex 100\n");
    }

    private static Optional<Mitsuba> mitsuba() throws IOException {
        try {
            return Optional.of(new Mitsuba(1, new Stop()));
        } catch (WrongUsage missing) {
            assertThat(missing).hasMessageStartingWith("--against mitsuba needs Python with Mitsuba 3 (pip install mitsuba), but ");
            return Optional.empty();
        }
    }

    @Test
    void itRendersWhatWeRender() throws IOException {
        Optional<Mitsuba> installed = mitsuba();
        assumeThat(installed).isPresent();
        try (Mitsuba mitsuba = installed.get()) {
            for (Scene scene : new Scene[] {StandardScenes.box(), StandardScenes.interior(2000)}) {
                Image ours = ours(scene).image();
                double sum = IntStream.range(0, 256 * 256).mapToDouble(i -> ours.red(i % 256, i / 256) + ours.green(i % 256, i / 256) + ours.blue(i % 256, i / 256)).sum();
                assertThat(mitsuba.render(scene.name(), scene).whole()).as(scene.name()).isCloseTo(sum / (3 * 256 * 256), within(0.003));
            }
            Scene ring = StandardScenes.ring(2000);
            assertThat(mitsuba.render("ring", ring).whole()).isEqualTo((double) ours(ring).stats().hits());
            assertThat(mitsuba.seconds("ring", ring, 1)).isPositive();
        }
    }

    private static RenderResult ours(Scene scene) {
        return Renderer.render(RenderScene.of(scene), RenderOptions.of(scene), RenderMonitor.NONE);
    }

    @Test
    void aLineThatIsNoAnswerIsQuoted() throws IOException {
        assertThat(Mitsuba.Rendered.read("0.25 7")).isEqualTo(new Mitsuba.Rendered(0.25, 7));
        for (String line : new String[] {"warning: slow", "0.25", "0.25 7 8", ""}) {
            assertThatThrownBy(() -> Mitsuba.Rendered.read(line)).isInstanceOf(IOException.class).hasMessage("Mitsuba answers \"" + line + "\" where its time should stand");
        }
    }

    @Test
    void aStopDoesNotWaitForIt() throws IOException {
        Stop stop = new Stop();
        stop.request();
        assertThatThrownBy(() -> new Mitsuba(1, stop)).isInstanceOfAny(InterruptedIOException.class, WrongUsage.class);
    }

    @Test
    void eachIsAskedForWhatItRenders() {
        assertThat(Run.cli("bench", "--against", "mitsuba", "--scene", "box,few").err()).contains("--against mitsuba does not go with --scene few: it is for box, interior1M, ring1M");
        assertThat(Run.cli("bench", "--against", "mitsuba", "--scale").err()).contains("--against mitsuba does not go with --scale: it is for box, interior1M, ring1M");
        Run paths = Run.cli("bench", "--against", "povray", "--scene", "interior1M");
        assertThat(paths.err()).contains("--against povray does not go with --scene interior1M: POV-Ray follows no paths; --against mitsuba does");
        assertThat(paths.code()).isEqualTo(ExitCode.WRONG_USAGE);
    }
}
