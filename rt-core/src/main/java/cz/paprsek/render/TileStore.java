package cz.paprsek.render;

import cz.paprsek.render.film.Film;
import java.io.IOException;

/**
 * Where finished tiles are kept: beside a picture that may be interrupted, or as parts that other machines compute. Its methods are called by all
 * workers at once, and should return quickly.
 */
public interface TileStore {
    /** How many pixels the sides of a tile have at most. */
    int LARGEST_SIDE = 32;

    /** Keeps nothing. */
    TileStore NONE = new TileStore() {
        @Override
        public boolean load(Tile tile, int pass, Film into) {
            return false;
        }

        @Override
        public void save(Tile tile, int pass, Film from) {}
    };

    /**
     * Puts a tile on the film, if it is known from an earlier render of the same picture. Asked before the tile is traced.
     *
     * @param tile its pixels, in the coordinates of the whole picture
     * @param pass which pass over the picture, from 0; a picture that is not made in passes has one. Asked in the first only: what is known may be of a later one, and
     *     the film then holds what goes on from there
     * @return whether it was known; if not, the film is as it was
     */
    boolean load(Tile tile, int pass, Film into) throws IOException;

    /** Keeps a tile that has been traced, whose pixels no longer change in this pass. */
    void save(Tile tile, int pass, Film from) throws IOException;
}
