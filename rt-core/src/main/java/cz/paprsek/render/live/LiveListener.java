package cz.paprsek.render.live;

import cz.paprsek.image.Image;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.Tile;

/** Is told how a live picture comes along, by the threads that render it: all methods must return quickly. */
public interface LiveListener {
    /**
     * Pixels have been computed. The first pass is told of as a whole, so that a moving picture is never torn; later ones tile by tile.
     *
     * @param pass what the pixels belong to
     * @param image the picture of the pass, {@code pass.step()} times smaller than the final one, rounded up
     * @param tile which pixels of it are new; they no longer change
     */
    void painted(LivePass pass, Image image, Tile tile);

    /** A pass is complete; all its pixels have been told of. */
    default void completed(LivePass pass, RenderResult result) {}

    /** The program has a fault, or too little memory; there will be nothing more of this picture. */
    void failed(Throwable fault);
}
