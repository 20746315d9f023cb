package cz.paprsek.render;

import cz.paprsek.image.Image;
import cz.paprsek.image.Layers;
import java.util.function.Supplier;

/** What a render asks and tells its caller while it runs, from any of its threads. The methods must return quickly. */
public interface RenderMonitor {
    /** Never cancels, and listens to nothing. */
    RenderMonitor NONE = new RenderMonitor() {};

    /** Whether to stop; asked often. Once true, it should stay true. */
    default boolean cancelled() {
        return false;
    }

    /**
     * Rays have been traced, for the tile that is told to be finished next.
     *
     * @param rays of all kinds
     */
    default void traced(long rays) {}

    /**
     * Whether tiles are taken row by row from the top, for who does something with complete rows, rather than evenly all over the picture, which tells how long the rest takes.
     * Asked once, before any is begun.
     */
    default boolean wantsRows() {
        return false;
    }

    /** A tile of the picture is complete without having been traced: a {@link TileStore} had it. Else as {@link #finished}, which it is unless told otherwise. */
    default void found(Tile tile, Image image, int done, int total) {
        finished(tile, image, done, total);
    }

    /**
     * A tile of the picture is complete.
     *
     * @param tile its pixels, in the coordinates of the image under way
     * @param image the image under way; pixels of finished tiles no longer change, unless there is another pass
     * @param done tiles finished so far, those of earlier passes and this one included; of a picture of paths that end when they are near enough, as many tiles as the
     *     pixels make that need no more
     * @param total tiles in all, of all passes there may be; of such a picture, of one
     */
    default void finished(Tile tile, Image image, int done, int total) {}

    /**
     * A pass over the whole picture is complete, and another one will make it better. Called by the thread that waits for the picture, while nothing is traced.
     *
     * @param image the picture as good as it is
     * @param layers makes a copy of what else is known of its pixels by now
     * @param passes how many there have been
     * @return whether to go on; if not, the picture is as it is, and counts as complete
     */
    default boolean passed(Image image, Supplier<Layers> layers, int passes) {
        return true;
    }

    /** All that is wanted is traced, and its noise is being taken out from now on; not called if that is not wished. Called by the thread that waits for the picture. */
    default void denoising() {}

    /** One that asks and tells another one all that it does not answer itself. */
    interface PassingOn extends RenderMonitor {
        /** The other one. */
        RenderMonitor own();

        @Override
        default boolean cancelled() {
            return own().cancelled();
        }

        @Override
        default void traced(long rays) {
            own().traced(rays);
        }

        @Override
        default boolean wantsRows() {
            return own().wantsRows();
        }

        @Override
        default void found(Tile tile, Image image, int done, int total) {
            own().found(tile, image, done, total);
        }

        @Override
        default void finished(Tile tile, Image image, int done, int total) {
            own().finished(tile, image, done, total);
        }

        @Override
        default boolean passed(Image image, Supplier<Layers> layers, int passes) {
            return own().passed(image, layers, passes);
        }

        @Override
        default void denoising() {
            own().denoising();
        }
    }
}
