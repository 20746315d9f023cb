package cz.paprsek.format.obj;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Some whole lines of a file, of which those in plain words (vertices, normals, places in pictures, faces) are read without anything being made of them but numbers. All others
 * are left to be read word by word, and so is whatever may be wrong. Several threads may read a block: the first does, and the others wait for it.
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

    /** The forms of corners: {@code 7}, {@code 7/3}, {@code 7//2} and {@code 7/3/2}. */
    static final int HAS_MAP = 1;
    static final int HAS_NORMAL = 2;

    /** How many zeros stand behind the last line. */
    static final int PADDING = 8;

    private static final long EXACT = 1L << 53;
    private static final int LONGEST_INDEX = 9;
    private static final int EIGHT = 8;
    /** Of a fraction, that fit into a long with one more before it. */
    private static final int MOST_DIGITS = 17;
    private static final long TOO_MANY = Long.MAX_VALUE;
    private static final int HUGE = 100_000;
    private static final VarHandle WORDS = MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
    private static final long ZEROS = 0x3030303030303030L;
    private static final long SIXES = 0x0606060606060606L;
    private static final long HIGH_HALVES = 0xF0F0F0F0F0F0F0F0L;
    private static final long[] TENS = {1, 10, 100, 1000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000};
    private static final double[] POWERS = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

    /** Ends with a line end and as many zeros as are behind it as {@link #PADDING} says. */
    private final byte[] bytes;
    private final int length;
    private boolean isRead;
    private int lines;
    private int[] codes = new int[1 << 10];
    private int codeCount;
    private double[] numbers = new double[1 << 10];
    private int numberCount;
    private int at;
    /** What the digits say that were read last. */
    private long found;

    /** @param length without the zeros */
    Block(byte[] bytes, int length) {
        this.bytes = bytes;
        this.length = length;
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
            begin = afterEnd(endOf(begin));
        }
        return begin;
    }

    int endOf(int from) {
        int i = from;
        while (bytes[i] != '\n' && bytes[i] != '\r') {
            i++;
        }
        return i;
    }

    int afterEnd(int end) {
        return bytes[end] == '\r' && bytes[end + 1] == '\n' ? end + 2 : end + 1;
    }

    synchronized void read() {
        if (isRead) {
            return;
        }
        codeCount = 0;
        numberCount = 0;
        int line = 0;
        int nextFace = -1;
        int run = 0;
        int runAt = 0;
        for (int begin = 0; begin < length; begin = at) {
            at = begin;
            int code = codeAt(begin);
            if (code == FACES) {
                int first = codeCount;
                if (line != nextFace) {
                    code(FACES);
                    code(line);
                }
                run = 0;
                if (face()) {
                    nextFace = ++line;
                    continue;
                }
                codeCount = first;
            } else if (code < 0) {
                int kept = numberCount;
                if (numbers(code)) {
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
            int next = afterJoined(begin);
            if (bytes[begin] != '#' && bytes[begin] != '\n' && bytes[begin] != '\r') {
                code(OTHER);
                code(line);
                code(begin);
                code(next);
                run = 0;
            }
            line += ends(begin, next);
            nextFace = -1;
            at = next;
        }
        lines = line;
        isRead = true;
    }

    /** What a line says it is; 0 for none of the plain ones. */
    private int codeAt(int begin) {
        byte first = bytes[begin];
        byte second = bytes[begin + 1];
        if (first == 'f' && isBlank(second)) {
            at = begin + 1;
            return FACES;
        }
        if (first != 'v') {
            return 0;
        }
        at = begin + (isBlank(second) ? 1 : 2);
        return isBlank(second) ? VERTICES : !isBlank(bytes[at]) ? 0 : second == 'n' ? NORMALS : second == 't' ? MAP : 0;
    }

    private static boolean isBlank(byte b) {
        return b == ' ' || b == '\t';
    }

    /** Where the line after this one begins, which a backslash may have joined with others. */
    private int afterJoined(int begin) {
        int end = endOf(begin);
        while (end > begin && bytes[end - 1] == '\\' && afterEnd(end) < length) {
            end = endOf(afterEnd(end));
        }
        return afterEnd(end);
    }

    private int ends(int from, int to) {
        int count = 0;
        for (int i = from; i < to; i = afterEnd(endOf(i))) {
            count++;
        }
        return count;
    }

    private void code(int code) {
        if (codeCount == codes.length) {
            codes = Arrays.copyOf(codes, 2 * codes.length);
        }
        codes[codeCount++] = code;
    }

    private boolean numbers(int code) {
        if (numberCount + 3 > numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * numbers.length);
        }
        if (!number() || !secondOf(code) || (code != MAP && !number())) {
            return false;
        }
        byte[] b = bytes;
        int i = at;
        while (b[i] != '\n' && b[i] != '\r') {
            if (b[i++] == '\\') {
                return false;
            }
        }
        at = afterEnd(i);
        return true;
    }

    /** Places in pictures may have one number only. */
    private boolean secondOf(int code) {
        return (code == MAP && isAtEnd()) ? zero() : number();
    }

    private boolean isAtEnd() {
        while (isBlank(bytes[at])) {
            at++;
        }
        return bytes[at] == '\n' || bytes[at] == '\r';
    }

    private boolean zero() {
        numbers[numberCount++] = 0;
        return true;
    }

    /** Reads digits, eight at once, and counts them. */
    private int digits() {
        int first = at;
        long value = 0;
        int count = EIGHT;
        while (count == EIGHT) {
            long word = (long) WORDS.get(bytes, at) ^ ZEROS;
            long others = (word | (word + SIXES)) & HIGH_HALVES;
            count = Long.numberOfTrailingZeros(others) >> 3;
            if (count > 0) {
                // The first digit is in the lowest byte, and so the highest of what is added up in pairs, in pairs of pairs, and in halves.
                long aligned = word << (64 - (count << 3));
                aligned = (aligned * 10 + (aligned >>> 8)) & 0x00FF00FF00FF00FFL;
                aligned = (aligned * 100 + (aligned >>> 16)) & 0x0000FFFF0000FFFFL;
                value = value * TENS[count] + ((aligned * 10000 + (aligned >>> 32)) & 0xFFFFFFFFL);
                at += count;
            }
        }
        found = value;
        return at - first;
    }

    private boolean number() {
        byte[] b = bytes;
        while (b[at] == ' ' || b[at] == '\t') {
            at++;
        }
        boolean isNegative = b[at] == '-';
        if (isNegative || b[at] == '+') {
            at++;
        }
        int first = at;
        int count = digits();
        long digits = found;
        int power = 0;
        if (b[at] == '.') {
            at++;
            int places = digits();
            digits = places <= EIGHT ? digits * TENS[places] + found : places <= MOST_DIGITS && count <= 1 ? digits * (long) POWERS[places] + found : TOO_MANY;
            power = -places;
            count += places;
        }
        if ((b[at] | 32) == 'e') {
            at++;
            boolean isSmall = b[at] == '-';
            if (isSmall || b[at] == '+') {
                at++;
            }
            int places = digits();
            count = places == 0 ? 0 : count;
            power = places > 4 ? HUGE : power + (int) (isSmall ? -found : found);
        }
        if (count == 0 || (b[at] != ' ' && b[at] != '\n' && b[at] != '\r' && b[at] != '\t')) {
            return false;
        }
        // Fifteen digits, and powers of ten up to 22, are exact, so that one division or product is rounded once.
        double value = count > MOST_DIGITS + 1 || digits > EXACT || power > 22 || power < -22 ? Double.parseDouble(new String(b, first, at - first, StandardCharsets.ISO_8859_1))
                : power < 0 ? digits / POWERS[-power] : digits * POWERS[power];
        numbers[numberCount++] = isNegative ? -value : value;
        return value <= Float.MAX_VALUE;
    }

    private boolean face() {
        byte[] b = bytes;
        int head = codeCount;
        code(0);
        int corners = 0;
        int form = 0;
        while (!isAtEnd()) {
            if (!index()) {
                return false;
            }
            int own = 0;
            if (b[at] == '/') {
                at++;
                if (b[at] != '/') {
                    own = HAS_MAP;
                    if (!index()) {
                        return false;
                    }
                }
                if (b[at] == '/') {
                    at++;
                    own |= HAS_NORMAL;
                    if (!index()) {
                        return false;
                    }
                }
            }
            if (corners++ > 0 && own != form) {
                return false;
            }
            form = own;
            if (b[at] != ' ' && b[at] != '\n' && b[at] != '\r' && b[at] != '\t') {
                return false;
            }
        }
        at = afterEnd(at);
        codes[head] = 4 * corners + form;
        return corners >= 3;
    }

    /** The number of a corner, which may be counted back from here. */
    private boolean index() {
        boolean isBack = bytes[at] == '-';
        if (isBack) {
            at++;
        }
        int count = digits();
        code((int) (isBack ? -found : found));
        return count > 0 && count <= LONGEST_INDEX;
    }
}
