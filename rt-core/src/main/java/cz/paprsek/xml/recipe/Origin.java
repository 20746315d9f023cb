package cz.paprsek.xml.recipe;

import cz.paprsek.xml.text.Places.Place;
import java.nio.charset.StandardCharsets;

/** The file that an element stands in. By identity. */
final class Origin {
    private final String file;
    private final byte[] text;

    /**
     * A file.
     *
     * @param file its name, for messages
     * @param text in UTF-8
     */
    Origin(String file, byte[] text) {
        this.file = file;
        this.text = text;
    }

    String file() {
        return file;
    }

    /** Line and column, both from 1, of what stands so many bytes behind the beginning. */
    Place place(int at) {
        int line = 1;
        int start = 0;
        for (int i = 0; i < at; i++) {
            if (text[i] == '\n' || (text[i] == '\r' && text[i + 1] != '\n')) {
                line++;
                start = i + 1;
            }
        }
        return new Place(line, 1 + characters(start, at));
    }

    /** How many bytes some characters of a value take that begins somewhere; a reference, such as that for a quote, is one character. */
    int bytes(int from, int characters) {
        int at = from;
        for (int left = characters; left > 0 && at < text.length; left--) {
            if (text[at] == '&') {
                while (text[at] != ';') {
                    at++;
                }
            }
            at++;
            // The other bytes of the same character.
            while (at < text.length && (text[at] & 0xc0) == 0x80) {
                at++;
            }
        }
        return at - from;
    }

    private int characters(int from, int to) {
        return new String(text, from, to - from, StandardCharsets.UTF_8).replace("\uFEFF", "").length();
    }
}
