package cz.paprsek.cli.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.image.Image;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.Tile;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.assertj.core.data.Percentage;
import org.junit.jupiter.api.Test;

class PaceTest {
    @Test
    void evenWorkTakesAsLongAsItsShare() {
        Pace pace = new Pace(1000);
        assertThat(pace.secondsLeft(1)).isNaN();
        for (int i = 1; i <= 100; i++) {
            pace.traced(1, i);
        }
        assertThat(pace.share()).isEqualTo(0.1);
        assertThat(pace.secondsLeft(100)).isCloseTo(900, within(1e-9));
    }

    @Test
    void pixelsThatEndWhenTheyAreNearEnoughTellTheirShareAndNoTime() {
        Pace pace = new Pace(1000);
        pace.settled(0.25);
        pace.settled(0.125);
        assertThat(pace.share()).isEqualTo(0.25);
        assertThat(pace.secondsLeft(100)).isNaN();
        assertThat(ProgressBar.line(79, "a.xml", pace.share(), pace.pixelsPerSecond(100), pace.secondsLeft(100))).contains("25 %").doesNotContain("NaN").doesNotContain("left");
    }

    @Test
    void whatWasThereAlreadyIsNoSpeed() {
        Pace pace = new Pace(1000);
        pace.found(500);
        for (int i = 1; i <= 50; i++) {
            pace.traced(1, 2 * i);
        }
        assertThat(pace.share()).isEqualTo(0.55);
        assertThat(pace.secondsLeft(100)).isCloseTo(900, within(1e-9));
    }

    @Test
    void aMachineThatHasBecomeSlowerIsNoticed() {
        Pace pace = new Pace(10_000);
        for (int i = 1; i <= 100; i++) {
            pace.traced(10, i);
        }
        for (int i = 1; i <= 200; i++) {
            pace.traced(1, 100 + i);
        }
        assertThat(pace.secondsLeft(300)).isCloseTo(8800, Percentage.withPercentage(25));
    }

    /** Rays are what time is spent on; unlike it, they are the same on a busy machine. */
    @Test
    void theRestOfTheShowcaseIsForetoldWithinAQuarter() throws Exception {
        Scene scene = SceneFiles.read(Path.of("../scenes/showcase.xml"));
        RenderOptions options = RenderOptions.of(scene.settings().withSize(1280, 720).withSamples(1)).withThreads(1);
        List<long[]> tiles = new ArrayList<>();
        Renderer.render(RenderScene.of(scene), options, new RenderMonitor() {
            private long rays;

            @Override
            public void traced(long more) {
                rays = more;
            }

            @Override
            public void finished(Tile tile, Image image, int done, int total) {
                tiles.add(new long[] {(long) tile.width() * tile.height(), rays});
            }
        });
        double work = tiles.stream().mapToLong(tile -> tile[1]).sum();
        Pace pace = new Pace(1280 * 720);
        double spent = 0;
        List<Double> shares = new ArrayList<>(List.of(0.05, 0.1, 0.25, 0.5, 0.75));
        for (long[] tile : tiles) {
            spent += tile[1];
            pace.traced(tile[0], spent);
            if (!shares.isEmpty() && pace.share() >= shares.get(0)) {
                assertThat(pace.secondsLeft(spent)).as("at %s", shares.remove(0)).isCloseTo(work - spent, Percentage.withPercentage(25));
            }
        }
        assertThat(shares).isEmpty();
    }
}
