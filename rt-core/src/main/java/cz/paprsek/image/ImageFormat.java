package cz.paprsek.image;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** The kinds of file a picture can be written to. */
public enum ImageFormat {
    PNG("png", "8-bit sRGB, lossless", "png"),
    JPEG("jpg", "8-bit sRGB, quality 95 %", "jpg", "jpeg"),
    BMP("bmp", "8-bit sRGB, uncompressed", "bmp"),
    TIFF("tif", "8-bit sRGB, lossless", "tif", "tiff"),
    PPM("ppm", "8-bit sRGB, binary (P6)", "ppm"),
    /** For measuring: what is in the file is proportional to light. */
    PPM16("ppm16", "16-bit linear light, binary (P6)"),
    PGM("pgm", "8-bit brightness, binary (P5)", "pgm"),
    /** The only bitmap that keeps light above white. */
    PFM("pfm", "linear light as 32-bit floats", "pfm"),
    TEXT("txt", "brightness 0-255 as integers, one image row a line", "txt"),
    RAW_TEXT("txt-raw", "linear luminance as decimals, one image row a line");

    private final String id;
    private final String description;
    @SuppressWarnings("ImmutableEnumChecker") // made by List.of
    private final List<String> extensions;

    ImageFormat(String id, String description, String... extensions) {
        this.id = id;
        this.description = description;
        this.extensions = List.of(extensions);
    }

    /** The short name by which a user asks for the format. */
    public String id() {
        return id;
    }

    /** What is in the file, in a few words. */
    public String description() {
        return description;
    }

    /** The file name endings that stand for this format, without dot; none for a variant of another format. */
    public List<String> extensions() {
        return extensions;
    }

    /** The ending for a new file, without dot: {@code ppm} also for {@link #PPM16}. */
    public String extension() {
        return extensions.isEmpty() ? id.substring(0, 3) : extensions.get(0);
    }

    /** The format with the given short name or file name ending, letter case ignored. */
    public static Optional<ImageFormat> named(String name) {
        String wanted = name.toLowerCase(Locale.ROOT);
        return Arrays.stream(values()).filter(format -> format.id.equals(wanted) || format.extensions.contains(wanted)).findFirst();
    }

    /** The format that a file's ending stands for, letter case ignored. */
    public static Optional<ImageFormat> of(Path file) {
        Path name = file.getFileName();
        String text = name == null ? "" : name.toString();
        String ending = text.substring(text.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        return text.equals(ending) ? Optional.empty()
                : Arrays.stream(values()).filter(format -> format.extensions.contains(ending)).findFirst();
    }

    /** All endings there are, as {@code .png, .jpg, …}. */
    public static String knownEndings() {
        return Arrays.stream(values())
                .flatMap(format -> format.extensions.stream())
                .map(ending -> "." + ending)
                .collect(Collectors.joining(", "));
    }
}
