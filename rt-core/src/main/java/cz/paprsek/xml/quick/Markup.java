package cz.paprsek.xml.quick;

import cz.paprsek.xml.format.SceneFormat;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Pulls tags, attributes and texts out of XML of the plain kind that scene files are: UTF-8, no processing instructions, no CDATA, no entities
 * but those of the standard. All else is {@link Unusual}, and so is everything wrong, for the caller to look at thoroughly.
 */
final class Markup {
    private static final int BUFFER = 1 << 18;
    /** The longest value, and what is looked at at once, in bytes: a tag, comment or text that is cut by the end of the buffer is too long. */
    private static final int LONGEST = 1 << 16;
    /** What is kept of what was read, at most, in bytes. */
    private static final int LONGEST_KEPT = 1 << 12;
    private static final String DECLARATION = "<\\?xml version=(['\"])1\\.0\\1( encoding=(['\"])[uU][tT][fF]-8\\3)?( standalone=(['\"])(yes|no)\\5)?\\s*\\?>";

    private InputStream input;
    private final DecimalReader decimals = new DecimalReader();
    private final byte[] buffer;
    private int at;
    /** Where the buffer's content ends; there stands a 0, which XML does not have, so that no loop need look for the end. */
    private int end;
    private boolean isAllRead;
    /** How much of the file is before the buffer. */
    private long dropped;
    private int nameFrom;
    private int nameTo;
    private int valueFrom;
    private int valueTo;
    /** Whether the value stands for itself, character by character. */
    private boolean isPlain;
    private boolean isEmpty;

    /** Of a piece of a file. */
    Markup(byte[] file, int from, int to) {
        input = InputStream.nullInputStream();
        end = to - from;
        buffer = new byte[end + 1];
        System.arraycopy(file, from, buffer, 0, end);
        isAllRead = true;
    }

    /** Begins to read after the mark of UTF-8 and the XML declaration, if there are any. */
    Markup(InputStream input) throws IOException {
        this.input = input;
        buffer = new byte[BUFFER + 1];
        fill();
        at = buffer[0] == (byte) 0xEF && buffer[1] == (byte) 0xBB && buffer[2] == (byte) 0xBF ? 3 : 0;
        if (startsWith("<?xml ")) {
            int close = indexOf('>') + 1;
            Unusual.unless(new String(buffer, at, close - at, StandardCharsets.ISO_8859_1).matches(DECLARATION));
            at = close;
        }
    }

    /** Moves to the next tag; whether it is a start tag. */
    boolean nextTag() throws IOException {
        while (true) {
            if (end - at < LONGEST) {
                fill();
            }
            skipBlanks();
            if (at == end && !isAllRead) {
                continue;
            }
            Unusual.unless(buffer[at] == '<');
            at++;
            if (!startsWith("!--")) {
                break;
            }
            skipComment();
        }
        boolean isStart = buffer[at] != '/';
        at += isStart ? 0 : 1;
        name();
        return isStart;
    }

    /** Up to where the file has been read, in bytes. */
    long place() {
        return dropped + at;
    }

    /** What was read from a place on; nothing if that is long, or not at hand any more. */
    byte[] since(long place) {
        long from = place - dropped;
        return from >= 0 && at - from <= LONGEST_KEPT ? Arrays.copyOfRange(buffer, (int) from, at) : new byte[0];
    }

    /** Moves behind what comes next, if that is what was {@linkplain #since read} once; whether it is. */
    boolean isOnceMore(byte[] kept) {
        int behind = at + kept.length;
        boolean isKept = kept.length > 0 && behind <= end && Arrays.equals(buffer, at, behind, kept, 0, kept.length);
        at = isKept ? behind : at;
        return isKept;
    }

    /** A number made of all that is left of a tag, by which it is found among others. */
    int fingerprint() {
        int print = 0;
        for (int i = at; buffer[i] != '>' && buffer[i] != 0; i++) {
            print = 31 * print + buffer[i];
        }
        return print;
    }

    /** What has not been read. */
    InputStream rest() {
        return new SequenceInputStream(new ByteArrayInputStream(Arrays.copyOfRange(buffer, at, end)), input);
    }

    /** Reads on from another stream, and forgets what is left of the last. */
    void readOn(InputStream other) {
        input = other;
        at = end;
        isAllRead = false;
    }

    /** Whether the tag or the attribute at hand has this name. */
    boolean isNamed(byte[] name) {
        return nameTo - nameFrom == name.length && Arrays.equals(buffer, nameFrom, nameTo, name, 0, name.length);
    }

    /** The name of the tag or the attribute at hand. */
    byte[] nameBytes() {
        return Arrays.copyOfRange(buffer, nameFrom, nameTo);
    }

    /** Ends the end tag at hand, which must have this name. */
    void endTag(byte[] name) {
        Unusual.unless(isNamed(name));
        skipBlanks();
        Unusual.unless(buffer[at] == '>');
        at++;
    }

    /** Moves to the next attribute of the start tag at hand; false at the tag's end. */
    boolean nextAttribute() {
        int before = at;
        skipBlanks();
        isEmpty = buffer[at] == '/';
        if (isEmpty || buffer[at] == '>') {
            at += isEmpty ? 1 : 0;
            Unusual.unless(buffer[at] == '>');
            at++;
            return false;
        }
        Unusual.unless(at > before);
        name();
        skipBlanks();
        Unusual.unless(buffer[at] == '=');
        at++;
        skipBlanks();
        byte quote = buffer[at++];
        Unusual.unless(quote == '"' || quote == '\'');
        valueFrom = at;
        isPlain = true;
        for (byte c = buffer[at]; c != quote; c = buffer[++at]) {
            // Bytes beyond ASCII are negative.
            if (c < ' ' || c == '&' || c == '<') {
                Unusual.unless(c < 0 || c == '&' || c == '\n' || c == '\t');
                isPlain = false;
            }
        }
        valueTo = at++;
        Unusual.unless(valueTo - valueFrom <= LONGEST);
        return true;
    }

    /** Whether the start tag just left is an element without an end tag. */
    boolean isEmptyElement() {
        return isEmpty;
    }

    /** Whether there may be something inside the element whose start tag was just left, up to an end tag; {@code depth} is its own, from 1. */
    boolean hasContent(int depth) {
        Unusual.unless(isEmpty || depth < SceneFormat.DEEPEST);
        return !isEmpty;
    }

    /** Moves behind the element whose start tag was just left, which must be empty but for comments. */
    void noContent(byte[] element, int depth) throws IOException {
        if (hasContent(depth)) {
            Unusual.unless(!nextTag());
            endTag(element);
        }
    }

    /** The value of the attribute at hand. */
    String value() {
        if (isPlain) {
            return new String(buffer, valueFrom, valueTo - valueFrom, StandardCharsets.ISO_8859_1);
        }
        for (int i = valueFrom; i < valueTo; i++) {
            // The standard has each white space in an attribute read as a blank.
            buffer[i] = buffer[i] == '\n' || buffer[i] == '\t' ? (byte) ' ' : buffer[i];
        }
        return text(valueFrom, valueTo);
    }

    /** Whether the value of the attribute at hand starts as a word does, not a number. */
    boolean isWord() {
        int from = valueFrom;
        while (from < valueTo && isBlank(buffer[from])) {
            from++;
        }
        return from < valueTo && (isOfName(buffer[from]) || buffer[from] == '#') && buffer[from] != '-';
    }

    /** Reads the value of the attribute at hand as numbers; how many there are, at most as many as there is room for. */
    int numbers(double[] into) {
        int count = 0;
        int from = valueFrom;
        while (true) {
            while (from < valueTo && isBlank(buffer[from])) {
                from++;
            }
            if (from == valueTo) {
                return count;
            }
            int to = from;
            while (to < valueTo && !isBlank(buffer[to])) {
                to++;
            }
            Unusual.unless(count < into.length);
            into[count++] = decimals.read(buffer, from, to);
            from = to;
        }
    }

    /** The text within the element whose start tag was just left, up to its end tag. */
    String content() throws IOException {
        if (end - at < LONGEST) {
            fill();
        }
        int from = at;
        for (; buffer[at] != '<'; at++) {
            Unusual.unless(buffer[at] >= ' ' || buffer[at] < 0 || buffer[at] == '\n' || buffer[at] == '\t');
        }
        return text(from, at);
    }

    /** Makes sure that nothing follows but white space and comments. */
    void end() throws IOException {
        Unusual.unless(!isMoreLeft());
    }

    /** Moves behind white space and comments; whether anything is left there. */
    boolean isMoreLeft() throws IOException {
        while (at < end || !isAllRead) {
            fill();
            skipBlanks();
            if (at < end) {
                if (!startsWith("<!--")) {
                    return true;
                }
                at++;
                skipComment();
            }
        }
        return false;
    }

    private void name() {
        nameFrom = at;
        while (isOfName(buffer[at])) {
            at++;
        }
        nameTo = at;
    }

    static boolean isOfName(byte c) {
        return (c >= 'a' && c <= 'z') || c == '-' || (c >= 'A' && c <= 'Z');
    }

    static boolean isBlank(byte c) {
        return c == ' ' || c == '\n' || c == '\t' || c == '\r';
    }

    private void skipBlanks() {
        while (isBlank(buffer[at])) {
            at++;
        }
    }

    /** Skips the comment whose {@code <} was just read. */
    private void skipComment() {
        int from = at + 3;
        at = from;
        do {
            at = indexOf('-') + 1;
        } while (buffer[at] != '-');
        Unusual.unless(buffer[at + 1] == '>');
        String comment = decoded(from, at - 1);
        Unusual.unless(comment.chars().noneMatch(c -> c < ' ' && c != '\n' && c != '\t' && c != '\r'));
        at += 2;
    }

    private int indexOf(char wanted) {
        int i = at;
        while (buffer[i] != wanted) {
            Unusual.unless(i < end);
            i++;
        }
        return i;
    }

    private boolean startsWith(String text) {
        for (int i = 0; i < text.length(); i++) {
            if (buffer[at + i] != text.charAt(i)) {
                return false;
            }
        }
        return true;
    }

    private String text(int from, int to) {
        String text = decoded(from, to);
        Unusual.unless(!text.contains("]]>"));
        return text.indexOf('&') < 0 ? text : References.resolved(text);
    }

    /** UTF-8, none of it broken. */
    private String decoded(int from, int to) {
        try {
            String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(buffer, from, to - from)).toString();
            Unusual.unless(text.indexOf('\uFFFE') < 0 && text.indexOf('\uFFFF') < 0);
            return text;
        } catch (CharacterCodingException broken) {
            throw new Unusual();
        }
    }

    /** Moves what is left to the start of the buffer and fills the rest. */
    private void fill() throws IOException {
        if (!isAllRead) {
            System.arraycopy(buffer, at, buffer, 0, end - at);
            end -= at;
            dropped += at;
            at = 0;
            int read = input.readNBytes(buffer, end, BUFFER - end);
            isAllRead = read < BUFFER - end;
            end += read;
            buffer[end] = 0;
        }
    }
}
