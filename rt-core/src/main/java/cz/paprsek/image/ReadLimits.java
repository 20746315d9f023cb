package cz.paprsek.image;

import java.io.IOException;

/** How large a picture may be that is read from a stranger: a few bytes may claim one that no memory holds. */
final class ReadLimits {
    private static final long MOST_BYTES = 1L << 30;
    private static final long MOST_PIXELS = 1L << 28;
    private static final int LONGEST_SIDE = 1 << 16;

    private ReadLimits() {}

    /** The largest file; the system property {@code paprsek.largest-file} allows more. */
    static long bytes() {
        return Long.getLong("paprsek.largest-file", MOST_BYTES);
    }

    /**
     * A black picture to be filled from a file.
     *
     * @throws IOException if it would be too large; the system property {@code paprsek.largest-picture} allows more pixels
     */
    static Image blank(long width, long height) throws IOException {
        check(width, height, 3);
        return new Image((int) width, (int) height);
    }

    /** As above, for a file of eight bits, sRGB-encoded: the picture keeps them as they are. */
    static Image blankOfEightBit(long width, long height) throws IOException {
        check(width, height, 3);
        return Image.ofEightBit((int) width, (int) height);
    }

    /** As above, for pictures of any number of channels. */
    static void check(long width, long height, int channels) throws IOException {
        long most = Math.min(Image.MOST_PIXELS, Long.getLong("paprsek.largest-picture", MOST_PIXELS));
        if (width < 1 || height < 1 || width > LONGEST_SIDE || height > LONGEST_SIDE) {
            throw new IOException("a picture must have from 1 to " + LONGEST_SIDE + " rows and columns, but this has " + width + " × " + height + " pixels");
        }
        if (width * height > most || width * height * channels > 3 * most) {
            throw new IOException("a picture of " + width + " × " + height + " pixels is larger than the " + most
                    + " pixels that are read (java -Dpaprsek.largest-picture=PIXELS allows more)");
        }
    }
}
