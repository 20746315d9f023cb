package cz.paprsek.fx.model.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.model.picture.UnfinishedPictures.Resumed;
import cz.paprsek.image.Image;
import cz.paprsek.io.FileLock;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderResult.Outcome;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.Tile;
import cz.paprsek.render.TileStore;
import cz.paprsek.render.film.Film;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class UnfinishedPicturesTest {
    private static final Path SHIPPED = Path.of("../scenes/lens.xml");
    private static final Map<String, String> ANSWERS = Map.of("size", "160x110", "camera", "two = words\n& more");
    private static final String GONE = "00000000-0000-4000-8000-00000000000";

    @TempDir
    private Path folder = Path.of("");

    private final List<String> faults = new ArrayList<>();

    /** Renders until so many tiles are done, or to the end, and counts those that were known. */
    private static RenderResult render(UnfinishedPicture kept, Scene scene, Assets assets, RenderOptions options, int most, AtomicInteger known) throws Exception {
        RenderScene ready = RenderScene.of(scene, assets, RenderMonitor.NONE);
        kept.open(scene, assets, options);
        AtomicInteger done = new AtomicInteger();
        RenderMonitor monitor = new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return done.get() >= most;
            }

            @Override
            public void finished(Tile tile, Image image, int tilesDone, int tilesTotal) {
                done.incrementAndGet();
            }
        };
        return Renderer.render(ready, options, monitor, new TileStore() {
            @Override
            public boolean load(Tile tile, int pass, Film into) {
                boolean there = kept.load(tile, into);
                known.addAndGet(there ? 1 : 0);
                return there;
            }

            @Override
            public void save(Tile tile, int pass, Film from) {
                kept.save(tile, from);
            }
        });
    }

    private UnfinishedPictures of(Duration quick) {
        return new UnfinishedPictures(Optional.of(folder), quick, () -> Optional.of(SHIPPED.toAbsolutePath()), faults::add);
    }

    /** What the process has written, when it is killed in the midst of a tile. */
    private Path kill(Path room) throws IOException {
        Path left = Files.createDirectory(folder.resolve(GONE + "7"));
        for (String name : List.of("scene.xml", "picture.properties", "tiles.resume")) {
            Files.copy(room.resolve(name), left.resolve(name));
        }
        try (FileChannel tiles = FileChannel.open(left.resolve("tiles.resume"), StandardOpenOption.WRITE)) {
            tiles.truncate(tiles.size() - 5);
        }
        return left;
    }

    private List<Path> rooms() throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(Files::isDirectory).toList();
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 130})
    void aKilledPictureGoesOnToTheSameBytes(int samples) throws Exception {
        Scene scene = SceneFiles.read(SHIPPED);
        RenderOptions once = RenderOptions.of(scene.settings().withSize(160, 110)).withThreads(2);
        RenderOptions options = samples == 1 ? once : RenderOptions.of(once.settings().withSize(64, 40).withIntegrator(cz.paprsek.scene.RenderSettings.Integrator.PATH).withSamples(samples));
        Assets assets = Assets.beside(SHIPPED);
        Image whole = Renderer.render(RenderScene.of(scene, assets, RenderMonitor.NONE), options, RenderMonitor.NONE).image();
        UnfinishedPictures first = of(Duration.ZERO);
        UnfinishedPicture begun = first.begin(scene, ANSWERS);
        assertThat(render(begun, scene, assets, options, 6, new AtomicInteger()).outcome()).isEqualTo(Outcome.CANCELLED);
        assertThat(of(Duration.ZERO).left()).as("under way").isEmpty();
        Path room = rooms().get(0);
        Path left = kill(room);
        begun.forget();
        assertThat(room).doesNotExist();

        UnfinishedPictures next = of(Duration.ofHours(1));
        assertThat(next.left()).containsExactly(left);
        next.take(left).kept().leave();
        assertThat(next.left()).as("nobody goes on with it after all").containsExactly(left);
        Resumed resumed = next.take(left);
        assertThat(resumed.answers()).isEqualTo(ANSWERS);
        assertThat(next.left()).as("taken").isEmpty();
        assertThatThrownBy(() -> first.take(left)).hasMessage(left + ": another render is at work on this picture");
        assertThatThrownBy(() -> first.discard(left)).hasMessage(left + ": another render is at work on this picture");
        AtomicInteger known = new AtomicInteger();
        RenderResult result = render(resumed.kept(), resumed.scene(), resumed.assets(), options, Integer.MAX_VALUE, known);
        assertThat(known.get()).isPositive();
        assertThat(bytes(result.image())).isEqualTo(bytes(whole));
        resumed.kept().forget();
        assertThat(folder).isEmptyDirectory();
        assertThat(faults).isEmpty();
    }

    private static List<Float> bytes(Image image) {
        List<Float> all = new ArrayList<>();
        for (int i = 0; i < image.width() * image.height(); i++) {
            int x = i % image.width();
            int y = i / image.width();
            all.addAll(List.of(image.red(x, y), image.green(x, y), image.blue(x, y)));
        }
        return all;
    }

    @Test
    void quickPicturesAndLargeOnesLeaveNothing() throws Exception {
        Scene scene = SceneFiles.read(SHIPPED);
        RenderOptions options = RenderOptions.of(scene.settings().withSize(64, 40));
        render(of(Duration.ofHours(1)).begin(scene, ANSWERS), scene, Assets.none(), options, Integer.MAX_VALUE, new AtomicInteger());
        AtomicInteger asked = new AtomicInteger();
        UnfinishedPicture large = new UnfinishedPicture(Optional.of(folder.resolve(GONE + "9")), Optional.empty(), room -> FileLock.of(room, 0), true, Duration.ZERO, bytes -> {
            asked.set((int) bytes);
            return false;
        }, faults::add);
        render(large, scene, Assets.none(), options, Integer.MAX_VALUE, new AtomicInteger());
        assertThat(asked.get()).isEqualTo(64 * 40 * 3 * 4);
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void whatHadNotBegunIsDeletedAndWhatIsNoneIsLeftAlone() throws Exception {
        Files.writeString(Files.createDirectory(folder.resolve(GONE + "1")).resolve("scene.xml"), "<sce");
        Files.createDirectory(folder.resolve("mine"));
        assertThat(of(Duration.ZERO).left()).isEmpty();
        assertThat(folder.toFile().list()).containsExactly("mine");
    }

    /** A process whose number, in a container, is that of the one before: what it begins is a picture of its own. */
    @Test
    void eachPictureHasARoomOfItsOwn() throws Exception {
        Scene scene = SceneFiles.read(SHIPPED);
        RenderOptions options = RenderOptions.of(scene.settings().withSize(64, 40));
        for (int i = 1; i <= 2; i++) {
            render(of(Duration.ZERO).begin(scene, ANSWERS), scene, Assets.none(), options, 1, new AtomicInteger());
            assertThat(rooms()).hasSize(i).allSatisfy(room -> assertThat(room.resolve("picture.properties")).exists());
        }
        assertThat(of(Duration.ZERO).left()).isEmpty();
    }

    @Test
    void whatCannotBeReadStaysWhereItIs() throws Exception {
        Path damaged = Files.createDirectory(folder.resolve(GONE + "1"));
        Files.writeString(damaged.resolve("picture.properties"), "source=\\u00zz");
        UnfinishedPictures pictures = of(Duration.ZERO);
        assertThatThrownBy(() -> pictures.take(damaged)).hasMessage(damaged.resolve("picture.properties") + ": is damaged");
        assertThat(pictures.left()).containsExactly(damaged);
        pictures.discard(damaged);
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void aDiskThatTakesNothingIsToldOnceAndThePictureIsMade() throws Exception {
        Path file = Files.writeString(folder.resolve("file"), "in the way");
        Scene scene = SceneFiles.read(SHIPPED);
        RenderOptions options = RenderOptions.of(scene.settings().withSize(64, 40));
        UnfinishedPictures nowhere = new UnfinishedPictures(Optional.of(file.resolve("pictures")), Duration.ZERO, Optional::empty, faults::add);
        assertThat(render(nowhere.begin(scene, ANSWERS), scene, Assets.none(), options, Integer.MAX_VALUE, new AtomicInteger()).outcome()).isEqualTo(Outcome.DONE);
        assertThat(faults).hasSize(1);
    }

    /** As a walk through a folder fails that another window deletes meanwhile. */
    @Test
    void noFaultOfKeepingIsOneOfThePicture() throws Exception {
        Scene scene = SceneFiles.read(SHIPPED);
        RenderOptions options = RenderOptions.of(scene.settings().withSize(64, 40));
        UnfinishedPicture kept = new UnfinishedPicture(Optional.of(folder.resolve(GONE + "9")), Optional.empty(), room -> FileLock.of(room, 0), true, Duration.ZERO, bytes -> {
            throw new UncheckedIOException(new NoSuchFileException("gone"));
        }, faults::add);
        assertThat(render(kept, scene, Assets.none(), options, Integer.MAX_VALUE, new AtomicInteger()).outcome()).isEqualTo(Outcome.DONE);
        assertThat(faults).containsExactly("gone: no such file");
    }
}
