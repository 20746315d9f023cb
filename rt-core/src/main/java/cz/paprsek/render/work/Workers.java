package cz.paprsek.render.work;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Threads that render, kept from one picture to the next with their {@link Desk}s. They start when they are needed first. For one caller at a time. */
public final class Workers implements AutoCloseable {
    private final String name;
    private final List<Worker> all = new ArrayList<>();

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

    /** Has some work done by so many workers, and waits until all have ended; false if the wait was interrupted, which cancels the work. */
    public boolean run(int count, Work work) {
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

    /** Ends the threads, and waits until they have. */
    @Override
    public void close() {
        all.forEach(Worker::end);
        boolean interrupted = false;
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
