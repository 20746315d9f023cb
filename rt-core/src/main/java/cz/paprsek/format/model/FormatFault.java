package cz.paprsek.format.model;

import cz.paprsek.io.PlainText;
import java.io.IOException;

/** What is wrong with a file of another program, in one line that begins with the place: {@code line 12: …}, {@code byte 84: …}. */
public final class FormatFault extends IOException {
    private static final long serialVersionUID = 1;
    private static final int SHOWN = 60;

    private FormatFault(String place, String sentence) {
        super(place + ": " + sentence);
    }

    /** @param line from 1 */
    public static FormatFault line(long line, String sentence) {
        return new FormatFault("line " + line, sentence);
    }

    /** @param offset how many bytes are before it */
    public static FormatFault at(long offset, String sentence) {
        return new FormatFault("byte " + offset, sentence);
    }

    /** Of a place that has a name of its own, such as {@code meshes[3].primitives[0]}. */
    public static FormatFault in(String place, String sentence) {
        return new FormatFault(place, sentence);
    }

    /** A piece of a stranger's text in quotes, as it can be shown. */
    public static String quoted(String text) {
        return '"' + PlainText.of(text, SHOWN) + '"';
    }
}
