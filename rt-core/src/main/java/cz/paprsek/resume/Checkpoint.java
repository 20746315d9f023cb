package cz.paprsek.resume;

import cz.paprsek.asset.Assets;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Tile;
import cz.paprsek.render.TileStore;
import cz.paprsek.render.film.Film;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import java.util.Objects;
import java.util.zip.CRC32;

/**
 * The finished tiles of a picture under way, in a file beside it. The file begins with a digest of scene and settings; each tile is appended
 * as a whole with a checksum, so that a process may be killed at any moment: a torn last tile is dropped when the file is read. Of a picture in passes the last two
 * states of each tile are there, the next one in place of the older.
 */
public final class Checkpoint implements AutoCloseable {
    private static final byte[] MAGIC = "paprsek tiles 5\n".getBytes(StandardCharsets.US_ASCII);
    /** Without the number of the version. */
    private static final byte[] FORMAT = Arrays.copyOf(MAGIC, MAGIC.length - 2);
    private static final int RECORD_HEAD = 6 * Integer.BYTES;

    private final Path file;
    private final FileChannel channel;
    /** How many numbers each pixel has. */
    private final int channels;
    private final Map<Tile, FloatBuffer> tiles = new HashMap<>();
    private final Map<Tile, Places> places = new HashMap<>();

    /**
     * Where the states of a tile are in the file.
     *
     * @param older −1 if there is but one
     */
    private record Places(long newer, int pass, long older) {}

    /** The tiles in a file are not of use to this picture, or another process has them. The message says why, in one line that begins with the file. */
    public static final class Refused extends IOException {
        private static final long serialVersionUID = 1;

        Refused(String message) {
            super(message);
        }
    }

    private Checkpoint(Path file, FileChannel channel, int channels) {
        this.file = file;
        this.channel = channel;
        this.channels = channels;
    }

    /** Where the tiles of a picture are kept. */
    public static Path fileFor(Path picture) {
        return AtomicFile.beside(picture, "", ".resume");
    }

    /**
     * Opens the file of a picture's tiles, or begins one.
     *
     * @param anew whether it is begun anew if it holds tiles of another picture
     * @throws Refused if it holds tiles of another picture, or another process is at work on it
     */
    public static Checkpoint open(Path picture, Scene scene, Assets assets, RenderOptions options, boolean anew) throws IOException {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(assets, "assets");
        Objects.requireNonNull(options, "options");
        Path file = fileFor(picture);
        FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
        boolean opened = false;
        try {
            if (isTaken(channel)) {
                throw new Refused(file + ": another render is at work on this picture");
            }
            Checkpoint checkpoint = new Checkpoint(file, channel, options.channels(scene));
            byte[] digest = digest(scene, assets, options);
            try {
                checkpoint.read(digest, options.region());
                if (options.isInPasses()) {
                    checkpoint.checkPaths(options.keptFrom(scene), options.settings().mostRays());
                }
            } catch (Refused another) {
                if (!anew) {
                    throw another;
                }
                checkpoint.begin(digest);
            }
            opened = true;
            return checkpoint;
        } finally {
            if (!opened) {
                channel.close();
            }
        }
    }

    /**
     * Compares how many paths pixels have with how many are asked for.
     *
     * @param number which of the numbers of a pixel says so
     * @throws Refused if there are more, which could not be taken away
     */
    private void checkPaths(int number, int most) throws Refused {
        for (FloatBuffer tile : tiles.values()) {
            for (int i = number; i < tile.limit(); i += channels) {
                if (tile.get(i) > most) {
                    throw new Refused(file + ": has pixels of " + (int) tile.get(i) + " paths already, more than --samples " + most
                            + "; ask for as many, or delete it to begin anew");
                }
            }
        }
    }

    /** How many pixels are known. */
    public long pixels() {
        return tiles.keySet().stream().mapToLong(tile -> (long) tile.width() * tile.height()).sum();
    }

    /** Sets the pixels of a tile if they were there when the file was opened. */
    public boolean load(Tile tile, Film film) {
        FloatBuffer known = tiles.get(tile);
        if (known == null) {
            return false;
        }
        float[] values = new float[channels];
        for (int i = 0; i < tile.width() * tile.height(); i++) {
            known.get(channels * i, values);
            film.setChannels(tile.x() + i % tile.width(), tile.y() + i / tile.width(), values);
        }
        return true;
    }

    /** Adds a finished tile. */
    public synchronized void save(Tile tile, Film film) throws IOException {
        ByteBuffer record = ByteBuffer.allocate(RECORD_HEAD + (int) pixelBytes(tile));
        record.putInt(tile.x()).putInt(tile.y()).putInt(tile.width()).putInt(tile.height()).putInt(passes(tile) + 1).putInt(0);
        for (int i = 0; i < tile.width() * tile.height(); i++) {
            int x = tile.x() + i % tile.width();
            int y = tile.y() + i / tile.width();
            for (int channel = 0; channel < channels; channel++) {
                record.putFloat(film.channel(channel, x, y));
            }
        }
        record.putInt(RECORD_HEAD - Integer.BYTES, checksum(record)).flip();
        Places known = places.get(tile);
        long at = known == null || known.older < 0 ? channel.size() : known.older;
        places.put(tile, new Places(at, passes(tile) + 1, known == null ? -1 : known.newer));
        while (record.hasRemaining()) {
            at += channel.write(record, at);
        }
    }

    /** How many states of a tile have been kept so far. */
    private int passes(Tile tile) {
        Places known = places.get(tile);
        return known == null ? 0 : known.pass;
    }

    /** The picture is written: its tiles are needed no more. */
    public void discard() throws IOException {
        Files.deleteIfExists(file);
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }

    private void begin(byte[] digest) throws IOException {
        tiles.clear();
        places.clear();
        channel.truncate(0);
        channel.write(ByteBuffer.allocate(MAGIC.length + digest.length).put(MAGIC).put(digest).flip());
    }

    private void read(byte[] digest, Tile region) throws IOException {
        if (channel.size() < MAGIC.length + digest.length) {
            // New, or its beginning was torn.
            begin(digest);
            return;
        }
        ByteBuffer expected = ByteBuffer.allocate(MAGIC.length + digest.length).put(MAGIC).put(digest).flip();
        ByteBuffer found = read(expected.limit());
        if (!found.equals(expected)) {
            if (found.slice(0, FORMAT.length).equals(ByteBuffer.wrap(FORMAT)) && !found.slice(0, MAGIC.length).equals(ByteBuffer.wrap(MAGIC))) {
                throw new Refused(file + ": holds tiles written by another version, with which this one cannot go on; delete it to begin anew, or give this picture another name");
            }
            throw new Refused(file + ": holds tiles of another picture, the scene or the settings are not the same;"
                    + " delete it to begin anew, or give this picture another name");
        }
        long whole = channel.position();
        while (readTile(region)) {
            whole = channel.position();
        }
        channel.truncate(whole);
    }

    private boolean readTile(Tile region) throws IOException {
        ByteBuffer head = read(RECORD_HEAD);
        if (head.remaining() < RECORD_HEAD) {
            return false;
        }
        int x = head.getInt();
        int y = head.getInt();
        int width = head.getInt();
        int height = head.getInt();
        int pass = head.getInt();
        if (x < region.x() || y < region.y() || width < 1 || height < 1
                || width > region.width() - (x - region.x()) || height > region.height() - (y - region.y())) {
            return false;
        }
        Tile tile = new Tile(x, y, width, height);
        long at = channel.position() - RECORD_HEAD;
        // What a damaged head asks for may be more than there is memory for.
        if (width > TileStore.LARGEST_SIDE || height > TileStore.LARGEST_SIDE || pixelBytes(tile) > channel.size() - channel.position()) {
            return false;
        }
        ByteBuffer pixels = read((int) pixelBytes(tile));
        ByteBuffer record = ByteBuffer.allocate(RECORD_HEAD + pixels.limit()).put(head.rewind()).put(pixels.duplicate());
        Places known = places.get(tile);
        if (checksum(record) != head.getInt(RECORD_HEAD - Integer.BYTES)) {
            // Torn while it took the place of an older one, or the last of all.
            places.put(tile, known == null ? new Places(at, 0, -1) : new Places(known.newer, known.pass, at));
        } else if (known == null || known.pass < pass) {
            places.put(tile, new Places(at, pass, known == null ? -1 : known.newer));
            tiles.put(tile, pixels.asFloatBuffer());
        } else {
            places.put(tile, new Places(known.newer, known.pass, at));
        }
        return true;
    }

    /** The next bytes of the file; fewer where it ends. */
    private ByteBuffer read(int size) throws IOException {
        ByteBuffer bytes = ByteBuffer.allocate((int) Math.min(size, channel.size() - channel.position()));
        while (bytes.hasRemaining() && channel.read(bytes) >= 0) {
            // A read may bring less than was asked for.
        }
        return bytes.flip();
    }

    private long pixelBytes(Tile tile) {
        return (long) Float.BYTES * channels * tile.width() * tile.height();
    }

    /** Of everything but the place of the checksum itself. */
    private static int checksum(ByteBuffer record) {
        CRC32 crc = new CRC32();
        crc.update(record.slice(0, RECORD_HEAD - Integer.BYTES));
        crc.update(record.slice(RECORD_HEAD, record.capacity() - RECORD_HEAD));
        return (int) crc.getValue();
    }

    private static boolean isTaken(FileChannel channel) throws IOException {
        try {
            return channel.tryLock() == null;
        } catch (OverlappingFileLockException e) {
            return true;
        }
    }

    /** Two pictures have the same tiles if these are the same. */
    private static byte[] digest(Scene scene, Assets assets, RenderOptions options) {
        return HexFormat.of().parseHex(SceneDigest.of(scene, assets, comparable(options).toString()));
    }

    /** Without what changes no tile; how many paths there are, and how near they bring a pixel, says only when it ends. */
    private static RenderOptions comparable(RenderOptions options) {
        RenderOptions alone = options.withThreads(1);
        RenderSettings settings = options.settings();
        int few = options.denoised() ? RenderSettings.USUAL_PATHS : 1;
        return options.isInPasses() ? alone.withSettings(settings.withSamples(few, settings.isAdaptive() ? few : 0).withError(1).withConfidence(RenderSettings.DEFAULT.confidence())) : alone;
    }
}
