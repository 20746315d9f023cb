package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.live.LiveListener;
import cz.paprsek.render.live.LivePass;
import cz.paprsek.render.live.LiveRender;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LiveRenderTest {
    private static final Scene SCENE = Scenes.random(11, 40);
    private static final RenderSettings SMALL = new RenderSettings(101, 67, 5, 1);
    /** More than any machine renders while a test runs. */
    private static final RenderSettings ENDLESS = new RenderSettings(6000, 6000, 5, 16);

    private final LiveRender live = new LiveRender(2);

    @AfterEach
    void close() {
        live.close();
    }

    @ParameterizedTest
    @CsvSource({"1, 0", "3, 0", "1, 1", "2, 4"})
    void theLastPictureIsThatOfTheRendererToTheBit(int samples, int mostSamples) throws Exception {
        RenderSettings settings = SMALL.withSamples(samples, mostSamples).withFilter(PixelFilter.TENT);
        Watcher watcher = new Watcher();
        live.show(SCENE, settings, watcher);
        Image last = get(watcher.last);
        assertThat(Scenes.difference(last, Renderer.render(SCENE.withSettings(settings)), 0)).isZero();
    }

    @Test
    void theFirstPassComesAsAWholeAndEveryFurtherOneIsFiner() throws Exception {
        Watcher watcher = new Watcher();
        live.show(SCENE, SMALL.withSamples(2), watcher);
        get(watcher.last);
        assertThat(watcher.steps).containsExactly(8, 4, 2, 1, 1);
        assertThat(watcher.tilesOfFirst).isEqualTo(1);
    }

    /** One in a pixel, four, sixteen, then all. */
    @Test
    void pathsAreFewAtFirstAndMoreInEachFurtherPass() throws Exception {
        RenderSettings settings = SMALL.withSize(40, 30).withIntegrator(Integrator.PATH).withSamples(20);
        Watcher watcher = new Watcher();
        live.show(SCENE, settings, watcher);
        Image last = get(watcher.last);
        assertThat(watcher.steps).containsExactly(8, 4, 2, 1, 1, 1, 1);
        assertThat(Scenes.difference(last, Renderer.render(SCENE.withSettings(settings)), 0)).isZero();
    }

    @Test
    void theThreadsOfOnePictureAreThoseOfTheNext() throws Exception {
        Set<Thread> threads = ConcurrentHashMap.newKeySet();
        for (int i = 0; i < 5; i++) {
            Watcher watcher = new Watcher() {
                @Override
                public void painted(LivePass pass, Image image, Tile tile) {
                    if (first.isDone()) {
                        threads.add(Thread.currentThread());
                    }
                }
            };
            live.show(SCENE.withCamera(SCENE.camera().withPosition(new Vec3(0.01 * i, 0, 5))), SMALL, watcher);
            get(watcher.last);
        }
        assertThat(threads).isNotEmpty().hasSizeLessThanOrEqualTo(2).allMatch(Thread::isAlive);
        live.close();
        for (Thread thread : threads) {
            thread.join(10_000);
        }
        assertThat(threads).noneMatch(Thread::isAlive);
    }

    @Test
    void aCoarsePassIsTheSameViewWithLargerPixels() throws Exception {
        Watcher watcher = new Watcher();
        live.show(SCENE, SMALL.withSize(96, 64), watcher);
        Image first = get(watcher.first);
        assertThat(Scenes.difference(first, Renderer.render(SCENE.withSettings(SMALL.withSize(12, 8))), 0)).isZero();
    }

    @Test
    void whatMovesIsRefinedWhenItHasStoodStill() throws Exception {
        Watcher before = new Watcher();
        live.show(SCENE, SMALL, before);
        get(before.last);
        Watcher moved = new Watcher();
        long start = System.nanoTime();
        live.show(SCENE, SMALL, new Watcher());
        live.show(SCENE.withLights(List.of()), SMALL, moved);
        get(moved.last);
        assertThat(System.nanoTime() - start).isGreaterThanOrEqualTo(50_000_000);
        assertThat(moved.steps).hasSizeGreaterThan(1).endsWith(1);
    }

    @Test
    void aNewSceneStopsTheRefiningOfTheOldOne() throws Exception {
        Watcher old = new Watcher();
        live.show(SCENE, ENDLESS, old);
        get(old.first);
        Watcher next = new Watcher();
        live.show(SCENE.withLights(List.of()), SMALL, next);
        assertThat(Scenes.difference(get(next.last), Renderer.render(SCENE.withLights(List.of()).withSettings(SMALL)), 0)).isZero();
        assertThat(old.last).isNotDone();
    }

    @Test
    void changesThatNeverPauseAreStillSeen() throws Exception {
        Watcher[] watchers = new Watcher[30];
        for (int i = 0; i < watchers.length; i++) {
            watchers[i] = new Watcher();
            Camera moved = SCENE.camera().withPosition(new Vec3(0.01 * i, 0, 5));
            live.show(SCENE.withCamera(moved), SMALL.withSize(640, 480), watchers[i]);
            if (i % 3 == 2) {
                get(watchers[i - 2].first.applyToEither(watchers[i - 1].first, image -> image).applyToEither(watchers[i].first, image -> image));
            }
        }
        get(watchers[watchers.length - 1].last);
    }

    @Test
    void stoppingEndsAFirstPassToo() throws Exception {
        Scene huge = SCENE.withSettings(ENDLESS.withSize(32_000, 20_000));
        Watcher stopped = new Watcher();
        live.show(huge, huge.settings(), stopped);
        live.stop();
        Watcher next = new Watcher();
        live.show(SCENE, SMALL, next);
        get(next.last);
        assertThat(stopped.last).isNotDone();
    }

    @Test
    void aFaultIsToldAndTheNextSceneIsRendered() throws Exception {
        CompletableFuture<Throwable> failed = new CompletableFuture<>();
        live.show(SCENE, SMALL, new LiveListener() {
            @Override
            public void painted(LivePass pass, Image image, Tile tile) {
                throw new UnsupportedOperationException("no");
            }

            @Override
            public void failed(Throwable fault) {
                failed.complete(fault);
            }
        });
        assertThat(get(failed)).hasMessageContaining("no");
        Watcher next = new Watcher();
        live.show(SCENE, SMALL, next);
        get(next.last);
    }

    private static <T> T get(CompletableFuture<T> future) throws InterruptedException, ExecutionException, TimeoutException {
        return future.get(60, TimeUnit.SECONDS);
    }

    /** Remembers the first and the last picture. */
    private static class Watcher implements LiveListener {
        final CompletableFuture<Image> first = new CompletableFuture<>();
        final CompletableFuture<Image> last = new CompletableFuture<>();
        final List<Integer> steps = new ArrayList<>();
        int tilesOfFirst;

        @Override
        public void painted(LivePass pass, Image image, Tile tile) {
            tilesOfFirst += first.isDone() ? 0 : 1;
        }

        @Override
        public void completed(LivePass pass, RenderResult result) {
            steps.add(pass.step());
            first.complete(result.image());
            if (pass.isLast()) {
                last.complete(result.image());
            }
        }

        @Override
        public void failed(Throwable fault) {
            first.completeExceptionally(fault);
            last.completeExceptionally(fault);
        }
    }
}
