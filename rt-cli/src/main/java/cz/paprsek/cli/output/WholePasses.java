package cz.paprsek.cli.output;

import cz.paprsek.image.Image;
import cz.paprsek.image.Layers;
import java.io.IOException;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Puts a picture under way into its file after each whole pass, at most once a second, and says when its time is over. */
final class WholePasses implements Progress.Passed {
    private static final double SECONDS_BETWEEN = 1;

    private final Optional<Double> seconds;
    private final Writer writer;
    private final Consumer<IOException> unwritten;
    private boolean isHindered;
    private final long begin = System.nanoTime();
    private double before;
    private double written = Double.NEGATIVE_INFINITY;
    private int passesWritten;
    private int passes;

    /** Writes the picture as it is after so many passes; false if it goes nowhere yet. */
    interface Writer {
        boolean write(Image image, Layers layers, int passes) throws IOException;
    }

    /**
     * What becomes of the passes of a picture.
     *
     * @param seconds that the passes may take together
     * @param unwritten is told why a picture could not be written, of several times in a row the first; rendering goes on, as what hinders may pass
     */
    WholePasses(Optional<Double> seconds, Writer writer, Consumer<IOException> unwritten) {
        this.seconds = seconds;
        this.writer = writer;
        this.unwritten = unwritten;
    }

    @Override
    public boolean passed(Image image, Supplier<Layers> layers, int count) {
        double now = (System.nanoTime() - begin) / 1e9;
        double another = now + now - before;
        before = now;
        if (seconds.isPresent() && another > seconds.get()) {
            passes = count;
            return false;
        }
        if (now >= written + SECONDS_BETWEEN) {
            write(image, layers.get(), count);
            written = now;
        }
        return true;
    }

    private void write(Image image, Layers layers, int count) {
        try {
            passesWritten = writer.write(image, layers, count) ? count : passesWritten;
            isHindered = false;
        } catch (IOException hindered) {
            if (!isHindered) {
                unwritten.accept(hindered);
            }
            isHindered = true;
        }
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
