package cz.paprsek.cli;

import cz.paprsek.image.ImageFormat;
import java.util.Arrays;
import java.util.Iterator;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** The names of picture formats as option values. */
final class Formats implements ITypeConverter<ImageFormat>, Iterable<String> {
    @Override
    public ImageFormat convert(String value) {
        return ImageFormat.of(value).orElseThrow(
                () -> new TypeConversionException("there is no format \"" + value + "\"; use one of " + ImageFormat.all()));
    }

    @Override
    public Iterator<String> iterator() {
        return Arrays.stream(ImageFormat.values()).map(ImageFormat::extension).iterator();
    }
}
