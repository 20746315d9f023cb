package cz.paprsek.format.model;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;

/**
 * A stranger's text, line by line and word by word, without making strings of it. Line ends are those of any system; texts are UTF-8 or, where that makes no
 * sense, Latin-1, or UTF-16 if they begin as such. Words are separated by blanks.
 */
public final class TextLines {
    private static final int BUFFER = 1 << 16;
    private static final int LONGEST_LINE = 1 << 24;

    private final InputStream input;
    private final boolean areJoined;
    private byte[] buffer = new byte[BUFFER];
    /** Where the line begins, which word of it is looked at, where it ends, and where the next one begins. */
    private int start;
    private int wordStart;
    private int wordEnd;
    private int lineEnd;
    private int next;
    private int filled;
    private boolean isAfterReturn;
    /** Whether the last line has no line end, and what is missing is missing there. */
    private boolean isOpen;
    private long line;
    private long ended;
    private final Decimal decimal = new Decimal();

    /** @param areJoined whether a backslash at the end of a line joins it to the next */
    public TextLines(InputStream input, boolean areJoined) throws IOException {
        this.input = Transcoded.utf8(input);
        this.areJoined = areJoined;
    }

    /** Lines, joined by backslashes, that somebody else finds. */
    public static TextLines ofOthers() {
        return new TextLines();
    }

    private TextLines() {
        this.input = InputStream.nullInputStream();
        this.areJoined = true;
    }

    /** Goes to some whole lines, which are changed where they are joined: the next is the first of them. */
    public void lookAt(byte[] bytes, long linesBefore) {
        buffer = bytes;
        start = 0;
        next = 0;
        filled = bytes.length;
        isAfterReturn = false;
        isOpen = false;
        ended = linesBefore;
    }

    /** Says how many lines were read before, by somebody else. */
    public TextLines after(long lines) {
        ended = lines;
        return this;
    }

    /** Goes to the next line, which may be empty; false if there is none. */
    public boolean next() throws IOException {
        start = next;
        line = ended + 1;
        int scan = next;
        while (true) {
            if (scan == filled) {
                int shift = start;
                boolean isMore = refill();
                scan -= shift;
                if (!isMore) {
                    return lastLine(scan);
                }
            }
            byte b = buffer[scan];
            if (isAfterReturn) {
                isAfterReturn = false;
                if (b == '\n') {
                    scan = afterLineFeed(scan);
                    continue;
                }
            }
            if (b > '\r' || b < '\n') {
                // The usual byte, of which there are millions.
                byte[] bytes = buffer;
                int end = filled;
                while (scan + Digits.MOST <= end && Digits.areWithinLine(bytes, scan)) {
                    scan += Digits.MOST;
                }
                while (scan < end && ((bytes[scan] - '\n') & 0xFF) > 3) {
                    scan++;
                }
            } else if (b == '\n' || b == '\r') {
                ended++;
                isAfterReturn = b == '\r';
                if (areJoined && scan > start && buffer[scan - 1] == '\\') {
                    buffer[scan - 1] = ' ';
                    buffer[scan++] = ' ';
                    continue;
                }
                begin(scan, scan + 1);
                return true;
            } else {
                scan++;
            }
        }
    }

    /** The second half of a line end: before the line it is skipped, within one that was joined it is a blank. */
    private int afterLineFeed(int at) {
        if (at == start) {
            start = at + 1;
        } else {
            buffer[at] = ' ';
        }
        return at + 1;
    }

    private boolean lastLine(int end) {
        begin(end, end);
        boolean isLine = end > start;
        if (!isLine && isOpen) {
            line = ended;
        }
        ended += isLine ? 1 : 0;
        isOpen |= isLine;
        return isLine;
    }

    private void begin(int end, int after) {
        lineEnd = end;
        next = after;
        wordStart = start;
        wordEnd = start;
    }

    /** Gets more bytes behind the beginning of the line, which goes to the front; false if there are none. */
    private boolean refill() throws IOException {
        System.arraycopy(buffer, start, buffer, 0, filled - start);
        filled -= start;
        start = 0;
        if (filled == buffer.length) {
            if (filled >= LONGEST_LINE) {
                throw fault("this line is longer than " + LONGEST_LINE + " bytes");
            }
            buffer = Arrays.copyOf(buffer, 2 * filled);
        }
        int more = input.read(buffer, filled, buffer.length - filled);
        filled += Math.max(0, more);
        return more > 0;
    }

    /** Goes to the next word of the line; false if there is none. */
    public boolean word() {
        int at = behindBlanks();
        wordStart = at;
        wordEnd = endOfWord(at);
        return wordEnd > at;
    }

    /** Goes to the next word of the line or of one of those after it; false if there is none. */
    public boolean wordAnywhere() throws IOException {
        while (!word()) {
            if (!next()) {
                return false;
            }
        }
        return true;
    }

    private static boolean isBlank(byte b) {
        return b <= ' ' && (b == ' ' || b == '\t' || b == '\f' || b == 0x0B || b == '\r');
    }

    /** Whether this is the word that is looked at, in any case. */
    public boolean is(String lowerCase) {
        if (wordEnd - wordStart != lowerCase.length()) {
            return false;
        }
        for (int i = 0; i < lowerCase.length(); i++) {
            byte b = buffer[wordStart + i];
            if ((b >= 'A' && b <= 'Z' ? b + 32 : b) != lowerCase.charAt(i)) {
                return false;
            }
        }
        return true;
    }

    /** The first letter of the word, or 0 if there is none. */
    public int letter(int index) {
        return wordStart + index < wordEnd ? buffer[wordStart + index] & 0xFF : 0;
    }

    public String text() {
        return text(wordStart, wordEnd);
    }

    /** What is after the word to the end of the line, without blanks around it. */
    public String rest() {
        return text(wordEnd, lineEnd).strip();
    }

    private String text(int from, int to) {
        return Transcoded.decoded(buffer, from, to);
    }

    /** The next word of the line as a finite decimal number. */
    public double nextNumber(String what) throws IOException {
        int at = behindBlanks();
        if (at == lineEnd) {
            throw fault(what + " is missing");
        }
        return number(at, what);
    }

    /** The word as a finite decimal number. */
    public double number(String what) throws IOException {
        return number(wordStart, what);
    }

    private double number(int from, String what) throws IOException {
        wordStart = from;
        double usual = decimal.read(buffer, from, lineEnd);
        if (!Double.isNaN(usual)) {
            wordEnd = decimal.end;
            return usual;
        }
        byte[] bytes = buffer;
        int end = lineEnd;
        int at = from;
        byte first = bytes[at];
        if (first == '-' || first == '+') {
            at++;
        }
        int past = Digits.end(bytes, at, end);
        long digits = Digits.read(0, bytes, at, past);
        int read = past - at;
        int power = 0;
        at = past;
        if (at < end && bytes[at] == '.') {
            past = Digits.end(bytes, ++at, end);
            digits = Digits.read(digits, bytes, at, past);
            power = at - past;
            read -= power;
            at = past;
        }
        if (at < end && !isBlank(bytes[at])) {
            wordEnd = endOfWord(at);
            power += exponent(at, what);
        } else {
            wordEnd = at;
        }
        if (read == 0) {
            throw notANumber(what);
        }
        int least = first == '-' || first == '+' ? from + 1 : from;
        boolean fits = read <= Digits.FITTING || read - Digits.leadingZeros(bytes, least, wordEnd) <= Digits.FITTING;
        double rounded = fits ? Digits.rounded(digits, power) : Double.NaN;
        double value = Double.isNaN(rounded) ? parsed(what) : rounded;
        return first == '-' ? -Math.abs(value) : value;
    }

    private double parsed(String what) throws IOException {
        double value = Double.parseDouble(text().replace('d', 'e').replace('D', 'e'));
        if (Double.isInfinite(value)) {
            throw notANumber(what);
        }
        return value;
    }

    private int endOfWord(int from) {
        int at = from;
        while (at < lineEnd && !isBlank(buffer[at])) {
            at++;
        }
        return at;
    }

    /** Of the rest of a word, from its e on. */
    private int exponent(int from, String what) throws IOException {
        int at = from;
        int letter = buffer[at++] | 32;
        boolean isNegative = at < wordEnd && buffer[at] == '-';
        if (at < wordEnd && (buffer[at] == '-' || buffer[at] == '+')) {
            at++;
        }
        int first = at;
        int value = 0;
        for (; at < wordEnd && buffer[at] >= '0' && buffer[at] <= '9'; at++) {
            value = Math.min(100_000, value * 10 + buffer[at] - '0');
        }
        if ((letter != 'e' && letter != 'd') || at == first || at < wordEnd) {
            throw notANumber(what);
        }
        return isNegative ? -value : value;
    }

    /** The word as a whole number of at most ten digits. */
    public long whole(String what) throws IOException {
        int at = wordStart;
        byte sign = at < wordEnd ? buffer[at] : 0;
        at += sign == '-' || sign == '+' ? 1 : 0;
        long value = 0;
        int first = at;
        for (; at < wordEnd && buffer[at] >= '0' && buffer[at] <= '9' && at - first < 11; at++) {
            value = value * 10 + buffer[at] - '0';
        }
        if (at < wordEnd || at == first) {
            throw fault(what + " must be a whole number, but is " + FormatFault.quoted(text()));
        }
        return sign == '-' ? -value : value;
    }

    /**
     * Reads a number within a word that goes to a slash, a blank or the end of the line.
     *
     * @return the number, of which more than ten digits count as ten; {@link Long#MIN_VALUE} if there is none, as between two slashes
     */
    public long slashed(String what) throws IOException {
        byte[] bytes = buffer;
        int end = lineEnd;
        int at = wordEnd;
        boolean isNegative = at < end && bytes[at] == '-';
        if (isNegative) {
            at++;
        }
        int first = at;
        long value = 0;
        int digit;
        while (at < end && (digit = bytes[at] - '0') >= 0 && digit <= 9) {
            value = at - first > 10 ? value : value * 10 + digit;
            at++;
        }
        if ((at < end && bytes[at] != '/' && !isBlank(bytes[at])) || (at == first && isNegative)) {
            throw fault(what + " must be a whole number, but is " + FormatFault.quoted(text(wordEnd, endOfWord(at))));
        }
        boolean isNone = at == first;
        wordEnd = at;
        return isNone ? Long.MIN_VALUE : isNegative ? -value : value;
    }

    /** Goes on behind a slash; false if there is none. */
    public boolean slash() {
        boolean isSlash = ahead(0) == '/';
        wordEnd += isSlash ? 1 : 0;
        return isSlash;
    }

    /** Whether there is another word in the line. */
    public boolean hasMore() {
        return behindBlanks() < lineEnd;
    }

    private int behindBlanks() {
        int at = wordEnd;
        while (at < lineEnd && isBlank(buffer[at])) {
            at++;
        }
        return at;
    }

    /** Goes to the beginning of the next word of the line, to read it piece by piece; false if there is none. */
    public boolean beginWord() {
        int at = behindBlanks();
        wordStart = at;
        wordEnd = at;
        return at < lineEnd;
    }

    /** A letter after what has been read of the line, or 0 if there is none. */
    public int ahead(int index) {
        return wordEnd + index < lineEnd ? buffer[wordEnd + index] & 0xFF : 0;
    }

    /** How many bytes the word has. */
    public int length() {
        return wordEnd - wordStart;
    }

    private FormatFault notANumber(String what) {
        return fault(what + " must be a number, but is " + FormatFault.quoted(text()));
    }

    /** The line that is looked at, from 1. */
    public long line() {
        return line;
    }

    /** What to throw if something is wrong in this line. */
    public FormatFault fault(String sentence) {
        return FormatFault.line(line, sentence);
    }
}
