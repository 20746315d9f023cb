package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.image.Image;
import cz.paprsek.render.RenderResult.Outcome;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Pictures that are begun, and waited for elsewhere. */
class StartedTest {
    private final ExecutorService executor = Executors.newSingleThreadExecutor();

    @AfterEach
    void end() {
        executor.shutdownNow();
    }

    private static Scene scene() throws Exception {
        Scene scene = SceneFiles.read(Path.of("../scenes/glass.xml"));
        return scene.withSettings(scene.settings().withSize(64, 48).withSamples(1));
    }

    @Test
    void itIsThePictureThatOthersWaitFor() throws Exception {
        Scene scene = scene();
        CompletableFuture<Image> picture = Renderer.start(RenderScene.of(scene), RenderOptions.of(scene), RenderMonitor.NONE, executor).thenApply(RenderResult::image);
        Image waited = Renderer.render(scene);
        assertThat(picture.get(60, TimeUnit.SECONDS).toLinear()).isEqualTo(waited.toLinear());
        float[] linear = waited.toLinear();
        assertThat(linear).hasSize(3 * 64 * 48);
        assertThat(linear[3 * (17 * 64 + 31) + 1]).isEqualTo(waited.green(31, 17));
    }

    @Test
    void whoeverCancelsStopsIt() throws Exception {
        Scene scene = scene();
        CountDownLatch begun = new CountDownLatch(1);
        CompletableFuture<RenderResult> started = Renderer.start(RenderScene.of(scene), RenderOptions.of(scene.withSettings(scene.settings().withSize(4000, 4000))), new RenderMonitor() {
            @Override
            public void traced(long rays) {
                begun.countDown();
            }
        }, executor);
        assertThat(begun.await(60, TimeUnit.SECONDS)).isTrue();
        assertThat(started.cancel(true)).isTrue();
        // The one thread is free again long before so many pixels can be done.
        executor.submit(() -> {}).get(10, TimeUnit.SECONDS);
        assertThat(started).isCancelled();
    }

    @Test
    void aMonitorIsAskedAndHeardAsEver() throws Exception {
        Scene scene = scene();
        RenderMonitor stopping = new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return true;
            }
        };
        assertThat(Renderer.start(RenderScene.of(scene), RenderOptions.of(scene), stopping, executor).get(60, TimeUnit.SECONDS).outcome()).isEqualTo(Outcome.CANCELLED);
        RenderMonitor failing = new RenderMonitor() {
            @Override
            public void finished(Tile tile, Image image, int done, int total) {
                throw new IllegalArgumentException("mine");
            }
        };
        CompletableFuture<RenderResult> failed = Renderer.start(RenderScene.of(scene), RenderOptions.of(scene), failing, executor);
        assertThatThrownBy(failed::join).isInstanceOf(CompletionException.class).cause().isInstanceOf(IllegalStateException.class).hasRootCauseMessage("mine");
    }

    @Test
    void anExecutorThatTakesNoMoreSaysSoAtOnce() throws Exception {
        Scene scene = scene();
        executor.shutdown();
        assertThatThrownBy(() -> Renderer.start(RenderScene.of(scene), RenderOptions.of(scene), RenderMonitor.NONE, executor)).isInstanceOf(RejectedExecutionException.class);
    }
}
