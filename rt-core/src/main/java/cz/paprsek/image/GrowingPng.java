package cz.paprsek.image;

import cz.paprsek.image.png.PngWriter;
import cz.paprsek.image.png.Stripes;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.material.Rgb.Tone;
import java.io.IOException;
import java.nio.file.Path;

/** A picture under way that is to be a PNG: rows are compressed by other threads as soon as they are complete, so that little is left to do in the end. The file is the same. */
public final class GrowingPng implements AutoCloseable {
    private final Image image;
    private final int bits;
    private final Stripes stripes;
    /** How many pixels of each row are complete. */
    private final int[] pixels;
    private int rows;

    /** @param bits 8 or 16 per channel */
    public GrowingPng(Image image, int bits) {
        this.image = image;
        this.bits = ImageOptions.DEFAULT.withBits(bits).bitsOf(ImageFormat.PNG);
        stripes = Png.stripes(image, bits);
        pixels = new int[image.height()];
    }

    /** Takes note that some pixels will no longer change: in so many rows from y on so many of each, none of which was told before. */
    public synchronized void finished(int y, int width, int height) {
        for (int row = y; row < y + height; row++) {
            pixels[row] += width;
        }
        while (rows < pixels.length && pixels[rows] == image.width()) {
            rows++;
        }
        stripes.begin(rows);
    }

    /** Whether it is this picture that is to be written, and as it is. */
    public boolean isOf(Image other, ImageOptions options) {
        return other == image && options.bitsOf(ImageFormat.PNG) == bits && options.exposure() == 0 && options.tone() == Tone.NONE;
    }

    /** Writes the picture, which is complete, as {@link ImageFiles#write(Image, Path, ImageFormat, ImageOptions)} does; once only. */
    public synchronized void write(Path file, ImageOptions options) throws IOException {
        AtomicFile.write(file, out -> {
            PngWriter.write(options.origin().texts(), stripes, out);
            out.flush();
        });
    }

    /** Ends what is under way. */
    @Override
    public void close() {
        stripes.close();
    }
}
