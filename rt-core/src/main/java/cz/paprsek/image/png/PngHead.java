package cz.paprsek.image.png;

/**
 * What a PNG file says of its samples.
 *
 * @param bits per sample: 8 or 16 in the files that are written
 * @param color the number of the colour type: 0 grey, 2 red, green and blue, 3 palette, 4 and 6 as 0 and 2 with opacity
 */
public record PngHead(int width, int height, int bits, int color) {
    static final byte[] SIGNATURE = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

    /** Samples per pixel in the file: one for a palette. */
    public int channels() {
        return switch (color) {
            case 2 -> 3;
            case 4 -> 2;
            case 6 -> 4;
            default -> 1;
        };
    }

    /** Bytes of a row of so many pixels. */
    int rowBytes(int pixels) {
        return (int) (((long) pixels * channels() * bits + 7) / 8);
    }

    /** Bytes from a byte to the one that stands for the same in the pixel after it, at least one. */
    int pixelBytes() {
        return Math.max(1, channels() * bits / 8);
    }
}
