package cz.paprsek.cli.shard;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.Shard;
import java.io.IOException;

/** Takes the order for a picture that is shared out. */
public interface Sharing {
    /** Whose work it is. */
    Shard shard();

    /**
     * Makes what is to be made of it; returns early if a stop is asked for.
     *
     * @throws IOException if a part cannot be written
     * @throws WrongUsage if there are parts of another picture where these should go
     */
    Done run(Order order, Stop stop, Listener listener) throws IOException;

    /**
     * How much there was to do.
     *
     * @param parts of the share
     * @param made those of them that were not there
     */
    record Done(int parts, int made) {}

    /** Is told how far it is, by any thread. */
    @FunctionalInterface
    interface Listener {
        /**
         * A part is there.
         *
         * @param done how many are, those that were there before included
         */
        void made(int done, int parts);
    }
}
