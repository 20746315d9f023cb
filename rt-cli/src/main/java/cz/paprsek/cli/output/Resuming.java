package cz.paprsek.cli.output;

import cz.paprsek.cli.process.Terminal;
import cz.paprsek.image.Image;
import cz.paprsek.io.Failures;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.Tile;
import java.io.IOException;
import java.util.concurrent.atomic.AtomicBoolean;

/** A render that goes on where an earlier one stopped, and keeps what it has done for a later one. */
record Resuming(Progress progress, Checkpoint checkpoint, Terminal terminal, String shown, AtomicBoolean broken) implements RenderMonitor {

    @Override
    public boolean cancelled() {
        return progress.cancelled();
    }

    @Override
    public boolean restored(Tile tile, Image image) {
        return checkpoint.restore(tile, image);
    }

    @Override
    public void traced(long rays) {
        progress.traced(rays);
    }

    @Override
    public void finished(Tile tile, Image image, int done, int total) {
        if (checkpoint.holds(tile)) {
            progress.found(tile);
            return;
        }
        if (!broken.get()) {
            try {
                checkpoint.save(tile, image);
            } catch (IOException e) {
                // The picture matters more than the wish to go on with it later.
                if (broken.compareAndSet(false, true)) {
                    terminal.message(Failures.sentence(shown, e) + "; from here on, no more tiles are kept for --resume");
                }
            }
        }
        progress.finished(tile, image, done, total);
    }
}
