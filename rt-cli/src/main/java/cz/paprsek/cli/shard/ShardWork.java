package cz.paprsek.cli.shard;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.shard.Deal.Piece;
import cz.paprsek.cli.shard.PartFile.Numbers;
import cz.paprsek.cli.value.Shard;
import cz.paprsek.io.Folders;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * The work of one share: its parts, as many at once as there are threads, each on one of them and in a file as soon as it is done, so that who is killed loses no
 * more than those under way. What is there already and whole is not made again, whoever made it.
 *
 * @param folder where parts go; it is made
 * @param words as {@link PartHead} has them
 * @param isByPasses whether the picture is divided into passes as well as into tiles
 */
public record ShardWork(Shard shard, Path folder, List<String> words, boolean isByPasses) implements Sharing {
    public ShardWork {
        words = List.copyOf(words);
    }

    @Override
    public Done run(Order order, Stop stop, Listener listener) throws IOException {
        int passes = isByPasses ? passes(order.options()) : 0;
        makeFolder();
        PartsFolder parts = new PartsFolder(folder);
        SortedMap<Integer, List<Piece>> frames = new TreeMap<>();
        new Deal(order.options().region(), order.span(), passes, shard.count()).of(shard).forEach(piece -> frames.computeIfAbsent(piece.frame(), key -> new ArrayList<>()).add(piece));
        int all = frames.values().stream().mapToInt(List::size).sum();
        // Half-written parts are removed before the process ends.
        stop.oweLastWords();
        Crew crew = new Crew(order, stop, parts, all, listener);
        for (Map.Entry<Integer, List<Piece>> frame : frames.entrySet()) {
            List<Piece> lacking = parts.lacking(order.card(), frame.getKey(), frame.getValue());
            crew.found(frame.getValue().size() - lacking.size());
            if (!lacking.isEmpty() && !stop.requested()) {
                crew.work(frame.getKey(), lacking);
            }
        }
        return new Done(all, crew.made.get());
    }

    /** Into how many parts a picture or film is divided, for so many shares. */
    public static long parts(RenderOptions options, Span span, boolean byPasses, int shards) {
        return new Deal(options.region(), span, byPasses ? passes(options) : 0, shards).parts();
    }

    /** @throws WrongUsage if a picture is not made of whole passes of light alone */
    private static int passes(RenderOptions options) {
        Card.indivisible(options).ifPresent(why -> {
            throw new WrongUsage("--by passes shares out whole passes of 64 paths, of light alone; " + why + ": --by tiles goes with it");
        });
        return options.passes();
    }

    private void makeFolder() throws IOException {
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new WrongUsage(folder + " is not a directory, so no parts can be put there");
        }
        Folders.make(folder);
    }

    /** Those who do the work, and what they have in common. */
    private final class Crew implements RenderMonitor {
        private final Order order;
        private final Stop stop;
        private final PartsFolder parts;
        private final int all;
        private final Listener listener;
        private final AtomicInteger made = new AtomicInteger();
        private final AtomicBoolean failed = new AtomicBoolean();
        private int found;

        Crew(Order order, Stop stop, PartsFolder parts, int all, Listener listener) {
            this.order = order;
            this.stop = stop;
            this.parts = parts;
            this.all = all;
            this.listener = listener;
        }

        /** So many more parts were there before. */
        void found(int count) {
            found += count;
        }

        /** Makes parts of a frame. */
        void work(int frame, List<Piece> pieces) throws IOException {
            for (int pass : pieces.stream().map(Piece::pass).distinct().toList()) {
                parts.prepare(frame, pass);
            }
            RenderScene scene = order.footage().scene(frame);
            Told told = Told.of(order.footage().written(frame).origin());
            Queue<Piece> queue = new ConcurrentLinkedQueue<>(pieces);
            int threads = Math.min(order.options().threads(), pieces.size());
            ExecutorService crew = Executors.newFixedThreadPool(threads);
            try {
                List<Future<?>> members = new ArrayList<>();
                for (int i = 0; i < threads; i++) {
                    members.add(crew.submit(() -> {
                        member(scene, told, queue);
                        return null;
                    }));
                }
                for (Future<?> member : members) {
                    member.get();
                }
            } catch (ExecutionException thrown) {
                throw rethrown(thrown);
            } catch (InterruptedException e) {
                failed.set(true);
                Thread.currentThread().interrupt();
                throw new InterruptedIOException("interrupted");
            } finally {
                crew.shutdown();
            }
        }

        private IOException rethrown(ExecutionException thrown) {
            Throwable cause = thrown.getCause();
            if (cause instanceof RuntimeException fault) {
                throw fault;
            }
            if (cause instanceof Error fault) {
                throw fault;
            }
            return cause instanceof IOException failure ? failure : new IOException(cause);
        }

        private void member(RenderScene scene, Told told, Queue<Piece> queue) throws IOException {
            try (Renderer renderer = Renderer.keeping("paprsek-part")) {
                for (Piece piece = queue.poll(); piece != null && !cancelled(); piece = queue.poll()) {
                    make(scene, told, piece, renderer);
                }
            } catch (Throwable thrown) {
                failed.set(true);
                throw thrown;
            }
        }

        private void make(RenderScene scene, Told told, Piece piece, Renderer renderer) throws IOException {
            RenderOptions options = order.options().ofPart(piece.tile()).withThreads(1);
            OnePass pass = new OnePass(options, order.scene(), piece);
            RenderResult result = piece.pass() == 0 ? renderer.next(scene, options, this) : renderer.next(scene, pass.upToIt(), this, pass);
            if (result.outcome() == RenderResult.Outcome.DONE) {
                PartHead head = new PartHead(order.card(), told, piece.frame(), piece.pass(), piece.tile(), order.span(), shard, words);
                PartFile.write(parts.file(piece), head, piece.pass() == 0 ? Numbers.of(order.card(), result.image(), result.layers()) : pass);
                listener.made(found + made.incrementAndGet(), all);
            }
        }

        @Override
        public boolean cancelled() {
            return failed.get() || stop.requested();
        }
    }
}
