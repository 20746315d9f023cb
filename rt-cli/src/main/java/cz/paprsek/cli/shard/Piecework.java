package cz.paprsek.cli.shard;

import cz.paprsek.asset.Assets;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.shard.Deal.Piece;
import cz.paprsek.cli.shard.PartFile.Numbers;
import cz.paprsek.cli.value.Shard;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.Tile;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;

/**
 * A picture or film of which somebody else deals out the work, tile by tile: an engine that knows which machines there are. It takes the order, does nothing with it, and makes the tiles that it is asked for
 * later, by any number of threads.
 *
 * @see ShardWork
 */
public final class Piecework implements Sharing {
    /** How many pixels the sides of tiles have at most: twice those of the largest picture. */
    public static final int LARGEST_SIDE = 65536;
    /** How many frames stay prepared at least: more than one, as the threads of a machine do not all go to the next at once. */
    private static final int FRAMES_KEPT = 3;
    private static final Assets.Decoder<byte[]> AS_THEY_ARE = (name, input, size) -> input.readAllBytes();
    private static final Shard ALL = new Shard(1, 1);

    private final List<String> words;
    /** By frame; what was not wanted for the longest time comes first. */
    private final Map<Integer, Ready> prepared = new LinkedHashMap<>(16, 0.75f, true);
    private int working;
    private int mostWorking;
    private Optional<Order> taken = Optional.empty();

    /** What the tiles of a frame have in common. */
    private record Ready(RenderScene scene, Told told) {}

    /** @param words as {@link PartHead} has them */
    public Piecework(List<String> words) {
        this.words = List.copyOf(words);
    }

    @Override
    public Shard shard() {
        return ALL;
    }

    @Override
    public Done run(Order order, Stop stop, Listener listener) {
        taken = Optional.of(order);
        return new Done(0, 0);
    }

    /** Whether there is an order: none if the words were wrong, or the scene could not be read. */
    public boolean isOrdered() {
        return taken.isPresent();
    }

    private Order order() {
        return taken.orElseThrow();
    }

    /** Which picture it is, in letters: two are the same if these are. */
    public String card() {
        return order().card().text();
    }

    /** The file of the scene, as it was named. */
    public Path scene() {
        return order().file();
    }

    /**
     * What the scene needs beside its file: pictures, meshes, fonts and other scenes, by their names.
     *
     * @throws IOException if one cannot be read
     */
    public Map<String, byte[]> files() throws IOException {
        Map<String, byte[]> files = new TreeMap<>();
        order().scene().recipe().included().forEach((name, text) -> files.put(name, text.getBytes(StandardCharsets.UTF_8)));
        for (String name : order().assets().digests().keySet()) {
            // Meshes may be larger than other files.
            files.put(name, order().assets().decoded(name, AS_THEY_ARE));
        }
        return files;
    }

    /** The frames of the film; of a picture that is none, only 0. */
    public Span span() {
        return order().span();
    }

    /**
     * The tiles of a frame, neighbours after each other.
     *
     * @param side as {@link #requireSide}
     */
    public List<Tile> tiles(int side) {
        return Grid.tiles(order().card().region(), requireSide(side));
    }

    /**
     * Returns the side of tiles.
     *
     * @param side how many pixels it has, but at the edges of the picture: a multiple of 32, at most {@value #LARGEST_SIDE}
     * @throws IllegalArgumentException if it is none
     */
    public static int requireSide(int side) {
        if (side < Grid.SIDE || side > LARGEST_SIDE || side % Grid.SIDE != 0) {
            throw new IllegalArgumentException("the side of a tile is a multiple of " + Grid.SIDE + " pixels, from " + Grid.SIDE + " to " + LARGEST_SIDE + ", not " + side);
        }
        return side;
    }

    /** The largest side of tiles with which there are as many of them as wished for, if there can be. */
    public int side(long tiles) {
        return Deal.side(order().card().region(), span().count(), tiles);
    }

    /** Where the part of a tile goes in a folder of parts. */
    public static Path part(Path folder, int frame, Tile tile) {
        return new PartsFolder(folder).file(new Piece(frame, 0, tile));
    }

    /**
     * Renders a tile on one thread, and puts its part {@linkplain #part where it goes}.
     *
     * @param cancelled is asked again and again whether nobody wants it any more
     * @throws InterruptedIOException if so
     * @throws IOException if it cannot be written
     * @throws IllegalStateException as {@link Renderer}
     */
    public void make(Path folder, int frame, Tile tile, BooleanSupplier cancelled) throws IOException {
        RenderMonitor monitor = new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return cancelled.getAsBoolean();
            }
        };
        Ready ready = begun(frame);
        RenderResult result;
        try {
            result = Renderer.render(ready.scene(), order().options().ofPart(tile).withThreads(1), monitor);
        } finally {
            ended();
        }
        if (result.outcome() != RenderResult.Outcome.DONE) {
            throw new InterruptedIOException("interrupted");
        }
        new PartsFolder(folder).prepare(frame, 0);
        PartHead head = new PartHead(order().card(), ready.told(), frame, 0, tile, span(), ALL, words);
        PartFile.write(part(folder, frame, tile), head, Numbers.of(head.card(), result.image(), result.layers()));
    }

    /** A thread begins a tile: what is prepared of its frame, by the first that needs it. */
    private synchronized Ready begun(int frame) {
        Ready known = prepared.get(frame);
        if (known == null) {
            known = new Ready(order().footage().scene(frame), Told.of(order().footage().written(frame).origin()));
            prepared.put(frame, known);
        }
        working++;
        mostWorking = Math.max(mostWorking, working);
        // Each thread may be at a frame of its own, and there are no more of them than were ever at work at once.
        int kept = Math.max(FRAMES_KEPT, mostWorking + 1);
        prepared.keySet().stream().findFirst().filter(oldest -> prepared.size() > kept).ifPresent(prepared::remove);
        return known;
    }

    private synchronized void ended() {
        working--;
    }
}
