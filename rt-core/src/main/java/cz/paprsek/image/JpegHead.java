package cz.paprsek.image;

import java.io.IOException;

/**
 * Looks through a JPEG before the platform decodes it, in memory and time that only the file's word limits: a few bytes may claim many pixels,
 * and a thousand scans of all of them.
 *
 * @source ITU-T T.81, B.1.1 and B.2
 */
final class JpegHead {
    private static final int MOST_SCANS = 200;
    /** A block of 64 pixels takes one bit at the least. */
    private static final long MOST_PIXELS_A_BYTE = 64 * 8;

    private JpegHead() {}

    static boolean canRead(byte[] start) {
        return start.length > 2 && (start[0] & 0xFF) == 0xFF && (start[1] & 0xFF) == 0xD8;
    }

    /** @throws IOException if decoding it would take more than its size warrants */
    static void check(byte[] file) throws IOException {
        int scans = 0;
        int at = 2;
        while (at + 4 <= file.length) {
            int marker = file[at + 1] & 0xFF;
            if ((file[at] & 0xFF) != 0xFF || marker == 0 || (marker >= 0xD0 && marker <= 0xD8) || marker == 0xFF || marker == 0x01) {
                // Between markers lie the coded pixels, in which FF is followed by 00 or a restart.
                at++;
                continue;
            }
            if (marker == 0xD9) {
                return;
            }
            boolean isFrame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
            if (isFrame && at + 9 <= file.length) {
                long height = number(file, at + 5);
                long width = number(file, at + 7);
                if (width * height > MOST_PIXELS_A_BYTE * file.length) {
                    throw new IOException("a picture of " + width + " × " + height + " pixels does not fit into a file of " + file.length
                            + " bytes: it is cut off or damaged");
                }
            }
            scans += marker == 0xDA ? 1 : 0;
            if (scans > MOST_SCANS) {
                throw new IOException("this JPEG draws its picture in more than " + MOST_SCANS + " scans");
            }
            at += 2 + number(file, at + 2);
        }
    }

    private static int number(byte[] file, int at) {
        return (file[at] & 0xFF) << 8 | (file[at + 1] & 0xFF);
    }
}
