package cz.paprsek.cli.output;

import cz.paprsek.cli.process.Terminal;
import cz.paprsek.io.Failures;
import cz.paprsek.render.Tile;
import cz.paprsek.render.TileStore;
import cz.paprsek.render.film.Film;
import cz.paprsek.resume.Checkpoint;
import java.io.IOException;
import java.util.concurrent.atomic.AtomicBoolean;

/** The tiles of a picture under way, in a file beside it: a render goes on where an earlier one stopped, and keeps what it has done for a later one. */
record KeptTiles(Checkpoint checkpoint, Terminal terminal, String shown, AtomicBoolean broken) implements TileStore {

    @Override
    public boolean load(Tile tile, int pass, Film into) {
        return checkpoint.load(tile, into);
    }

    @Override
    public void save(Tile tile, int pass, Film from) {
        if (broken.get()) {
            return;
        }
        try {
            checkpoint.save(tile, from);
        } catch (IOException e) {
            // The picture matters more than the wish to go on with it later.
            if (broken.compareAndSet(false, true)) {
                terminal.message(Failures.sentence(shown, e) + "; from here on, no more tiles are kept for --resume");
            }
        }
    }
}
