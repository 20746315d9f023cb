package cz.paprsek.cli.value;

import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.film.FilmWriter;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** What is written: pictures of a format, or a film of one. */
public record OutputFormat(Optional<ImageFormat> picture, Optional<FilmWriter.Format> film) {
    private static final List<String> NAMES = Stream.concat(Arrays.stream(ImageFormat.values()).map(ImageFormat::extension),
            Arrays.stream(FilmWriter.Format.values()).map(FilmWriter.Format::extension)).toList();

    public static OutputFormat parse(String name) {
        OutputFormat format = new OutputFormat(ImageFormat.of(name), FilmWriter.Format.of(name));
        if (format.picture.isEmpty() && format.film.isEmpty()) {
            throw Words.unknown(name, NAMES);
        }
        return format;
    }

    /** Lists the names for the help and for shells that complete words. */
    public static final class Names implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return NAMES.iterator();
        }
    }
}
