package cz.paprsek.image.png;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/** A picture cut into stripes, which are compressed on all processors: those of a picture under way as soon as their rows are complete. For one thread at a time. */
public final class Stripes implements AutoCloseable {
    /** Larger ones compress better, smaller ones keep more processors at work. */
    private static final int STRIPE_BYTES = 1 << 19;

    private final PngHead head;
    private final PngWriter.Rows rows;
    private final int height;
    private final int count;
    private final int threads;
    private final Optional<ExecutorService> pool;
    private final Deque<Future<Stripe>> underWay = new ArrayDeque<>();
    private int begun;
    private int taken;

    /** None is begun yet. */
    public Stripes(PngHead head, PngWriter.Rows rows) {
        this.head = head;
        this.rows = rows;
        height = Math.max(1, STRIPE_BYTES / head.rowBytes(head.width()));
        count = (head.height() + height - 1) / height;
        threads = Math.min(count, Runtime.getRuntime().availableProcessors());
        pool = threads > 1 ? Optional.of(Executors.newFixedThreadPool(threads)) : Optional.empty();
    }

    PngHead head() {
        return head;
    }

    /** Begins with the stripes of which all rows are complete, if there is more than one processor; the rows must not change any more. */
    public void begin(int completeRows) {
        while (pool.isPresent() && begun < count && end(begun) <= completeRows) {
            underWay.add(pool.get().submit(stripe(begun++)));
        }
    }

    boolean hasNext() {
        return taken < count;
    }

    /** The next one, from the top; all rows must be complete. */
    Stripe next() throws IOException {
        // A few ahead: all at once might be more than the memory holds.
        while (pool.isPresent() && begun < count && underWay.size() < 2 * threads) {
            begin(end(begun));
        }
        try {
            int number = taken++;
            return pool.isEmpty() ? stripe(number).call() : underWay.remove().get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("interrupted");
        } catch (ExecutionException e) {
            throw new IllegalStateException(e.getCause());
        }
    }

    private int end(int number) {
        return Math.min(head.height(), (number + 1) * height);
    }

    private Stripe stripe(int number) {
        return new Stripe(head, rows, number * height, end(number));
    }

    @Override
    public void close() {
        pool.ifPresent(ExecutorService::shutdownNow);
    }
}
