package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import cz.paprsek.image.Image;
import cz.paprsek.material.Rgb;
import cz.paprsek.render.RenderResult.Outcome;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.live.LiveListener;
import cz.paprsek.render.live.LivePass;
import cz.paprsek.render.live.LiveRender;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.standard.StandardScenes;
import cz.paprsek.xml.ReadMonitor;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CancellationException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Whatever a monitor or a listener throws, and whoever interrupts: it is told, nobody waits for ever, and no thread is left. */
@Timeout(60)
class FaultsTest {
    private static final Scene SCENE = Scenes.random(11, 40).withSettings(new RenderSettings(101, 67, 5, 1));

    @AfterEach
    void noThreadIsLeft() {
        assertThat(Thread.getAllStackTraces().keySet()).noneMatch(thread -> thread.getName().startsWith("paprsek-render"));
    }

    static Stream<Throwable> everyKindOfThrowable() {
        return Stream.of(new IllegalArgumentException("mine"), new CancellationException("mine"), new AssertionError("mine"),
                new StackOverflowError("mine"), new OutOfMemoryError("mine"), new LinkageError("mine"), new IOException("mine"),
                new InterruptedException("mine"), new Throwable("mine"));
    }

    static Stream<Arguments> everyMethodAndThrowable() {
        return Stream.of("cancelled", "load", "save", "found", "traced", "finished", "the last finished")
                .flatMap(method -> everyKindOfThrowable().map(thrown -> Arguments.of(method, thrown)));
    }

    /** Throws in one of its methods. */
    private record Throwing(String method, Throwable thrown) implements RenderMonitor, ReadMonitor, TileStore {
        private void call(String name) {
            if (name.equals(method)) {
                throw FaultsTest.<RuntimeException>sneaky(thrown);
            }
        }

        @Override
        public boolean cancelled() {
            call("cancelled");
            return false;
        }

        @Override
        public boolean load(Tile tile, int pass, Film into) {
            call("load");
            return method.equals("found");
        }

        @Override
        public void save(Tile tile, int pass, Film from) {
            call("save");
        }

        @Override
        public void found(Tile tile, Image image, int done, int total) {
            call("found");
        }

        @Override
        public void traced(long rays) {
            call("traced");
        }

        @Override
        public void finished(Tile tile, Image image, int done, int total) {
            call("finished");
            call(done == total ? "the last finished" : "one of the others");
        }

        @Override
        public void read(long bytes, long total) {
            call("read");
        }
    }

    /** Other languages need not declare what they throw. */
    @SuppressWarnings({"unchecked", "TypeParameterUnusedInFormals"})
    private static <T extends Throwable> T sneaky(Throwable thrown) throws T {
        throw (T) thrown;
    }

    @ParameterizedTest
    @MethodSource("everyMethodAndThrowable")
    void whatAMonitorThrowsIsTheCauseOfWhatIsThrown(String method, Throwable thrown) {
        for (int threads : new int[] {1, 4}) {
            RenderOptions options = RenderOptions.of(SCENE).withThreads(threads);
            RenderScene ready = RenderScene.of(SCENE);
            Throwing monitor = new Throwing(method, thrown);
            assertThatThrownBy(() -> Renderer.render(ready, options, monitor, monitor)).isExactlyInstanceOf(IllegalStateException.class).cause().isSameAs(thrown);
            assertThatThrownBy(() -> Renderer.render(SCENE, options, monitor, monitor)).isExactlyInstanceOf(IllegalStateException.class)
                    .matches(told -> method.equals("cancelled") || !told.toString().contains(" at pixel "), "of no pixel").cause().isSameAs(thrown);
        }
    }

    @ParameterizedTest
    @MethodSource("everyKindOfThrowable")
    void whatAMonitorThrowsWhileASceneIsPreparedIsTheCauseToo(Throwable thrown) {
        Scene large = StandardScenes.cloud(20_000);
        RenderScene small = RenderScene.of(SCENE);
        assertThatThrownBy(() -> RenderScene.of(large, new Throwing("cancelled", thrown)))
                .isExactlyInstanceOf(IllegalStateException.class).cause().isSameAs(thrown);
        assertThatThrownBy(() -> small.changedTo(large, new Throwing("cancelled", thrown)))
                .isExactlyInstanceOf(IllegalStateException.class).cause().isSameAs(thrown);
    }

    @Test
    void whatAMonitorThrowsOnAThreadOfThePoolIsTheCauseItself() {
        Scene large = StandardScenes.cloud(100_000);
        Thread caller = Thread.currentThread();
        Error thrown = new Error("mine");
        RenderMonitor elsewhere = new RenderMonitor() {
            @Override
            public boolean cancelled() {
                if (Thread.currentThread() != caller) {
                    throw thrown;
                }
                return false;
            }
        };
        Throwable told = catchThrowable(() -> RenderScene.of(large, elsewhere));
        // On one processor there is no pool.
        if (told != null || Runtime.getRuntime().availableProcessors() > 1) {
            assertThat(told).isExactlyInstanceOf(IllegalStateException.class).cause().isSameAs(thrown);
        }
    }

    @ParameterizedTest
    @MethodSource("everyKindOfThrowable")
    void whatAMonitorOfReadingThrowsIsTheCauseTooAndNotTakenForAFaultOfTheFile(Throwable thrown, @TempDir Path folder) throws IOException {
        Path file = folder.resolve("a.xml");
        SceneFiles.write(SCENE, file);
        for (String method : List.of("cancelled", "read")) {
            assertThatThrownBy(() -> SceneFiles.read(file, new Throwing(method, thrown)))
                    .isExactlyInstanceOf(IllegalStateException.class).cause().isSameAs(thrown);
        }
    }

    /** Two threads, or a monitor, that share a renderer would get parts of each other's pictures, or wait for ever. */
    @Test
    @SuppressWarnings("try") // Closed within, on purpose.
    void aRendererMakesOnePictureAtATimeAndNoneOnceItIsClosed() {
        RenderScene ready = RenderScene.of(SCENE);
        RenderOptions options = RenderOptions.of(SCENE).withThreads(2);
        try (Renderer renderer = Renderer.keeping("kept")) {
            for (Runnable meanwhile : List.<Runnable>of(() -> renderer.next(ready, options, RenderMonitor.NONE), renderer::close)) {
                assertThatThrownBy(() -> renderer.next(ready, options, new RenderMonitor() {
                    @Override
                    public void finished(Tile tile, Image image, int done, int total) {
                        meanwhile.run();
                    }
                })).isInstanceOf(IllegalStateException.class).cause().isInstanceOf(IllegalStateException.class).message().containsAnyOf("one picture at a time", "cannot be closed by");
            }
            assertThat(renderer.next(ready, options, RenderMonitor.NONE).image().toArgb()).isEqualTo(Renderer.render(SCENE).toArgb());
            renderer.close();
            assertThatThrownBy(() -> renderer.next(ready, options, RenderMonitor.NONE)).isInstanceOf(IllegalStateException.class).hasMessageContaining("closed");
        }
        assertThat(Thread.getAllStackTraces().keySet()).noneMatch(thread -> thread.getName().startsWith("kept"));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 20, 150})
    void anInterruptedThreadGetsNoPicture(int millis) throws InterruptedException {
        Scene slow = SCENE.withBackground(Rgb.WHITE).withSettings(new RenderSettings(4000, 4000, 20, 8));
        interrupt(millis, () -> assertThatThrownBy(() -> Renderer.render(slow)).isExactlyInstanceOf(CancellationException.class));
        interrupt(millis, () -> assertThat(Renderer.render(slow, RenderOptions.of(slow), RenderMonitor.NONE).outcome()).isEqualTo(Outcome.CANCELLED));
        Scene large = StandardScenes.cloud(2_000_000);
        interrupt(millis, () -> assertThatThrownBy(() -> RenderScene.of(large)).isExactlyInstanceOf(CancellationException.class));
    }

    /** Does some work in a thread that is interrupted after a while, and stays so. */
    private static void interrupt(int millis, Runnable work) throws InterruptedException {
        AtomicReference<Throwable> failure = new AtomicReference<>();
        Thread thread = new Thread(() -> {
            failure.set(catchThrowable(work::run));
            if (!Thread.currentThread().isInterrupted()) {
                failure.compareAndSet(null, new AssertionError("the thread is no longer interrupted"));
            }
        });
        thread.start();
        Thread.sleep(millis);
        thread.interrupt();
        thread.join();
        assertThat(failure.get()).isNull();
    }

    @ParameterizedTest
    @MethodSource("everyKindOfThrowable")
    void whatAListenerThrowsIsToldAndTheNextOneIsServed(Throwable thrown) throws InterruptedException {
        for (String method : List.of("painted", "completed", "painted and failed")) {
            try (LiveRender live = new LiveRender(2)) {
                BlockingQueue<Throwable> told = new LinkedBlockingQueue<>();
                live.show(SCENE, SCENE.settings(), listener(method, thrown, told::add));
                Throwable first = told.poll(30, TimeUnit.SECONDS);
                assertThat(first == thrown || (first != null && first.getCause() == thrown)).as(method + ": " + first).isTrue();
                BlockingQueue<Throwable> next = new LinkedBlockingQueue<>();
                Throwable seen = new Throwable("a picture");
                live.show(SCENE, SCENE.settings(), listener("completed", seen, next::add));
                assertThat(next.poll(30, TimeUnit.SECONDS)).isSameAs(seen);
            }
        }
    }

    @Test
    void aListenerThatInterruptsIsToldAndTheNextOneIsServed() throws InterruptedException {
        try (LiveRender live = new LiveRender(2)) {
            BlockingQueue<Throwable> told = new LinkedBlockingQueue<>();
            live.show(SCENE, SCENE.settings(), new LiveListener() {
                @Override
                public void painted(LivePass pass, Image image, Tile tile) {}

                @Override
                public void completed(LivePass pass, RenderResult result) {
                    Thread.currentThread().interrupt();
                }

                @Override
                public void failed(Throwable fault) {
                    told.add(fault);
                }
            });
            assertThat(told.poll(30, TimeUnit.SECONDS)).hasMessageContaining("interrupted");
            Throwable seen = new Throwable("a picture");
            live.show(SCENE, SCENE.settings(), listener("completed", seen, told::add));
            assertThat(told.poll(30, TimeUnit.SECONDS)).isSameAs(seen);
        }
    }

    /** Throws in some of its methods, after it has told what it was told of. */
    private static LiveListener listener(String methods, Throwable thrown, Consumer<Throwable> told) {
        return new LiveListener() {
            @Override
            public void painted(LivePass pass, Image image, Tile tile) {
                call("painted");
            }

            @Override
            public void completed(LivePass pass, RenderResult result) {
                call("completed");
            }

            @Override
            public void failed(Throwable fault) {
                told.accept(fault);
                Thread.currentThread().setUncaughtExceptionHandler((thread, again) -> {});
                call("failed");
            }

            private void call(String name) {
                if (methods.contains(name)) {
                    throw FaultsTest.<RuntimeException>sneaky(thrown);
                }
            }
        };
    }
}
