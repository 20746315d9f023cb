package cz.paprsek.xml.recipe;

/** Values as they stand in a file, and what they stand for. */
final class Raw {
    private Raw() {}

    /** The text of a value: references are what they stand for, line breaks and tabs blanks, as parsers have it. */
    static String text(String raw) {
        StringBuilder text = new StringBuilder();
        for (int at = 0; at < raw.length(); at++) {
            char c = raw.charAt(at);
            int end = c == '&' ? raw.indexOf(';', at) : -1;
            if (end > 0) {
                text.append(reference(raw.substring(at + 1, end)));
                at = end;
            } else {
                text.append(c == '\n' || c == '\t' || c == '\r' ? ' ' : c);
            }
        }
        return text.toString();
    }

    private static String reference(String name) {
        return switch (name) {
            case "lt" -> "<";
            case "gt" -> ">";
            case "amp" -> "&";
            case "quot" -> "\"";
            case "apos" -> "'";
            default -> Character.toString(name.startsWith("#x") ? Integer.parseInt(name.substring(2), 16) : Integer.parseInt(name.substring(1)));
        };
    }

    /** A text as it may stand between double quotes. */
    static String of(String text) {
        StringBuilder raw = new StringBuilder();
        text.codePoints().forEach(c -> {
            switch (c) {
                case '<' -> raw.append("&lt;");
                case '&' -> raw.append("&amp;");
                case '"' -> raw.append("&quot;");
                case '\n', '\r', '\t' -> raw.append("&#").append(c).append(';');
                default -> raw.appendCodePoint(c);
            }
        });
        return raw.toString();
    }
}
