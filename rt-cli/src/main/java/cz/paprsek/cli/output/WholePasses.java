package cz.paprsek.cli.output;

import cz.paprsek.image.Image;
import java.util.Optional;

/** Puts a picture under way into its file after each whole pass, at most once a second, and says when its time is over. */
final class WholePasses implements Progress.Passed {
    private static final double SECONDS_BETWEEN = 1;

    private final Optional<Double> seconds;
    private final Writer writer;
    private final long begin = System.nanoTime();
    private double before;
    private double written = Double.NEGATIVE_INFINITY;
    private int passesWritten;
    private int passes;

    /** Writes the picture as it is after so many passes; false if it could not be written. */
    interface Writer {
        boolean write(Image image, int passes);
    }

    /** @param seconds that the passes may take together */
    WholePasses(Optional<Double> seconds, Writer writer) {
        this.seconds = seconds;
        this.writer = writer;
    }

    @Override
    public boolean passed(Image image, int count) {
        double now = (System.nanoTime() - begin) / 1e9;
        double another = now + now - before;
        before = now;
        if (seconds.isPresent() && another > seconds.get()) {
            passes = count;
            return false;
        }
        if (now >= written + SECONDS_BETWEEN) {
            passesWritten = writer.write(image, count) ? count : passesWritten;
            written = now;
        }
        return true;
    }

    /** How many passes the picture in the file has; 0 if there is none. */
    int passesWritten() {
        return passesWritten;
    }

    /** After how many passes time was over; empty if it was not. */
    Optional<Integer> passesInTime() {
        return passes == 0 ? Optional.empty() : Optional.of(passes);
    }
}
