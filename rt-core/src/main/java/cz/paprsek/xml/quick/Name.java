package cz.paprsek.xml.quick;

import java.nio.charset.StandardCharsets;

/** The name of an element or attribute as the bytes that files have. */
final class Name {
    private final byte[] ascii;

    Name(String text) {
        ascii = text.getBytes(StandardCharsets.US_ASCII);
    }

    boolean isAtHand(Markup markup) {
        return markup.isNamed(ascii);
    }

    void end(Markup markup) {
        markup.endTag(ascii);
    }
}
