package cz.paprsek.cli.shard;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.shard.PartFile.Pixels;
import cz.paprsek.cli.shard.Survey.Found;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions.Origin;
import cz.paprsek.image.Layers;
import cz.paprsek.io.Failures;
import cz.paprsek.render.Tile;
import cz.paprsek.render.join.JoinedNoise;
import cz.paprsek.render.join.JoinedPasses;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
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
    /** Numbers of a pixel that a denoiser works with beside what it is told. */
    private static final int DENOISED = 18;

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
        if (isInPasses(survey)) {
            join(survey, image, stop);
        }
        read(survey, 0, stop, (column, row, numbers) -> {
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
        Layers layers = Layers.ofSize(region.width(), region.height());
        List<float[]> noise = new ArrayList<>();
        for (int i = 0; i < planes.length; i++) {
            if (JoinedNoise.has(names.get(i))) {
                noise.add(planes[i]);
            } else {
                layers = layers.with(names.get(i), planes[i]);
            }
        }
        if (!noise.isEmpty() && !JoinedNoise.takeOut(image, noise, Runtime.getRuntime().availableProcessors(), stop::requested)) {
            throw new InterruptedIOException("interrupted");
        }
        return new Assembly(image, layers, survey.parts().get(0).head().told().origin(card));
    }

    /** Adds up the passes of pixels, in order; of those of which there are parts with all passes, it does not matter what comes of it. */
    private static void join(Survey survey, Image image, Stop stop) throws IOException {
        Card card = survey.card().orElseThrow();
        Tile region = card.region();
        int size = JoinedPasses.size(card.filter());
        JoinedPasses joined = new JoinedPasses(region.width(), region.height(), card.filter());
        // There may be more than one part that has a pass of a pixel, but it counts once.
        float[][] pass = new float[region.height()][size * region.width()];
        float[] numbers = new float[size];
        // Where one is not there at all, there are parts with all of them.
        for (int number : survey.parts().stream().map(part -> part.head().pass()).filter(number -> number > 0).distinct().sorted().toList()) {
            read(survey, number, stop, (column, row, kept) -> System.arraycopy(kept, 0, pass[row - region.y()], size * (column - region.x()), size));
            requireTime(stop);
            for (int i = 0; i < region.width() * region.height(); i++) {
                System.arraycopy(pass[i / region.width()], size * (i % region.width()), numbers, 0, size);
                joined.add(i % region.width(), i / region.width(), numbers);
            }
        }
        for (int i = 0; i < region.width() * region.height(); i++) {
            joined.develop(i % region.width(), i / region.width(), image);
        }
    }

    private static boolean isInPasses(Survey survey) {
        return survey.parts().stream().anyMatch(part -> part.head().pass() > 0);
    }

    /** Reads all parts of a pass, or those that have all. */
    private static void read(Survey survey, int pass, Stop stop, Pixels pixels) throws IOException {
        for (Found part : survey.parts()) {
            if (part.head().pass() == pass) {
                requireTime(stop);
                try {
                    PartFile.read(part.file(), pixels);
                } catch (IOException changed) {
                    throw new IOException(Failures.sentence(part.file().toString(), changed), changed);
                }
            }
        }
    }

    /** How many bytes of memory that takes. */
    public static long memory(Survey survey) {
        Card card = survey.card().orElseThrow();
        // Planes are copied once; passes are added to those before.
        int passes = isInPasses(survey) ? 2 * JoinedPasses.size(card.filter()) : 0;
        int noise = card.layers().size() < card.planes().size() ? DENOISED : 0;
        return (long) Float.BYTES * card.region().width() * card.region().height() * (card.channels() + card.layers().size() + passes + noise);
    }

    private static void requireTime(Stop stop) throws InterruptedIOException {
        if (stop.requested()) {
            throw new InterruptedIOException("interrupted");
        }
    }
}
