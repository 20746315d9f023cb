package cz.paprsek.xml.mistake;

import java.util.Locale;
import java.util.Optional;

/** Characters that look right in a number, as word processors and web pages put them there, and are none that a number has. */
final class LookAlikes {
    private static final String QUOTE = "remove it, the straight quotes are enough";

    private LookAlikes() {}

    /** The first of them in a value, and what to do about it; empty if there is none. */
    static Optional<String> in(String value) {
        return value.codePoints().filter(c -> c > '~' && !advice(c).isEmpty()).boxed().findFirst()
                .map(c -> String.format("U+%04X (%s); ", c, String.valueOf(Character.getName(c)).toLowerCase(Locale.ROOT)) + advice(c));
    }

    private static String advice(int c) {
        return switch (Character.getType(c)) {
            case Character.SPACE_SEPARATOR, Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR, Character.CONTROL -> "write an ordinary blank instead";
            case Character.FORMAT, Character.NON_SPACING_MARK -> "remove it, nobody sees it";
            case Character.INITIAL_QUOTE_PUNCTUATION, Character.FINAL_QUOTE_PUNCTUATION -> QUOTE;
            case Character.DASH_PUNCTUATION -> instead("-");
            case Character.DECIMAL_DIGIT_NUMBER -> instead(String.valueOf(Character.digit(c, 10)));
            default -> switch (c) {
                case 0x2212 -> instead("-");
                case 0xff0b, 0xfe62 -> instead("+");
                case 0xff0e, 0xfe52, 0x066b, 0x00b7, 0x22c5 -> instead(".");
                case 0x201a, 0x201e, 0x2032, 0x2033, 0xff02, 0xff07 -> QUOTE;
                default -> "";
            };
        };
    }

    private static String instead(String sign) {
        return "write \"" + sign + "\" instead";
    }
}
