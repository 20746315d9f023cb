package cz.paprsek.query;

import java.util.Arrays;
import java.util.Locale;

/** A pattern of {@code like}: % for any characters, _ for one, a backslash before one that means itself. Letter case is ignored. */
final class LikePattern {
    private static final int ANY = -1;
    private static final int ONE = -2;

    /** Code points, {@link #ANY} or {@link #ONE}. */
    private final int[] pattern;

    LikePattern(String text) {
        int[] letters = folded(text);
        int[] made = new int[letters.length];
        int size = 0;
        for (int i = 0; i < letters.length; i++) {
            if (letters[i] == '\\' && i + 1 < letters.length) {
                made[size++] = letters[++i];
            } else {
                made[size++] = letters[i] == '%' ? ANY : letters[i] == '_' ? ONE : letters[i];
            }
        }
        pattern = Arrays.copyOf(made, size);
    }

    /** Time grows with the length of the text times that of the pattern at most: of several %, only the last need be tried again. */
    boolean matches(String value) {
        int[] text = folded(value);
        int p = 0;
        int retryPattern = -1;
        int retryText = 0;
        for (int t = 0; t < text.length;) {
            if (p < pattern.length && pattern[p] == ANY) {
                retryPattern = ++p;
                retryText = t;
            } else if (p < pattern.length && (pattern[p] == ONE || pattern[p] == text[t])) {
                p++;
                t++;
            } else if (retryPattern >= 0) {
                p = retryPattern;
                t = ++retryText;
            } else {
                return false;
            }
        }
        while (p < pattern.length && pattern[p] == ANY) {
            p++;
        }
        return p == pattern.length;
    }

    private static int[] folded(String text) {
        return text.toLowerCase(Locale.ROOT).codePoints().toArray();
    }
}
