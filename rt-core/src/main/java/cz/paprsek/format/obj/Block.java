package cz.paprsek.format.obj;

import cz.paprsek.format.model.Digits;
import java.io.InterruptedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * Some whole lines of a file, of which those in plain words (vertices, normals, places in pictures, faces) are read without anything being made of them but numbers. All others
 * are left to be read word by word, and so is whatever may be wrong. Several threads may want to read a block: the first does.
 */
final class Block {
    /** What stands in the order of the lines: a code and what belongs to it, or a face: four times its number of corners and a form, and the numbers of its corners. */
    static final int VERTICES = -1;
    static final int NORMALS = -2;
    static final int MAP = -3;
    /** From which line of the block on there are faces, one in each. */
    static final int FACES = -4;
    /** A line to be read word by word: which it is, where it begins and where it ends. */
    static final int OTHER = -5;
    /** Vertices with colours: six numbers each. */
    static final int COLORED = -6;

    /** The forms of corners: {@code 7}, {@code 7/3}, {@code 7//2} and {@code 7/3/2}. */
    static final int HAS_MAP = 1;
    static final int HAS_NORMAL = 2;

    /** How many zeros stand behind the last line. */
    static final int PADDING = Digits.MOST;

    /** In place of where something ends: it is to be read word by word. */
    private static final int NONE = -1;

    /** Up to the length whole lines, behind which there are as many zeros as {@link #PADDING} says. */
    private byte[] bytes;
    private int length;
    private final AtomicBoolean isClaimed = new AtomicBoolean();
    private volatile boolean isRead;
    private boolean isWhole;
    private int lines;
    private int[] codes = new int[1 << 10];
    private int codeCount;
    private double[] numbers = new double[1 << 10];
    private int numberCount;

    Block(byte[] bytes) {
        this.bytes = bytes;
    }

    /** Takes other lines, which nobody has read yet. */
    void fill(byte[] with, int whole) {
        bytes = with;
        length = whole;
        isRead = false;
        isClaimed.set(false);
    }

    boolean isRead() {
        return isRead;
    }

    byte[] bytes() {
        return bytes;
    }

    int lines() {
        return lines;
    }

    int[] codes() {
        return codes;
    }

    int codeCount() {
        return codeCount;
    }

    /** Of vertices, normals and places in pictures, as they come. */
    double[] numbers() {
        return numbers;
    }

    /** Where a line begins. */
    int beginOf(int line) {
        int begin = 0;
        for (int i = 0; i < line; i++) {
            begin = LineEnds.next(bytes, begin);
        }
        return begin;
    }

    /** Reads it, unless another thread does, or has done so; false then. */
    boolean readUnlessClaimed() {
        if (!isClaimed.compareAndSet(false, true)) {
            return false;
        }
        isWhole = false;
        try {
            readLines();
            isWhole = true;
        } finally {
            synchronized (this) {
                isRead = true;
                notifyAll();
            }
        }
        return true;
    }

    /** Until another thread has read it; what that failed at, this one is to fail at. */
    void await() throws InterruptedIOException {
        synchronized (this) {
            while (!isRead) {
                try {
                    wait();
                } catch (InterruptedException interrupted) {
                    Thread.currentThread().interrupt();
                    throw new InterruptedIOException("interrupted");
                }
            }
        }
        if (!isWhole) {
            readLines();
        }
    }

    private void readLines() {
        codeCount = 0;
        numberCount = 0;
        int line = 0;
        int nextFace = -1;
        int run = 0;
        int runAt = 0;
        int next;
        for (int begin = 0; begin < length; begin = next) {
            byte first = bytes[begin];
            byte second = bytes[begin + 1];
            if (first == 'f' && isBlank(second)) {
                int before = codeCount;
                if (line != nextFace) {
                    code(FACES);
                    code(line);
                }
                run = 0;
                next = face(begin + 2);
                if (next > 0) {
                    nextFace = ++line;
                    continue;
                }
                codeCount = before;
            } else if (first == 'v') {
                int kept = numberCount;
                next = isBlank(second) ? vertex(begin + 2) : !isBlank(bytes[begin + 2]) ? NONE : second == 'n' ? three(begin + 3) : second == 't' ? two(begin + 3) : NONE;
                if (next > 0) {
                    int code = second == 'n' ? NORMALS : second == 't' ? MAP : numberCount - kept > 3 ? COLORED : VERTICES;
                    if (code != run) {
                        code(code);
                        runAt = codeCount;
                        code(0);
                        run = code;
                    }
                    codes[runAt]++;
                    line++;
                    continue;
                }
                numberCount = kept;
            }
            next = LineEnds.nextUnjoined(bytes, begin, length);
            if (first != '#' && first != '\n' && first != '\r') {
                code(OTHER);
                code(line);
                code(begin);
                code(next);
                run = 0;
            }
            line += LineEnds.count(bytes, begin, next);
            nextFace = -1;
        }
        lines = line;
    }

    private static boolean isBlank(byte b) {
        return b == ' ' || b == '\t';
    }

    private void code(int code) {
        if (codeCount == codes.length) {
            codes = Arrays.copyOf(codes, 2 * codes.length);
        }
        codes[codeCount++] = code;
    }

    /** Where the line after one of three numbers or six begins; none if it is to be read word by word, as in all that follows. */
    private int vertex(int from) {
        int at = number(number(number(from)));
        if (at == NONE || isEnd(at)) {
            return at == NONE ? NONE : LineEnds.after(bytes, blanks(at));
        }
        at = number(number(number(at)));
        return at != NONE && isEnd(at) ? LineEnds.after(bytes, blanks(at)) : NONE;
    }

    private int three(int from) {
        return afterRest(number(number(number(from))));
    }

    /** Places in pictures may have one number only. */
    private int two(int from) {
        int at = number(from);
        if (at != NONE && isEnd(at)) {
            put(0);
            return LineEnds.after(bytes, blanks(at));
        }
        return afterRest(number(at));
    }

    private int blanks(int from) {
        int at = from;
        while (isBlank(bytes[at])) {
            at++;
        }
        return at;
    }

    private boolean isEnd(int from) {
        byte b = bytes[blanks(from)];
        return b == '\n' || b == '\r';
    }

    /** Passes over what else is in the line; none if that goes on in the next. */
    private int afterRest(int from) {
        if (from == NONE) {
            return NONE;
        }
        byte[] b = bytes;
        int i = from;
        while (b[i] != '\n' && b[i] != '\r') {
            if (b[i++] == '\\') {
                return NONE;
            }
        }
        return LineEnds.after(bytes, i);
    }

    private void put(double value) {
        if (numberCount == numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * numbers.length);
        }
        numbers[numberCount++] = value;
    }

    /** Reads a number such as most are: some digits, a point, up to eight more. Where it ends; all others go another way. */
    private int number(int from) {
        if (from == NONE) {
            return NONE;
        }
        byte[] b = bytes;
        int first = from;
        while (b[first] == ' ' || b[first] == '\t') {
            first++;
        }
        int i = b[first] == '-' ? first + 1 : first;
        int whole = 0;
        int begin = i;
        for (int digit = b[i] - '0'; digit >= 0 && digit <= 9; digit = b[i] - '0') {
            whole = whole * 10 + digit;
            i++;
        }
        if (b[i] != '.' || i - begin > Digits.MOST || i == begin) {
            return unusual(first);
        }
        long word = Digits.word(b, i + 1);
        int places = Digits.count(word);
        if (places == 0) {
            return unusual(first);
        }
        long all = Digits.followed(whole, word, places);
        i += 1 + places;
        for (int more = places; more == Digits.MOST;) {
            word = Digits.word(b, i);
            more = Digits.count(word);
            if (more > 0) {
                all = Digits.followed(all, word, more);
                places += more;
                i += more;
            }
        }
        byte after = b[i];
        int digits = whole == 0 ? places : i - 1 - begin;
        if (digits > Digits.FITTING || (after != ' ' && after != '\n' && after != '\r' && after != '\t')) {
            return unusual(first);
        }
        double size = Digits.rounded(all, -places);
        if (Double.isNaN(size)) {
            return unusual(first);
        }
        put(b[first] == '-' ? -size : size);
        return i;
    }

    /** Any number at all. */
    private int unusual(int first) {
        byte[] b = bytes;
        int i = b[first] == '-' || b[first] == '+' ? first + 1 : first;
        int begin = i;
        long digits = 0;
        int count = 0;
        int significant = 0;
        int power = 0;
        boolean isFraction = false;
        for (; (b[i] >= '0' && b[i] <= '9') || (b[i] == '.' && !isFraction); i++) {
            if (b[i] == '.') {
                isFraction = true;
            } else {
                digits = digits * 10 + b[i] - '0';
                count++;
                significant += digits == 0 ? 0 : 1;
                power -= isFraction ? 1 : 0;
            }
        }
        if (count > 0 && (b[i] | 32) == 'e') {
            i++;
            boolean isSmall = b[i] == '-';
            i += isSmall || b[i] == '+' ? 1 : 0;
            int places = Digits.count(Digits.word(b, i));
            if (places == 0 || places == Digits.MOST) {
                return NONE;
            }
            int exponent = (int) Digits.value(Digits.word(b, i), places);
            power += isSmall ? -exponent : exponent;
            i += places;
        }
        if (count == 0 || (b[i] != ' ' && b[i] != '\n' && b[i] != '\r' && b[i] != '\t')) {
            return NONE;
        }
        double rounded = significant <= Digits.FITTING ? Digits.rounded(digits, power) : Double.NaN;
        double size = !Double.isNaN(rounded) ? rounded
                : Double.parseDouble(new String(b, begin, i - begin, StandardCharsets.ISO_8859_1));
        put(b[first] == '-' ? -size : size);
        return size <= Float.MAX_VALUE ? i : NONE;
    }

    private int face(int from) {
        byte[] b = bytes;
        int head = codeCount;
        code(0);
        int corners = 0;
        int form = 0;
        int at = blanks(from);
        while (b[at] != '\n' && b[at] != '\r') {
            at = index(at);
            int own = 0;
            if (at != NONE && b[at] == '/') {
                at++;
                if (b[at] != '/') {
                    own = HAS_MAP;
                    at = index(at);
                }
                if (at != NONE && b[at] == '/') {
                    own |= HAS_NORMAL;
                    at = index(at + 1);
                }
            }
            if (at == NONE || (corners++ > 0 && own != form)) {
                return NONE;
            }
            form = own;
            if (b[at] == ' ' || b[at] == '\t') {
                at = blanks(at);
            } else if (b[at] != '\n' && b[at] != '\r') {
                return NONE;
            }
        }
        codes[head] = 4 * corners + form;
        return corners < 3 ? NONE : LineEnds.after(bytes, at);
    }

    /** The number of a corner, which may be counted back from here. */
    private int index(int from) {
        byte[] b = bytes;
        boolean isBack = b[from] == '-';
        int first = isBack ? from + 1 : from;
        long word = Digits.word(b, first);
        int count = Digits.count(word);
        if (count == 0) {
            return NONE;
        }
        long found = Digits.value(word, count);
        int i = first + count;
        if (count == Digits.MOST && b[i] >= '0' && b[i] <= '9') {
            found = found * 10 + b[i++] - '0';
        }
        code((int) (isBack ? -found : found));
        return count == Digits.MOST && b[i] >= '0' && b[i] <= '9' ? NONE : i;
    }
}
