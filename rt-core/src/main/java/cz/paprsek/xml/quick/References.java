package cz.paprsek.xml.quick;

import cz.paprsek.xml.format.SceneFormat;
import java.util.Map;

/** The references that XML has without any declaration: for signs such as {@code <}, and characters by number. */
final class References {
    private static final Map<String, String> NAMED = Map.of("lt", "<", "gt", ">", "amp", "&", "quot", "\"", "apos", "'");
    private static final int LONGEST = 10;

    private References() {}

    /**
     * The text with every reference replaced by what it stands for.
     *
     * @throws Unusual if there is another kind of reference, or a character that XML does not have
     */
    static String resolved(String text) {
        StringBuilder resolved = new StringBuilder(text.length());
        int at = 0;
        for (int start = text.indexOf('&'); start >= 0; start = text.indexOf('&', at)) {
            int end = text.indexOf(';', start);
            if (end < 0 || end - start > LONGEST) {
                throw new Unusual();
            }
            resolved.append(text, at, start).append(meaning(text.substring(start + 1, end)));
            at = end + 1;
        }
        return resolved.append(text, at, text.length()).toString();
    }

    private static String meaning(String reference) {
        String named = NAMED.get(reference);
        if (named != null) {
            return named;
        }
        String digits = reference.startsWith("#x") ? reference.substring(2) : reference.startsWith("#") ? reference.substring(1) : "";
        int radix = reference.startsWith("#x") ? 16 : 10;
        if (digits.isEmpty() || !digits.chars().allMatch(c -> c < 128 && Character.digit(c, radix) >= 0)) {
            throw new Unusual();
        }
        int character = Integer.parseInt(digits, radix);
        if (!SceneFormat.isAllowed(character) && character != '\t' && character != '\r') {
            throw new Unusual();
        }
        return Character.toString(character);
    }
}
