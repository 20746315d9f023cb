package cz.paprsek.cli.shard;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.shard.PartFile.Pixels;
import cz.paprsek.cli.shard.Survey.Found;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.image.Layers;
import cz.paprsek.io.Failures;
import cz.paprsek.render.Tile;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A picture put together of its parts.
 *
 * @param layers what else is known of its pixels; without planes if nothing is
 * @param origin what its file tells of it
 */
public record Assembly(Image image, Layers layers, Origin origin) {

    /** Reads all parts to the end, and leaves out those whose content is damaged. */
    public static Survey checked(Survey survey, Stop stop) throws IOException {
        Map<Path, String> broken = new LinkedHashMap<>();
        for (Found part : survey.parts()) {
            requireTime(stop);
            try {
                PartFile.read(part.file(), Pixels.IGNORED);
            } catch (IOException damaged) {
                broken.put(part.file(), Failures.sentence(part.file().toString(), damaged));
            }
        }
        return survey.without(broken);
    }

    /**
     * Puts them together.
     *
     * @param survey of all parts of one frame, which have been {@linkplain #checked checked}
     * @throws IOException if a part is no longer what it was
     */
    public static Assembly of(Survey survey, Stop stop) throws IOException {
        Card card = survey.card().orElseThrow();
        Tile region = card.region();
        Image image = card.transparent() ? Image.ofTransparent(region.width(), region.height()) : new Image(region.width(), region.height());
        List<String> names = card.planes();
        float[][] planes = new float[names.size()][region.width() * region.height()];
        int first = card.channels() - names.size();
        for (Found part : survey.parts()) {
            requireTime(stop);
            try {
                PartFile.read(part.file(), (column, row, numbers) -> {
                    int x = column - region.x();
                    int y = row - region.y();
                    if (card.transparent()) {
                        image.set(x, y, numbers[0], numbers[1], numbers[2], numbers[3]);
                    } else {
                        image.set(x, y, numbers[0], numbers[1], numbers[2]);
                    }
                    for (int i = 0; i < planes.length; i++) {
                        planes[i][y * region.width() + x] = numbers[first + i];
                    }
                });
            } catch (IOException changed) {
                throw new IOException(Failures.sentence(part.file().toString(), changed), changed);
            }
        }
        Layers layers = Layers.ofSize(region.width(), region.height());
        for (int i = 0; i < planes.length; i++) {
            layers = layers.with(names.get(i), planes[i]);
        }
        return new Assembly(image, layers, survey.parts().get(0).head().told().origin(card));
    }

    /** How many bytes of memory that takes. */
    public static long memory(Card card) {
        // Planes are copied once.
        return (long) Float.BYTES * card.region().width() * card.region().height() * (card.channels() + card.planes().size());
    }

    private static void requireTime(Stop stop) throws InterruptedIOException {
        if (stop.requested()) {
            throw new InterruptedIOException("interrupted");
        }
    }
}
