package cz.paprsek.image.png;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.util.Map;

/**
 * Writes animated PNG: what knows only PNG shows the first picture.
 *
 * @source PNG Specification (Third Edition), 11.3.6 animation information
 */
public final class PngFilm {
    private final PngWriter writer;
    private final PngHead head;
    private final int delay;
    private final int perSecond;
    private int sequence;

    /**
     * Writes all that comes before the pictures.
     *
     * @param delay for how long each is shown: so many …
     * @param perSecond … of so many parts of a second
     * @param texts by keywords
     */
    public PngFilm(PngHead head, int frames, int delay, int perSecond, Map<String, String> texts, OutputStream out) throws IOException {
        this.writer = new PngWriter(head, out);
        this.head = head;
        this.delay = delay;
        this.perSecond = perSecond;
        writer.start(texts);
        // Again and again.
        writer.chunk("acTL", ByteBuffer.allocate(8).putInt(frames).putInt(0).array());
    }

    /** Writes the next picture. */
    public void add(PngWriter.Rows rows) throws IOException {
        boolean isFirst = sequence == 0;
        writer.chunk("fcTL", ByteBuffer.allocate(26).putInt(sequence++).putInt(head.width()).putInt(head.height()).putInt(0).putInt(0)
                .putShort((short) delay).putShort((short) perSecond).putShort((short) 0).array());
        writer.pixels(rows, isFirst ? writer::data : (bytes, size) -> writer.chunk("fdAT", ByteBuffer.allocate(Integer.BYTES + size).putInt(sequence++).put(bytes, 0, size).array()));
    }

    /** Writes the end. */
    public void end() throws IOException {
        writer.chunk("IEND", new byte[0]);
    }
}
