package cz.paprsek.cli.output;

import cz.paprsek.asset.Assets;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.TileStore;
import cz.paprsek.resume.Checkpoint;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicBoolean;

/** What becomes of the tiles of a picture when its render is interrupted. */
interface Tiles extends AutoCloseable {
    /** They are lost. */
    Tiles NOT_KEPT = () -> TileStore.NONE;

    /** Where the renderer finds and leaves them. */
    TileStore store();

    /** The picture is written. */
    default void discard() throws IOException {}

    @Override
    default void close() throws IOException {}

    /**
     * They are kept in a file beside the picture.
     *
     * @param way says beside which file, and what is to become of tiles of another picture
     * @param isQuiet whether nothing is to be said of what is done already
     * @throws WrongUsage if that file is of another picture
     */
    static Tiles kept(Target target, Way way, Scene scene, Assets assets, RenderOptions options, Terminal terminal, boolean isQuiet) throws IOException {
        Path picture = way.tilesBeside(target);
        Checkpoint checkpoint;
        try {
            checkpoint = Checkpoint.open(picture, way.keptAs(scene), assets, options, way.beginsAnew());
        } catch (Checkpoint.Refused refused) {
            throw new WrongUsage(String.valueOf(refused.getMessage()));
        }
        long pixels = (long) options.region().width() * options.region().height();
        if (checkpoint.pixels() > 0 && !isQuiet) {
            terminal.message(target.source().label() + (options.isInPasses() ? ": going on with the paths of an earlier render"
                    : ": going on, " + 100 * checkpoint.pixels() / pixels + " % is done already"));
        }
        KeptTiles kept = new KeptTiles(checkpoint, terminal, Checkpoint.fileFor(picture).toString(), new AtomicBoolean());
        return new Tiles() {
            @Override
            public TileStore store() {
                return kept;
            }

            @Override
            public void discard() throws IOException {
                // Paths can always go on.
                if (!options.isInPasses()) {
                    checkpoint.discard();
                }
            }

            @Override
            public void close() throws IOException {
                checkpoint.close();
            }
        };
    }
}
