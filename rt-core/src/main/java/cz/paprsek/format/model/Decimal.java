package cz.paprsek.format.model;

/** Scratch of a reader: a number such as most are, at most seven digits, a point and at most seven more. */
final class Decimal {
    /** Where the number ends that was read. */
    int end;

    /**
     * Reads one that a blank follows, or the end of the line; NaN if it is of another kind.
     *
     * @param limit where the line ends
     */
    double read(byte[] b, int from, int limit) {
        int at = from;
        boolean isNegative = b[at] == '-';
        at += isNegative ? 1 : 0;
        if (at + 2 * Digits.MOST > b.length) {
            return Double.NaN;
        }
        long word = Digits.word(b, at);
        int count = Digits.count(word);
        if (count == 0 || count == Digits.MOST) {
            return Double.NaN;
        }
        long digits = Digits.value(word, count);
        at += count;
        int places = 0;
        if (at < limit && b[at] == '.') {
            word = Digits.word(b, ++at);
            places = Digits.count(word);
            if (places == Digits.MOST) {
                return Double.NaN;
            }
            digits = places == 0 ? digits : Digits.followed(digits, word, places);
            at += places;
        }
        if (at > limit || (at < limit && b[at] != ' ' && b[at] != '\t' && b[at] != '\r')) {
            return Double.NaN;
        }
        end = at;
        double size = Digits.scaled(digits, -places);
        return isNegative ? -size : size;
    }
}
