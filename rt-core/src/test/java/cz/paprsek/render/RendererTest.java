package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.management.ThreadMXBean;
import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.material.CustomPattern;
import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderResult.Outcome;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.integrate.Paths;
import cz.paprsek.render.integrate.Whitted;
import cz.paprsek.render.mode.RenderMode;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.Bodies;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.standard.StandardScenes;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RendererTest {
    private static final int ROUNDS = 5;
    private static final Scene SCENE = Scenes.random(11, 40).withSettings(new RenderSettings(101, 67, 5, 1));

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 8})
    void everyThreadCountGivesTheSameBytes(int threads) {
        RenderScene scene = RenderScene.of(SCENE);
        Image one = Renderer.render(scene, RenderOptions.of(SCENE).withThreads(1), RenderMonitor.NONE).image();
        Image many = Renderer.render(scene, RenderOptions.of(SCENE).withThreads(threads), RenderMonitor.NONE).image();
        assertThat(Scenes.difference(one, many, 0)).isZero();
    }

    @Test
    void rowsAreFinishedFromTheTopIfThatIsWanted() {
        List<Tile> order = new ArrayList<>();
        RenderMonitor monitor = new RenderMonitor() {
            @Override
            public boolean wantsRows() {
                return true;
            }

            @Override
            public void finished(Tile tile, Image image, int done, int total) {
                order.add(tile);
            }
        };
        Image rows = Renderer.render(RenderScene.of(SCENE), RenderOptions.of(SCENE).withThreads(1), monitor).image();
        assertThat(order).hasSizeGreaterThan(9).isSortedAccordingTo(Comparator.comparingInt(Tile::y).thenComparingInt(Tile::x));
        assertThat(Scenes.difference(rows, Renderer.render(SCENE), 0)).isZero();
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void soItDoesThroughAnyLensInAnyLight(long seed) {
        Scene scene = Scenes.randomlySeen(seed, 20);
        RenderScene prepared = RenderScene.of(scene);
        RenderOptions options = RenderOptions.of(scene.settings().withSize(70, 50));
        Image one = Renderer.render(prepared, options.withThreads(1), RenderMonitor.NONE).image();
        assertThat(Scenes.difference(one, Renderer.render(prepared, options.withThreads(3), RenderMonitor.NONE).image(), 0)).isZero();
        Image part = Renderer.render(prepared, options.withRegion(new Tile(13, 11, 37, 29)), RenderMonitor.NONE).image();
        assertThat(Scenes.difference(part, crop(one, 13, 11, 37, 29), 0)).isZero();
    }

    /** Also when rays before a pixel's have left something behind: what stood in their way, and whether they were many. */
    @ParameterizedTest
    @CsvSource({"NODES, WHITTED, 2", "NODES, PATH, 3", "RAYS, WHITTED, 2", "RAYS, PATH, 3"})
    void whatAPixelTakesIsTheSameInAnyPart(RenderMode mode, Integrator integrator, int samples) {
        for (Scene scene : List.of(StandardScenes.few(), StandardScenes.cloud(8), SCENE)) {
            RenderScene prepared = RenderScene.of(scene);
            RenderSettings settings = scene.settings().withSize(240, 180).withIntegrator(integrator).withSamples(samples);
            RenderOptions options = RenderOptions.of(settings).withMode(mode).withNumbers().withThreads(2);
            Image whole = Renderer.render(prepared, options, RenderMonitor.NONE).image();
            for (Tile tile : List.of(new Tile(110, 90, 3, 2), new Tile(20, 150, 210, 20))) {
                Image part = Renderer.render(prepared, options.withRegion(tile), RenderMonitor.NONE).image();
                assertThat(Scenes.difference(part, crop(whole, tile.x(), tile.y(), tile.width(), tile.height()), 0)).isZero();
            }
        }
    }

    private static Image crop(Image whole, int left, int top, int width, int height) {
        Image crop = new Image(width, height);
        for (int i = 0; i < width * height; i++) {
            int x = i % width;
            int y = i / width;
            crop.set(x, y, whole.red(left + x, top + y), whole.green(left + x, top + y), whole.blue(left + x, top + y));
        }
        return crop;
    }

    /** So many shadow rays go to each of its lights that buffers of these are made; to a part so few that there are none. */
    @Test
    void aLargePictureIsThatOfItsPartsToTheBit() {
        Scene scene = Scenes.random(7, 40);
        scene = scene.withSettings(scene.settings().withSize(480, 272));
        RenderOptions options = RenderOptions.of(scene);
        RenderScene prepared = RenderScene.of(scene);
        RenderResult whole = Renderer.render(prepared, options.withThreads(2), RenderMonitor.NONE);
        assertThat(lightBuffers(prepared)).isEqualTo(3);
        for (int y = 0; y < 272; y += 4) {
            RenderScene other = RenderScene.of(scene);
            Image part = Renderer.render(other, options.withRegion(new Tile(0, y, 480, 4)), RenderMonitor.NONE).image();
            assertThat(lightBuffers(other)).isZero();
            assertThat(Scenes.difference(part, crop(whole.image(), 0, y, 480, 4), 0)).isZero();
        }
    }

    /** Where nodes are counted, each pixel must find what it would find alone; and of many lights none has a buffer. */
    @Test
    void noLightBufferIsMadeWhereItWouldBeSeenOrTakeMuchMemory() {
        Scene scene = Scenes.random(7, 40);
        scene = scene.withSettings(scene.settings().withSize(480, 272));
        RenderScene counted = RenderScene.of(scene);
        Renderer.render(counted, RenderOptions.of(scene).withMode(RenderMode.NODES), RenderMonitor.NONE);
        assertThat(lightBuffers(counted)).isZero();
        Scene crowded = scene;
        for (int i = 0; i < 6; i++) {
            crowded = crowded.plus(Light.at(i, 9, 2));
        }
        RenderScene lit = RenderScene.of(crowded);
        Renderer.render(lit, RenderOptions.of(crowded), RenderMonitor.NONE);
        assertThat(lightBuffers(lit)).isZero();
    }

    /** How many lights have one. */
    private static long lightBuffers(RenderScene scene) {
        return Stream.of(scene.world().lamps()).filter(lamp -> scene.world().bodies().buffers().orElseThrow().known(lamp.place().orElseThrow()).isPresent()).count();
    }

    @Test
    void aRegionIsThatPartOfThePictureToTheBit() {
        RenderScene scene = RenderScene.of(SCENE);
        for (RenderSettings settings : List.of(SCENE.settings(), SCENE.settings().withSamples(2), SCENE.settings().withSamples(3),
                SCENE.settings().withSamples(2, 4), SCENE.settings().withSamples(3, 4).withFilter(PixelFilter.MITCHELL))) {
            RenderOptions options = RenderOptions.of(settings);
            Image whole = Renderer.render(scene, options, RenderMonitor.NONE).image();
            Image part = Renderer.render(scene, options.withRegion(new Tile(13, 21, 37, 29)), RenderMonitor.NONE).image();
            assertThat(Scenes.difference(part, crop(whole, 13, 21, 37, 29), 0)).isZero();
        }
    }

    @Test
    void samplesAverageTheRaysOfALargerPicture() {
        RenderScene scene = RenderScene.of(SCENE);
        Image fine = Renderer.render(scene, RenderOptions.of(SCENE.settings().withSize(120, 90)), RenderMonitor.NONE).image();
        Image averaged = Renderer.render(scene, RenderOptions.of(SCENE.settings().withSize(40, 30).withSamples(3)), RenderMonitor.NONE).image();
        Image expected = new Image(40, 30);
        for (int y = 0; y < 30; y++) {
            for (int x = 0; x < 40; x++) {
                double[] sum = new double[3];
                for (int i = 0; i < 9; i++) {
                    double[] pixel = Scenes.pixel(fine, 3 * x + i % 3, 3 * y + i / 3);
                    Arrays.setAll(sum, c -> sum[c] + pixel[c] / 9);
                }
                expected.set(x, y, sum[0], sum[1], sum[2]);
            }
        }
        assertThat(Scenes.difference(averaged, expected, 1e-5)).isLessThan(0.005);
    }

    @Test
    void theHierarchyFindsWhatTryingEverySurfaceFinds() {
        Random random = new Random(5);
        for (long seed = 1; seed <= 8; seed++) {
            Scene scene = Scenes.random(seed, 300);
            RenderScene ready = RenderScene.of(scene);
            Surface[] all = new Surface[scene.objects().size()];
            Arrays.setAll(all, ready.world()::surface);
            Bodies.Finder finder = ready.world().bodies().newFinder();
            Spans spans = new Spans();
            for (int i = 0; i < 4000; i++) {
                double[] n = random.doubles(6, -5, 5).toArray();
                double length = Math.sqrt(n[3] * n[3] + n[4] * n[4] + n[5] * n[5]);
                Ray fast = new Ray(spans);
                fast.start(n[0], n[1], n[2] + (i % 3), n[3] / length, n[4] / length, n[5] / length);
                Ray slow = new Ray(spans);
                slow.start(n[0], n[1], n[2] + (i % 3), n[3] / length, n[4] / length, n[5] / length);
                ready.world().bodies().nearest(fast, ready.world().bodies().whole(), finder);
                for (Surface surface : all) {
                    surface.nearest(slow);
                }
                assertThat(fast.max).isEqualTo(slow.max);
                assertThat(fast.part).isEqualTo(slow.part);
                fast.start(n[0], n[1], n[2], n[3] / length, n[4] / length, n[5] / length, 5, length, -1, false);
                boolean blocked = false;
                for (int k = 0; k < all.length; k++) {
                    blocked |= ready.world().isOpaque(k) && all[k].occludes(fast);
                }
                assertThat(ready.world().bodies().occluder(fast, ready.world().bodies().whole(), finder, spans) != null).isEqualTo(blocked);
                spans.release(0);
            }
        }
    }

    @Test
    void raysInABlockFindWhatEachFindsAlone() {
        RenderScene scene = RenderScene.of(SCENE);
        Eye eye = Eye.of(SCENE.camera(), 101, 67);
        Whitted alone = new Whitted(scene.world(), 5, Sampling.grid(1));
        Whitted together = new Whitted(scene.world(), 5, Sampling.grid(1));
        for (int y = 0; y < 56; y += 8) {
            for (int x = 0; x < 96; x += 8) {
                Level[] block = together.trace(eye, x, y, 8, 8);
                for (int i = 0; i < 64; i++) {
                    Level one = alone.trace(eye, x + i % 8, y + i / 8, 1, 1)[0];
                    assertThat(new double[] {block[i].red, block[i].green, block[i].blue}).containsExactly(one.red, one.green, one.blue);
                }
            }
        }
    }

    @Test
    void theOrderOfBlocksDoesNotMatter() {
        RenderScene scene = RenderScene.of(SCENE);
        Eye eye = Eye.of(SCENE.camera(), 101, 67);
        List<Integer> order = new ArrayList<>(IntStream.range(0, 12 * 8).boxed().toList());
        double[][] first = new double[order.size()][];
        for (long seed = 0; seed < 4; seed++) {
            Whitted tracer = new Whitted(scene.world(), 5, Sampling.grid(1));
            for (int block : order) {
                Level[] levels = tracer.trace(eye, block % 12 * 8, block / 12 * 8, 8, 8);
                double[] light = new double[192];
                for (int i = 0; i < 64; i++) {
                    light[3 * i] = levels[i].red;
                    light[3 * i + 1] = levels[i].green;
                    light[3 * i + 2] = levels[i].blue;
                }
                first[block] = seed == 0 ? light : first[block];
                assertThat(light).as("block %d in order %d", block, seed).containsExactly(first[block]);
            }
            Collections.shuffle(order, new Random(seed));
        }
    }

    @Test
    void anAdaptivePictureIsTheSameForAnyThreads() {
        Scene scene = SCENE.withSettings(SCENE.settings().withSamples(2, 5).withFilter(PixelFilter.GAUSS));
        Image one = Renderer.render(RenderScene.of(scene), RenderOptions.of(scene).withThreads(1), RenderMonitor.NONE).image();
        Image three = Renderer.render(RenderScene.of(scene), RenderOptions.of(scene).withThreads(3), RenderMonitor.NONE).image();
        assertThat(Scenes.difference(one, three, 0)).isZero();
    }

    @Test
    void tracingAllocatesNothing() {
        Whitted tracer = new Whitted(RenderScene.of(SCENE).world(), 5, Sampling.grid(1));
        Eye eye = Eye.of(SCENE.camera(), 101, 67);
        // The measurement itself costs some tens of bytes; a single object of 16 bytes in a thousand rays would show.
        assertThat(allocated((x, y) -> tracer.trace(eye, x, y, 8, 8))).as("bytes for a picture").isLessThan(200);
        assertThat(tracer.rays() / ROUNDS).isGreaterThan(10_000);
    }

    /** Which bundles of rays look for. Until it is compiled, vectors are objects. */
    @Test
    void soItDoesAmongThousandsOfMirrors() {
        Scene scene = StandardScenes.flake(4);
        Whitted tracer = new Whitted(RenderScene.of(scene).world(), 5, Sampling.grid(1));
        Eye eye = Eye.of(scene.camera(), 96, 56);
        long least = Long.MAX_VALUE;
        for (int i = 0; i < 100 && least > 200; i++) {
            least = Math.min(least, allocated((x, y) -> tracer.trace(eye, x, y, 8, 8)));
        }
        assertThat(least).as("bytes for a picture").isLessThan(200);
    }

    /** A pass of 64 in each of some pixels. */
    @Test
    void pathsAllocateNothingEach() {
        RenderSettings settings = SCENE.settings().withIntegrator(RenderSettings.Integrator.PATH).withSamples(64);
        Paths tracer = new Paths(RenderScene.of(SCENE).world(), 5, new Passes(settings, false));
        Eye eye = Eye.of(SCENE.camera(), 101, 67);
        // Some 100 bytes a pass are tables that StrictMath.pow makes, of highlights, now and then; a single object of 16 bytes in every eighth path would show.
        assertThat(allocated((x, y) -> tracer.trace(eye, x, y, 1, 1))).as("bytes for 84 passes").isLessThan(84 * 2 * 64);
        assertThat(tracer.rays() / ROUNDS).isGreaterThan(10_000);
    }

    private interface At {
        void trace(int x, int y);
    }

    /** The least of some rounds. */
    private static long allocated(At block) {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        long least = Long.MAX_VALUE;
        for (int round = 0; round < ROUNDS; round++) {
            long before = threads.getThreadAllocatedBytes(id);
            for (int y = 0; y < 56; y += 8) {
                for (int x = 0; x < 96; x += 8) {
                    block.trace(x, y);
                }
            }
            least = Math.min(least, threads.getThreadAllocatedBytes(id) - before);
        }
        return least;
    }

    @Test
    void cancellingReturnsWhatIsDone() {
        List<Tile> tiles = new ArrayList<>();
        RenderMonitor afterTwo = new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return tiles.size() >= 2;
            }

            @Override
            public void finished(Tile tile, Image image, int done, int total) {
                tiles.add(tile);
            }
        };
        RenderResult result = Renderer.render(RenderScene.of(SCENE), RenderOptions.of(SCENE).withThreads(1), afterTwo);
        assertThat(result.outcome()).isEqualTo(Outcome.CANCELLED);
        assertThat(tiles).hasSize(2);
        Image whole = Renderer.render(SCENE);
        for (int y = 0; y < whole.height(); y++) {
            for (int x = 0; x < whole.width(); x++) {
                int column = x;
                int row = y;
                boolean isDone = tiles.stream().anyMatch(tile -> column >= tile.x() && column < tile.x() + tile.width()
                        && row >= tile.y() && row < tile.y() + tile.height());
                assertThat(Scenes.pixel(result.image(), x, y)).isEqualTo(isDone ? Scenes.pixel(whole, x, y) : new double[3]);
            }
        }
    }

    /** Even a single ray from the eye, if it needs very many to lights. */
    @Test
    void cancellingIsNoticedAmongTheShadowRaysOfOnePoint() {
        List<Light> lights = Stream.generate(() -> (Light) SphereLight.of(new Vec3(0, 5, 9), 1).withVisible(false).withSamples(4096)).limit(40).toList();
        Scene scene = Scenes.empty().plus(SceneObject.of(new Sphere(2))).withLights(lights);
        Whitted tracer = new Whitted(new World(scene, new Textures(Assets.none()), () -> false), 5, Sampling.grid(1));
        AtomicLong asked = new AtomicLong();
        tracer.begin(() -> asked.incrementAndGet() > 2);
        tracer.trace(Eye.of(scene.camera(), 33, 25), 16, 12, 1, 1);
        assertThat(tracer.isCancelled()).isTrue();
        assertThat(tracer.work().shadows()).isBetween(1L, 3 * 4096L);
    }

    @Test
    void preparingASceneCanBeCancelled() {
        RenderMonitor at = new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return true;
            }
        };
        assertThatThrownBy(() -> RenderScene.of(SCENE, at)).isInstanceOf(CancellationException.class);
        assertThat(Renderer.render(SCENE, RenderOptions.of(SCENE), at).outcome()).isEqualTo(Outcome.CANCELLED);
    }

    @Test
    void aFaultNamesThePixel() {
        CustomPattern broken = (x, y, z, hit) -> {
            throw new UnsupportedOperationException("no");
        };
        Scene scene = Scenes.empty().plus(SceneObject.of(new Sphere(1)).madeOf(Material.DEFAULT.withPattern(broken))).plus(Light.at(0, 5, 5));
        assertThatThrownBy(() -> Renderer.render(RenderScene.of(scene), RenderOptions.of(scene), RenderMonitor.NONE))
                .isInstanceOf(IllegalStateException.class).hasMessageMatching("rendering failed at pixel \\d+, \\d+: .*no");
    }

    @Test
    void interruptingTheCallerCancels() throws InterruptedException {
        RenderScene scene = RenderScene.of(SCENE);
        Outcome[] outcome = new Outcome[1];
        Thread caller = new Thread(() -> outcome[0] = Renderer.render(scene, RenderOptions.of(SCENE.settings().withSize(8000, 8000)),
                RenderMonitor.NONE).outcome());
        caller.start();
        Thread.sleep(100);
        caller.interrupt();
        caller.join(10_000);
        assertThat(outcome[0]).isEqualTo(Outcome.CANCELLED);
    }

    @Test
    void theRaysToldOfWhileItRunsAddUpToTheStatistics() {
        AtomicLong told = new AtomicLong();
        RenderMonitor counting = new RenderMonitor() {
            @Override
            public void traced(long rays) {
                told.addAndGet(rays);
            }
        };
        assertThat(Renderer.render(SCENE, RenderOptions.of(SCENE), counting).stats().rays()).isEqualTo(told.get());
    }

    @Test
    void statisticsCountEveryRay() {
        RenderResult.Stats stats = Renderer.render(RenderScene.of(SCENE), RenderOptions.of(SCENE), RenderMonitor.NONE).stats();
        assertThat(stats.primary()).isEqualTo(101 * 67);
        assertThat(stats.hits()).isBetween(1L, stats.primary() + stats.reflected() + stats.refracted());
        assertThat(stats.rays()).isEqualTo(stats.primary() + stats.reflected() + stats.refracted() + stats.shadow());
    }
}
