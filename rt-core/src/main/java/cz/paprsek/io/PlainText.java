package cz.paprsek.io;

/** Text out of a stranger's file made fit for one line of a terminal. */
public final class PlainText {
    private PlainText() {}

    /** The text without anything that a terminal would obey, cut after so many characters. */
    public static String of(String raw, int longest) {
        StringBuilder safe = new StringBuilder();
        raw.codePoints().limit(longest).forEach(c -> {
            if (isPlain(c)) {
                safe.appendCodePoint(c);
            } else {
                safe.append(String.format("\\u%04x", c));
            }
        });
        return raw.codePointCount(0, raw.length()) > longest ? safe + "…" : safe.toString();
    }

    /** Whether a character only shows itself: no control code, no change of direction, no line break. */
    public static boolean isPlain(int codePoint) {
        return switch (Character.getType(codePoint)) {
            case Character.CONTROL, Character.FORMAT, Character.SURROGATE, Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR,
                    Character.UNASSIGNED, Character.PRIVATE_USE -> false;
            default -> true;
        };
    }
}
