package cz.paprsek.format.model;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.PushbackInputStream;
import java.io.Reader;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;

/** Text in UTF-16, read as UTF-8. */
public final class Transcoded extends InputStream {
    private static final int PIECE = 8192;

    private final Reader reader;
    private final char[] letters = new char[PIECE + 1];
    private byte[] bytes = new byte[0];
    private int at;

    private Transcoded(InputStream input, Charset charset) {
        reader = new InputStreamReader(input, charset);
    }

    /** Text of an unknown encoding: UTF-8 or, where that makes no sense, Latin-1. */
    public static String decoded(byte[] bytes, int from, int to) {
        String text = new String(bytes, from, to - from, StandardCharsets.UTF_8);
        return text.indexOf('\uFFFD') < 0 ? text : new String(bytes, from, to - from, StandardCharsets.ISO_8859_1);
    }

    /** The text as UTF-8 or some other encoding that has ASCII in it, without a byte-order mark. */
    public static InputStream utf8(InputStream input) throws IOException {
        PushbackInputStream peeked = new PushbackInputStream(input, 3);
        byte[] mark = peeked.readNBytes(3);
        int first = mark.length < 2 ? 0 : (mark[0] & 0xFF) << 8 | (mark[1] & 0xFF);
        boolean isMarked8 = mark.length == 3 && first == 0xEFBB && (mark[2] & 0xFF) == 0xBF;
        boolean isMarked16 = first == 0xFEFF || first == 0xFFFE;
        int used = isMarked8 ? 3 : isMarked16 ? 2 : 0;
        peeked.unread(mark, used, mark.length - used);
        boolean isHighFirst = first == 0xFEFF || (first != 0 && first < 0x100);
        boolean isLowFirst = first == 0xFFFE || (first != 0 && (first & 0xFF) == 0);
        return isHighFirst ? new Transcoded(peeked, StandardCharsets.UTF_16BE) : isLowFirst ? new Transcoded(peeked, StandardCharsets.UTF_16LE) : peeked;
    }

    @Override
    public int read() throws IOException {
        return at < bytes.length || refill() ? bytes[at++] & 0xFF : -1;
    }

    @Override
    public int read(byte[] into, int offset, int length) throws IOException {
        if (at == bytes.length && !refill()) {
            return -1;
        }
        int count = Math.min(length, bytes.length - at);
        System.arraycopy(bytes, at, into, offset, count);
        at += count;
        return count;
    }

    private boolean refill() throws IOException {
        int count = reader.read(letters, 0, PIECE);
        if (count < 0) {
            return false;
        }
        if (Character.isHighSurrogate(letters[count - 1])) {
            int low = reader.read();
            if (low >= 0) {
                letters[count++] = (char) low;
            }
        }
        bytes = new String(letters, 0, count).getBytes(StandardCharsets.UTF_8);
        at = 0;
        return true;
    }

    @Override
    public void close() throws IOException {
        reader.close();
    }
}
