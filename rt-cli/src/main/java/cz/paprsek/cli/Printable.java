package cz.paprsek.cli;

/** Text made fit for a terminal: names come from strangers' files, and a terminal obeys what it is shown. */
final class Printable {
    private Printable() {}

    /** The text in one line, with everything that a terminal would obey, or that turns the direction of reading, written as a code. */
    static String line(String raw) {
        if (raw.codePoints().allMatch(Printable::isPlain)) {
            return raw;
        }
        StringBuilder safe = new StringBuilder();
        raw.codePoints().forEach(c -> {
            if (isPlain(c)) {
                safe.appendCodePoint(c);
            } else {
                safe.append(String.format("\\u%04x", c));
            }
        });
        return safe.toString();
    }

    private static boolean isPlain(int codePoint) {
        return switch (Character.getType(codePoint)) {
            case Character.CONTROL, Character.FORMAT, Character.SURROGATE, Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR -> false;
            default -> true;
        };
    }
}
