package cz.paprsek.fx.model.picture;

import cz.paprsek.asset.Assets;
import cz.paprsek.io.Failures;
import cz.paprsek.io.FileLock;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Tile;
import cz.paprsek.render.film.Film;
import cz.paprsek.resume.Checkpoint;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** What is done of one picture, on disk: nothing in its first seconds, after which quick ones are finished. Any number of threads may use it. */
public final class UnfinishedPicture {
    private final Optional<Path> room;
    private final Preparation preparation;
    private final boolean hasFiles;
    private final Duration quick;
    private final Room free;
    private final Consumer<String> onFault;
    private long soon = System.nanoTime();
    private @Nullable Opening opening;
    private @Nullable Checkpoint tiles;
    /** Says to others, as long as it is held, that somebody is at work on it. */
    private Optional<FileLock> lock;
    private boolean given;

    /** Keeps others from the room, and writes what the picture is one of. */
    @FunctionalInterface
    interface Preparation {
        FileLock of(Path room) throws IOException;
    }

    /** Whether there is room for so many bytes more. */
    @FunctionalInterface
    interface Room {
        boolean isFor(long bytes) throws IOException;
    }

    private record Opening(Scene seen, Assets assets, RenderOptions options) {
        /** Of a picture in passes, two states of each pixel. */
        long bytes() {
            return (long) options.region().width() * options.region().height() * options.channels(seen) * Float.BYTES * (options.isInPasses() ? 2 : 1);
        }
    }

    /**
     * One in a folder of its own.
     *
     * @param room empty if it is not to be kept
     * @param lock of the room, if that is there already
     * @param hasFiles whether files that the scene needs are found again
     * @param quick how long it takes before anything is kept
     */
    UnfinishedPicture(Optional<Path> room, Optional<FileLock> lock, Preparation preparation, boolean hasFiles, Duration quick, Room free, Consumer<String> onFault) {
        this.room = room;
        this.lock = lock;
        this.preparation = preparation;
        this.hasFiles = hasFiles;
        this.quick = quick;
        this.free = free;
        this.onFault = onFault;
        this.given = room.isEmpty();
    }

    /**
     * It begins, or goes on: what is done of it is read.
     *
     * @param seen the scene as it is rendered
     * @param assets the files that it needs, read already
     */
    public synchronized void open(Scene seen, Assets assets, RenderOptions options) {
        if (given || opening != null) {
            return;
        }
        opening = new Opening(seen, assets, options);
        soon = System.nanoTime() + quick.toNanos();
        if (!hasFiles && !assets.digest().equals(Assets.none().digest())) {
            given = true;
        } else if (Files.isDirectory(room.orElseThrow())) {
            attempt(this::openTiles);
        }
    }

    /** Sets the pixels of a tile, if they are known. */
    public synchronized boolean load(Tile tile, Film film) {
        return tiles != null && tiles.load(tile, film);
    }

    /** Keeps a tile that has been traced. */
    public synchronized void save(Tile tile, Film film) {
        Opening picture = opening;
        if (given || picture == null || (tiles == null && System.nanoTime() < soon)) {
            return;
        }
        attempt(() -> {
            if (tiles == null) {
                begin(picture);
            }
            if (tiles != null) {
                tiles.save(tile, film);
            }
        });
    }

    private void begin(Opening picture) throws IOException {
        if (free.isFor(picture.bytes())) {
            lock = Optional.of(preparation.of(room.orElseThrow()));
            openTiles();
        } else {
            given = true;
        }
    }

    /** Tiles of another picture are those of one whose files have changed since: then it begins anew. */
    private void openTiles() throws IOException {
        if (opening != null) {
            tiles = Checkpoint.open(room.orElseThrow().resolve("tiles"), opening.seen(), opening.assets(), opening.options(), true);
        }
    }

    /** The picture is finished, or nobody wants it any more. */
    public synchronized void forget() {
        boolean isOpen = tiles != null;
        given = true;
        attempt(this::close);
        if (isOpen || room.filter(Files::isDirectory).isPresent()) {
            attempt(() -> UnfinishedPictures.delete(room.orElseThrow()));
        }
        attempt(this::unlock);
    }

    /** What is kept of it stays, for whoever goes on with it some day. */
    public synchronized void leave() {
        given = true;
        attempt(this::close);
        attempt(this::unlock);
    }

    private void close() throws IOException {
        if (tiles != null) {
            tiles.close();
            tiles = null;
        }
    }

    private void unlock() throws IOException {
        Optional<FileLock> held = lock;
        lock = Optional.empty();
        if (held.isPresent()) {
            held.get().close();
        }
    }

    @FunctionalInterface
    private interface Deed {
        void run() throws IOException;
    }

    /** The picture matters more than that it can go on some day. */
    private void attempt(Deed deed) {
        try {
            deed.run();
        } catch (IOException | UncheckedIOException | IllegalArgumentException e) {
            given = true;
            onFault.accept(Failures.sentence(e));
        }
    }
}
