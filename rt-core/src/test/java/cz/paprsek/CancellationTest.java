package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult.Outcome;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.standard.StandardScenes;
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

    /** Some work that stops at a deadline. */
    @FunctionalInterface
    private interface Work {
        /** Whether the work was cancelled, rather than done before its time was up. */
        boolean isCancelled(Deadline deadline) throws Exception;
    }

    @TempDir
    Path folder;

    @Test
    void readingIsCancelled() throws Exception {
        Path file = folder.resolve("cloud.xml");
        SceneFiles.write(StandardScenes.cloud(200_000), file);
        report("reading", 250, deadline -> throwsCancellation(() -> SceneFiles.read(file, deadline)));
    }

    @Test
    void buildingIsCancelled() throws Exception {
        Scene scene = StandardScenes.cloud(500_000);
        report("building", 200, deadline -> throwsCancellation(() -> RenderScene.of(scene, deadline)));
    }

    @Test
    void tracingIsCancelled() throws Exception {
        List<RenderScene> scenes = List.of(RenderScene.of(StandardScenes.flake(4)), RenderScene.of(StandardScenes.chain(300)),
                RenderScene.of(StandardScenes.cloud(100_000)), RenderScene.of(StandardScenes.few()));
        Random random = new Random(1);
        report("tracing", 300, deadline -> {
            RenderScene scene = scenes.get(random.nextInt(scenes.size()));
            return Renderer.render(scene, RenderOptions.of(SLOW), deadline).outcome() == Outcome.CANCELLED;
        });
    }

    private static boolean throwsCancellation(Callable<?> work) throws Exception {
        try {
            work.call();
            return false;
        } catch (CancellationException e) {
            return true;
        }
    }

    /** @param latest the latest moment at which the work is cancelled, milliseconds after it began */
    @SuppressWarnings("SystemGc") // What the kinds of work before this one have left is not to be collected in this one's time.
    private static void report(String what, int latest, Work work) throws Exception {
        System.gc();
        Random random = new Random(2);
        long[] nanos = new long[CANCELS];
        int tried = 0;
        for (int i = 0; i < CANCELS; tried++) {
            assertThat(tried).as("most work is still going on when it is cancelled").isLessThan(100 * CANCELS);
            Deadline deadline = new Deadline(System.nanoTime() + random.nextInt(latest) * 1_000_000L);
            if (work.isCancelled(deadline)) {
                nanos[i++] = System.nanoTime() - deadline.nanoTime();
            }
            assertThat(Thread.getAllStackTraces().keySet()).noneMatch(thread -> thread.getName().startsWith("paprsek-render"));
        }
        Arrays.sort(nanos);
        System.out.printf("%s cancelled %d times of %d: answered after %.1f ms at the median, %.1f ms at the 99th percentile, %.1f ms at most%n",
                what, CANCELS, tried, nanos[CANCELS / 2] / 1e6, nanos[CANCELS * 99 / 100] / 1e6, nanos[CANCELS - 1] / 1e6);
    }
}
