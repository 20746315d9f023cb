package cz.paprsek.spark;

import java.io.IOException;
import java.io.Serializable;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** All that a machine must know to make any tile, sent to each once: the scene and its files, and what is to be made of them. */
final class Job implements Serializable {
    private static final long serialVersionUID = 1;

    private final String scene;
    private final Map<String, byte[]> files;
    private final List<String> order;
    private final List<String> written;
    private final String ending;
    private final String card;
    private final int side;
    private final Places places;
    /** What this machine has made of it. */
    private transient @Nullable Workshop workshop;

    /**
     * A picture or film.
     *
     * @param scene the name of its file
     * @param files that file, and those which it needs, by their names
     * @param order words for {@code render}, with the scene under its name
     * @param written words for {@code merge}
     * @param ending that of the pictures' format
     * @param card as {@link cz.paprsek.cli.shard.Piecework#card}
     * @param side of tiles, in pixels
     */
    Job(String scene, Map<String, byte[]> files, List<String> order, List<String> written, String ending, String card, int side, Places places) {
        this.scene = scene;
        this.files = files;
        this.order = order;
        this.written = written;
        this.ending = ending;
        this.card = card;
        this.side = side;
        this.places = places;
    }

    String scene() {
        return scene;
    }

    Map<String, byte[]> files() {
        return files;
    }

    List<String> order() {
        return order;
    }

    List<String> written() {
        return written;
    }

    String ending() {
        return ending;
    }

    String card() {
        return card;
    }

    int side() {
        return side;
    }

    Places places() {
        return places;
    }

    /** Reads the scene, if no task on this machine has done so yet. */
    synchronized Workshop workshop() throws IOException {
        Workshop known = workshop;
        if (known == null) {
            known = Workshop.open(this);
            workshop = known;
        }
        return known;
    }
}
