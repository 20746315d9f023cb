package cz.paprsek.cli.shard;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.shard.Deal.Piece;
import cz.paprsek.cli.value.Shard;
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
import java.util.Objects;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;

/**
 * The work of one share: its parts, as many at once as there are threads, each on one of them and in a file as soon as it is done, so that who is killed loses no
 * more than those under way. What is there already and whole is not made again, whoever made it.
 *
 * @param folder where parts go; it is made
 * @param words as {@link PartHead} has them
 */
public record ShardWork(Shard shard, Path folder, List<String> words) {
    public ShardWork {
        words = List.copyOf(words);
    }

    /**
     * How much there was to do.
     *
     * @param parts of the share
     * @param made those of them that were not there
     */
    public record Done(int parts, int made) {}

    /** Is told how far it is, by any thread. */
    @FunctionalInterface
    public interface Listener {
        /**
         * A part is there.
         *
         * @param done how many are, those that were there before included
         */
        void made(int done, int parts);
    }

    /**
     * Makes what is not there; returns early if a stop is asked for.
     *
     * @param scene prepares it, if there is something to do
     * @throws IOException if a part cannot be written
     * @throws WrongUsage if there are parts of another picture in the folder
     * @throws IllegalStateException as {@link Renderer}
     */
    public Done run(Card card, RenderOptions options, Supplier<RenderScene> scene, Stop stop, Listener listener) throws IOException {
        makeFolder();
        PartsFolder parts = new PartsFolder(folder);
        List<Piece> own = new Deal(options.region(), shard.count()).of(shard);
        List<Piece> lacking = parts.lacking(card, own);
        if (lacking.isEmpty()) {
            return new Done(own.size(), 0);
        }
        // Half-written parts are removed before the process ends.
        stop.oweLastWords();
        Crew crew = new Crew(card, options, scene.get(), stop, parts, new ConcurrentLinkedQueue<>(lacking), own.size() - lacking.size(), own.size(), listener);
        crew.work(Math.min(options.threads(), lacking.size()));
        return new Done(own.size(), lacking.size());
    }

    /** Into how many parts a picture is divided, for so many shares. */
    public static long parts(RenderOptions options, int shards) {
        return new Deal(options.region(), shards).parts();
    }

    private void makeFolder() throws IOException {
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new WrongUsage(folder + " is not a directory, so no parts can be put there");
        }
        Files.createDirectories(folder);
    }

    /** Those who do the work, and what they have in common. */
    private final class Crew implements RenderMonitor {
        private final Card card;
        private final RenderOptions options;
        private final RenderScene scene;
        private final Stop stop;
        private final PartsFolder parts;
        private final Queue<Piece> queue;
        private final AtomicInteger done;
        private final int all;
        private final Listener listener;
        private final AtomicBoolean failed = new AtomicBoolean();

        Crew(Card card, RenderOptions options, RenderScene scene, Stop stop, PartsFolder parts, Queue<Piece> queue, int before, int all, Listener listener) {
            this.card = card;
            this.options = options.withThreads(1);
            this.scene = scene;
            this.stop = stop;
            this.parts = parts;
            this.queue = queue;
            done = new AtomicInteger(before);
            this.all = all;
            this.listener = listener;
        }

        void work(int threads) throws IOException {
            ExecutorService crew = Executors.newFixedThreadPool(threads);
            try {
                List<Future<?>> members = new ArrayList<>();
                for (int i = 0; i < threads; i++) {
                    members.add(crew.submit(() -> {
                        member();
                        return null;
                    }));
                }
                for (Future<?> member : members) {
                    member.get();
                }
            } catch (ExecutionException thrown) {
                failed.set(true);
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

        private void member() throws IOException {
            try (Renderer renderer = Renderer.keeping("paprsek-part")) {
                for (Piece piece = queue.poll(); piece != null && !cancelled(); piece = queue.poll()) {
                    make(piece, renderer);
                }
            } catch (Throwable thrown) {
                failed.set(true);
                throw thrown;
            }
        }

        private void make(Piece piece, Renderer renderer) throws IOException {
            RenderResult result = renderer.next(scene, options.withRegion(piece.tile()), this);
            if (result.outcome() == RenderResult.Outcome.DONE) {
                Path file = parts.file(piece);
                Files.createDirectories(Objects.requireNonNull(file.getParent()));
                PartFile.write(file, new PartHead(card, piece.frame(), piece.tile(), shard, words), result.image(), result.layers());
                listener.made(done.incrementAndGet(), all);
            }
        }

        @Override
        public boolean cancelled() {
            return failed.get() || stop.requested();
        }
    }
}
