package cz.paprsek.xml;

/** Text out of a stranger's file made fit for one line of a terminal. */
final class PlainText {
    private static final int LONGEST = 60;

    private PlainText() {}

    /** The text without anything that a terminal would obey, and not too long. */
    static String text(String raw) {
        return text(raw, LONGEST);
    }

    /** As {@link #text}, for a whole sentence. */
    static String line(String raw) {
        return text(raw, 4 * LONGEST);
    }

    private static String text(String raw, int longest) {
        StringBuilder safe = new StringBuilder();
        raw.codePoints().limit(longest).forEach(c -> {
            int type = Character.getType(c);
            boolean plain = type != Character.CONTROL && type != Character.FORMAT && type != Character.SURROGATE
                    && type != Character.LINE_SEPARATOR && type != Character.PARAGRAPH_SEPARATOR;
            if (plain) {
                safe.appendCodePoint(c);
            } else {
                safe.append(String.format("\\u%04x", c));
            }
        });
        return raw.codePointCount(0, raw.length()) > longest ? safe + "…" : safe.toString();
    }
}
