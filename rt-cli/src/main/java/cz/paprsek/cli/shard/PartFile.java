package cz.paprsek.cli.shard;

import cz.paprsek.image.Image;
import cz.paprsek.image.Layers;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.resume.SceneDigest;
import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.util.Arrays;

/**
 * A part of a picture in a file: a line that tells the format and its version, the number of bytes of the head, the head, the pixels row by row with all their
 * numbers as floats, and the SHA-256 of all that. Numbers are big-endian. It appears as a whole or not at all.
 */
final class PartFile {
    static final String ENDING = ".part";
    private static final String FORMAT = "paprsek part ";
    private static final byte[] MAGIC = (FORMAT + "2\n").getBytes(StandardCharsets.US_ASCII);
    /** More than the names of a hundred thousand layers take. */
    private static final int LARGEST_HEAD = 1 << 24;
    private static final int DIGEST = 32;

    private PartFile() {}

    /** Is told of the pixels of a part. */
    @FunctionalInterface
    interface Pixels {
        /** Nobody: for who only asks whether the file is whole. */
        Pixels IGNORED = (x, y, numbers) -> {};

        /** @param numbers in the order of the card: light, opacity, planes; of a pass what is kept of it; the array is used again */
        void put(int x, int y, float[] numbers);
    }

    /** A part file of another version of the format. */
    static final class OtherVersion extends IOException {
        private static final long serialVersionUID = 1;

        OtherVersion() {
            super("written by another version, in a format that this one does not read");
        }
    }

    /** What is to be written of pixels. */
    @FunctionalInterface
    interface Numbers {
        /** One of a pixel's numbers, counted from 0; columns and rows from the part's top left. */
        float at(int channel, int x, int y);

        /** All of finished ones, in the order of the card. */
        static Numbers of(Card card, Image image, Layers layers) {
            int lights = card.channels() - card.planes().size();
            return (channel, x, y) -> switch (channel) {
                case 0 -> image.red(x, y);
                case 1 -> image.green(x, y);
                case 2 -> image.blue(x, y);
                default -> channel < lights ? image.alpha(x, y) : layers.at(card.planes().get(channel - lights), x, y);
            };
        }
    }

    static void write(Path file, PartHead head, Numbers numbers) throws IOException {
        // There are thousands of them in a folder, which is swept once for all.
        AtomicFile.writeUnswept(file, target -> {
            MessageDigest digest = SceneDigest.sha256();
            // Small pieces would take the digest longer than all of them together.
            DataOutputStream out = new DataOutputStream(new BufferedOutputStream(new DigestOutputStream(target, digest), 1 << 14));
            byte[] text = head.text().getBytes(StandardCharsets.UTF_8);
            out.write(MAGIC);
            out.writeInt(text.length);
            out.write(text);
            int channels = head.channels();
            for (int y = 0; y < head.tile().height(); y++) {
                for (int x = 0; x < head.tile().width(); x++) {
                    for (int channel = 0; channel < channels; channel++) {
                        out.writeFloat(numbers.at(channel, x, y));
                    }
                }
            }
            out.flush();
            target.write(digest.digest());
        });
    }

    /**
     * The head of a file, whose pixels seem to be there: their number is right.
     *
     * @throws IOException with a sentence that does not name the file, if it is not whole, or no part
     */
    static PartHead head(Path file) throws IOException {
        try (InputStream input = Files.newInputStream(file)) {
            return head(new DataInputStream(new BufferedInputStream(input)), Files.size(file));
        }
    }

    private static PartHead head(DataInputStream input, long size) throws IOException {
        byte[] magic = input.readNBytes(MAGIC.length);
        if (!Arrays.equals(magic, MAGIC)) {
            if (new String(magic, StandardCharsets.US_ASCII).startsWith(FORMAT)) {
                throw new OtherVersion();
            }
            throw new IOException(size < MAGIC.length ? "cut off, it has " + size + " bytes" : "no part of a picture");
        }
        if (size < MAGIC.length + Integer.BYTES) {
            throw new IOException("cut off, it has " + size + " bytes");
        }
        int length = input.readInt();
        if (length < 0 || length > LARGEST_HEAD) {
            throw new IOException("damaged, its head cannot have " + Integer.toUnsignedString(length) + " bytes");
        }
        if (length > size - MAGIC.length - Integer.BYTES) {
            throw new IOException("cut off, it has " + size + " bytes");
        }
        byte[] text = input.readNBytes(length);
        PartHead head = PartHead.read(new String(text, StandardCharsets.UTF_8));
        long whole = MAGIC.length + Integer.BYTES + length + head.pixelBytes() + DIGEST;
        if (size != whole) {
            throw new IOException((size < whole ? "cut off, it has " : "too long, it has ") + size + " bytes in place of " + whole);
        }
        return head;
    }

    /**
     * Reads a part; all pixels are told before it is known whether they are right.
     *
     * @throws IOException as {@link #head}, or if the content is not what was written
     */
    static PartHead read(Path file, Pixels pixels) throws IOException {
        MessageDigest digest = SceneDigest.sha256();
        try (InputStream opened = Files.newInputStream(file); BufferedInputStream buffered = new BufferedInputStream(opened, 1 << 16)) {
            DataInputStream input = new DataInputStream(new BufferedInputStream(new DigestInputStream(new Before(buffered, Files.size(file) - DIGEST), digest), 1 << 14));
            PartHead head = head(input, Files.size(file));
            float[] numbers = new float[head.channels()];
            for (int i = 0; i < head.tile().width() * head.tile().height(); i++) {
                for (int channel = 0; channel < numbers.length; channel++) {
                    numbers[channel] = input.readFloat();
                }
                pixels.put(head.tile().x() + i % head.tile().width(), head.tile().y() + i / head.tile().width(), numbers);
            }
            if (!Arrays.equals(digest.digest(), buffered.readNBytes(DIGEST))) {
                throw new IOException("damaged, its content is not what was written");
            }
            return head;
        }
    }

    /** A stream up to some place, so that who buffers does not read beyond it. */
    private static final class Before extends FilterInputStream {
        private long left;

        Before(InputStream input, long length) {
            super(input);
            left = Math.max(0, length);
        }

        @Override
        public int read() throws IOException {
            byte[] one = new byte[1];
            return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
        }

        @Override
        public int read(byte[] into, int from, int length) throws IOException {
            if (left == 0) {
                return -1;
            }
            int count = super.read(into, from, (int) Math.min(length, left));
            left -= Math.max(0, count);
            return count;
        }
    }
}
