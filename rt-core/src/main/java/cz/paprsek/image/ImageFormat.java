package cz.paprsek.image;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** The kinds of file that a picture can be written to. Eight-bit kinds are sRGB-encoded and clamped; the others say what they hold. */
public enum ImageFormat {
    /** 8-bit sRGB, lossless. */
    PNG("png"),
    /** 8-bit sRGB, small. */
    JPG("jpg", "jpeg"),
    /** 8-bit sRGB, uncompressed. */
    BMP("bmp"),
    /** 8-bit sRGB, lossless. */
    TIF("tif", "tiff"),
    /** 8-bit sRGB, uncompressed. */
    PPM("ppm"),
    /** 8-bit brightness. */
    PGM("pgm"),
    /** Linear light as 32-bit floats, unclamped. */
    PFM("pfm"),
    /** Brightness 0-255 as text, one image row a line. */
    TXT("txt"),
    /** Linear luminance as decimal text, one image row a line. */
    RAW("lum"),
    /** 16-bit linear light, for comparing with other renderers. */
    PPM16("ppm16"),
    /** Linear light, three bytes with one exponent, unclamped. */
    HDR("hdr"),
    /** Linear light as 16- or 32-bit floats, unclamped. */
    EXR("exr");

    @SuppressWarnings("ImmutableEnumChecker") // never written after construction, never handed out
    private final String[] extensions;

    ImageFormat(String... extensions) {
        this.extensions = extensions;
    }

    /** The usual ending of the file's name, without a dot. */
    public String extension() {
        return extensions[0];
    }

    /** How many bytes a picture of this size takes at least; 0 if that depends on what it shows. */
    public long leastBytes(int width, int height) {
        long pixels = (long) width * height;
        return switch (this) {
            case PNG, JPG, TIF, EXR -> 0;
            case HDR -> 4L * height;
            case PGM -> pixels;
            case TXT, RAW -> 2 * pixels;
            case BMP, PPM -> 3 * pixels;
            case PPM16 -> 6 * pixels;
            case PFM -> 12 * pixels;
        };
    }

    /** How many bits per channel it can have, the usual number first. */
    public List<Integer> depths() {
        return switch (this) {
            case PNG -> List.of(8, 16);
            case EXR -> List.of(16, 32);
            case PFM, RAW -> List.of(32);
            case PPM16 -> List.of(16);
            case JPG, BMP, TIF, PPM, PGM, TXT, HDR -> List.of(8);
        };
    }

    /** Whether it can hold how much of each pixel is covered. */
    public boolean isTransparent() {
        return this == PNG || this == EXR;
    }

    String depthsAsText() {
        return depths().stream().map(String::valueOf).collect(Collectors.joining(" or "));
    }

    /** The format with the given name or extension, upper or lower case. */
    public static Optional<ImageFormat> of(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        return Arrays.stream(values()).filter(format -> List.of(format.extensions).contains(lower)).findFirst();
    }

    /** The format that a file's name ends with. */
    public static Optional<ImageFormat> ofFile(String fileName) {
        int dot = fileName.lastIndexOf('.');
        return dot < 0 ? Optional.empty() : of(fileName.substring(dot + 1));
    }

    /** The extensions of all formats, separated by commas. */
    public static String all() {
        return Arrays.stream(values()).map(ImageFormat::extension).collect(Collectors.joining(", "));
    }
}
