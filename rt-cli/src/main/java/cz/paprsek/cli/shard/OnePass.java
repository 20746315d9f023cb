package cz.paprsek.cli.shard;

import cz.paprsek.cli.shard.Deal.Piece;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Tile;
import cz.paprsek.render.TileStore;
import cz.paprsek.render.film.Film;
import cz.paprsek.render.join.JoinedPasses;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;

/** One of the passes of a part by itself: the renderer is told that those before it are there, and what is kept of this one goes to a file. */
final class OnePass implements TileStore, PartFile.Numbers {
    private final RenderOptions options;
    private final Piece piece;
    private final int keptFrom;
    private final int size;
    private final float[] kept;

    /** @param options of all passes of this part */
    OnePass(RenderOptions options, Scene scene, Piece piece) {
        this.options = options;
        this.piece = piece;
        keptFrom = options.keptFrom(scene);
        size = piece.pass() == 0 ? 0 : JoinedPasses.size(options.settings().filter());
        kept = new float[size * piece.tile().width() * piece.tile().height()];
    }

    /** Without the passes after it. */
    RenderOptions upToIt() {
        return options.withSettings(options.settings().withMostRays(piece.pass() * RenderSettings.USUAL_PATHS));
    }

    @Override
    public boolean load(Tile tile, int pass, Film into) {
        float[] none = new float[into.channels()];
        none[keptFrom] = (piece.pass() - 1) * RenderSettings.USUAL_PATHS;
        for (int i = 0; i < tile.width() * tile.height(); i++) {
            into.setChannels(tile.x() + i % tile.width(), tile.y() + i / tile.width(), none);
        }
        return piece.pass() > 1;
    }

    @Override
    public void save(Tile tile, int pass, Film from) {
        for (int y = tile.y(); y < tile.y() + tile.height(); y++) {
            for (int x = tile.x(); x < tile.x() + tile.width(); x++) {
                for (int i = 0; i < size; i++) {
                    kept[place(i, x - piece.tile().x(), y - piece.tile().y())] = from.channel(keptFrom + i, x, y);
                }
            }
        }
    }

    @Override
    public float at(int channel, int x, int y) {
        return kept[place(channel, x, y)];
    }

    private int place(int channel, int x, int y) {
        return (y * piece.tile().width() + x) * size + channel;
    }
}
