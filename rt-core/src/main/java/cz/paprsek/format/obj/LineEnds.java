package cz.paprsek.format.obj;

/** Where lines end, as on any system, in whole lines. */
final class LineEnds {
    private LineEnds() {}

    /** Where the line ends that some byte is in. */
    static int endOf(byte[] bytes, int from) {
        int i = from;
        while (bytes[i] != '\n' && bytes[i] != '\r') {
            i++;
        }
        return i;
    }

    /** Behind the end of a line. */
    static int after(byte[] bytes, int end) {
        return bytes[end] == '\r' && bytes[end + 1] == '\n' ? end + 2 : end + 1;
    }

    /** Where the next line begins. */
    static int next(byte[] bytes, int from) {
        return after(bytes, endOf(bytes, from));
    }

    /** Where the line after this one begins, which a backslash may have joined with others. */
    static int nextUnjoined(byte[] bytes, int begin, int length) {
        int end = endOf(bytes, begin);
        while (end > begin && bytes[end - 1] == '\\' && after(bytes, end) < length) {
            end = endOf(bytes, after(bytes, end));
        }
        return after(bytes, end);
    }

    /** How many lines there are between two beginnings of lines. */
    static int count(byte[] bytes, int from, int to) {
        int count = 0;
        for (int i = from; i < to; i = next(bytes, i)) {
            count++;
        }
        return count;
    }
}
