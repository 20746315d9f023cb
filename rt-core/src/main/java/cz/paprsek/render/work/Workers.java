package cz.paprsek.render.work;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.jspecify.annotations.Nullable;

/** Threads that render, kept from one picture to the next with their {@link Desk}s. They start when they are needed first. For one caller at a time; others are refused. */
public final class Workers implements AutoCloseable {
    private final String name;
    private final List<Worker> all = new CopyOnWriteArrayList<>();
    private boolean busy;
    private boolean closed;

    /** @param name of the threads, which are numbered */
    public Workers(String name) {
        this.name = name;
    }

    /** What workers do together. */
    public interface Work {
        /** Does a part of it, until nothing is left; called once by each worker. */
        void at(Desk desk);

        /** The caller no longer wishes it done. */
        void cancel();

        /** A worker could not be started. */
        void fail(Throwable thrown);
    }

    /**
     * Has some work done by so many workers, and waits until all have ended; false if the wait was interrupted, which cancels the work.
     *
     * @throws IllegalStateException if they are at work already, or closed
     */
    public boolean run(int count, Work work) {
        begin();
        try {
            return runAlone(count, work);
        } finally {
            end();
        }
    }

    private synchronized void begin() {
        if (closed) {
            throw new IllegalStateException("this renderer is closed, and makes no more pictures");
        }
        if (busy) {
            throw new IllegalStateException("this renderer makes one picture at a time: each thread needs one of its own, and so does a monitor that renders");
        }
        busy = true;
    }

    private synchronized void end() {
        busy = false;
        notifyAll();
    }

    private boolean runAlone(int count, Work work) {
        List<Worker> busy = new ArrayList<>(count);
        try {
            for (int i = 0; i < count; i++) {
                Worker worker = i < all.size() ? all.get(i) : started(i);
                worker.take(work);
                busy.add(worker);
            }
        } catch (OutOfMemoryError noThread) {
            work.fail(noThread);
        }
        boolean undisturbed = true;
        for (Worker worker : busy) {
            undisturbed &= worker.isAwaited();
        }
        return undisturbed;
    }

    private Worker started(int number) {
        Worker worker = new Worker(name + "-" + number);
        worker.setDaemon(true);
        worker.start();
        all.add(worker);
        return worker;
    }

    /**
     * Ends the threads when the picture they make is done, and waits until they have ended.
     *
     * @throws IllegalStateException if it is one of them that asks, and would wait for itself
     */
    @Override
    public void close() {
        if (Thread.currentThread() instanceof Worker own && all.contains(own)) {
            throw new IllegalStateException("a renderer cannot be closed by what it calls while it makes a picture");
        }
        boolean interrupted = awaitEnd();
        all.forEach(Worker::end);
        for (Worker worker : all) {
            while (worker.isAlive()) {
                try {
                    worker.join();
                } catch (InterruptedException later) {
                    interrupted = true;
                }
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    /** Takes no more work, and waits until what there is has been done; whether the wait was interrupted. */
    private synchronized boolean awaitEnd() {
        closed = true;
        boolean interrupted = false;
        while (busy) {
            try {
                wait();
            } catch (InterruptedException later) {
                interrupted = true;
            }
        }
        return interrupted;
    }

    private static final class Worker extends Thread {
        private final Desk desk = new Desk();
        private @Nullable Work work;
        private boolean ended;

        Worker(String name) {
            super(name);
        }

        synchronized void take(Work given) {
            work = given;
            notifyAll();
        }

        synchronized void end() {
            ended = true;
            notifyAll();
        }

        @Override
        public void run() {
            for (Work next = next(); next != null; next = next()) {
                try {
                    next.at(desk);
                } finally {
                    done();
                }
            }
        }

        private synchronized @Nullable Work next() {
            while (work == null && !ended) {
                try {
                    wait();
                } catch (InterruptedException byAMonitor) {
                    // It is not theirs to end this thread, which others may still wait for.
                }
            }
            return work;
        }

        private synchronized void done() {
            work = null;
            notifyAll();
        }

        /** Waits until the work is done; false if that was interrupted. */
        synchronized boolean isAwaited() {
            boolean undisturbed = true;
            for (Work current = work; current != null; current = work) {
                try {
                    wait();
                } catch (InterruptedException noLongerWished) {
                    undisturbed = false;
                    current.cancel();
                }
            }
            return undisturbed;
        }
    }
}
