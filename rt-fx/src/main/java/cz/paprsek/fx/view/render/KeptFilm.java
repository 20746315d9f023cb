package cz.paprsek.fx.view.render;

import cz.paprsek.fx.model.picture.UnfinishedPicture;
import cz.paprsek.render.Tile;
import cz.paprsek.render.TileStore;
import cz.paprsek.render.film.Film;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The tiles of a picture that may be cancelled, where they lie on its film, from which a later render of the same picture takes them. Nothing is copied while it
 * renders. A tile that is in the midst of another pass then has pixels of both, each of which goes on from where it is.
 */
final class KeptFilm implements TileStore {
    private final int channels;
    private final UnfinishedPicture onDisk;
    private final Map<Tile, Film> films = new ConcurrentHashMap<>();

    /**
     * Nothing yet.
     *
     * @param channels how many numbers each pixel has
     * @param onDisk what outlives the program
     */
    KeptFilm(int channels, UnfinishedPicture onDisk) {
        this.channels = channels;
        this.onDisk = onDisk;
    }

    @Override
    public boolean load(Tile tile, int pass, Film into) {
        Film known = films.get(tile);
        if (known == null && onDisk.load(tile, into)) {
            films.put(tile, into);
            return true;
        }
        if (known == null || known == into) {
            return false;
        }
        float[] values = new float[channels];
        for (int y = tile.y(); y < tile.y() + tile.height(); y++) {
            for (int x = tile.x(); x < tile.x() + tile.width(); x++) {
                for (int i = 0; i < channels; i++) {
                    values[i] = known.channel(i, x, y);
                }
                into.setChannels(x, y, values);
            }
        }
        films.put(tile, into);
        return true;
    }

    @Override
    public void save(Tile tile, int pass, Film from) {
        films.put(tile, from);
        onDisk.save(tile, from);
    }

    /** The picture is finished, or closed: nobody will go on with it. */
    void forget() {
        films.clear();
        onDisk.forget();
    }
}
