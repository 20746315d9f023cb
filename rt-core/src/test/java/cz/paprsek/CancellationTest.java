package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderResult.Outcome;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.StandardScenes;
import cz.paprsek.xml.ReadMonitor;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Work is cancelled at random moments: it ends, no thread is left, and how long it took to answer is printed. How often is the system property
 * {@code paprsek.cancels}, {@value #FEW} if not given; the times mean something only on a machine with nothing else to do.
 */
class CancellationTest {
    private static final int FEW = 8;
    private static final int CANCELS = Integer.getInteger("paprsek.cancels", FEW);
    private static final RenderSettings SLOW = new RenderSettings(4000, 4000, 20, 8);

    /** Cancels from a given moment on. */
    private record Deadline(long nanoTime) implements RenderMonitor, ReadMonitor {
        @Override
        public boolean cancelled() {
            return System.nanoTime() - nanoTime >= 0;
        }
    }

    @TempDir
    Path folder;

    @Test
    void readingIsCancelled() throws Exception {
        Path file = folder.resolve("cloud.xml");
        SceneFiles.write(StandardScenes.cloud(200_000), file);
        Random random = new Random(3);
        report("reading", () -> {
            long at = System.nanoTime() + random.nextInt(250) * 1_000_000L;
            try {
                SceneFiles.read(file, new Deadline(at));
                // Read before its time was up: nothing to answer.
                return System.nanoTime();
            } catch (CancellationException e) {
                return at;
            }
        });
    }

    @Test
    void tracingIsCancelled() throws Exception {
        List<RenderScene> scenes = List.of(RenderScene.of(StandardScenes.flake(4)), RenderScene.of(StandardScenes.chain(300)),
                RenderScene.of(StandardScenes.cloud(100_000)), RenderScene.of(StandardScenes.few()));
        Random random = new Random(1);
        report("tracing", () -> {
            RenderScene scene = scenes.get(random.nextInt(scenes.size()));
            long at = System.nanoTime() + random.nextInt(300) * 1_000_000L;
            RenderResult result = Renderer.render(scene, RenderOptions.of(SLOW), new Deadline(at));
            assertThat(result.outcome()).isEqualTo(Outcome.CANCELLED);
            return at;
        });
    }

    @Test
    void buildingIsCancelled() throws Exception {
        Scene scene = StandardScenes.cloud(500_000);
        Random random = new Random(2);
        report("building", () -> {
            long at = System.nanoTime() + random.nextInt(200) * 1_000_000L;
            try {
                RenderScene.of(scene, new Deadline(at));
                // Built before its time was up: nothing to answer.
                return System.nanoTime();
            } catch (CancellationException e) {
                return at;
            }
        });
    }

    /** @param work cancels some work and returns the moment from which on it was asked to stop */
    @SuppressWarnings("SystemGc") // What the kinds of work before this one have left is not to be collected in this one's time.
    private static void report(String what, Callable<Long> work) throws Exception {
        System.gc();
        long[] nanos = new long[CANCELS];
        for (int i = 0; i < CANCELS; i++) {
            long asked = work.call();
            nanos[i] = System.nanoTime() - asked;
            assertThat(Thread.getAllStackTraces().keySet()).noneMatch(thread -> thread.getName().startsWith("paprsek-render"));
        }
        Arrays.sort(nanos);
        System.out.printf("%s cancelled %d times: answered after %.1f ms at the median, %.1f ms at the 99th percentile, %.1f ms at most%n",
                what, CANCELS, nanos[CANCELS / 2] / 1e6, nanos[CANCELS * 99 / 100] / 1e6, nanos[CANCELS - 1] / 1e6);
    }
}
