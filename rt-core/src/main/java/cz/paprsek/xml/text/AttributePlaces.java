package cz.paprsek.xml.text;

import cz.paprsek.xml.text.Places.Place;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Where attributes stand in tags of which parsers tell no more than where they begin; of any text, also one that is no good. One way through it. */
public final class AttributePlaces {
    private static final int END = -1;

    private final Reader text;
    private final char[] piece = new char[1 << 13];
    private int at;
    private int end;
    private int line = 1;
    private int column = 1;
    /** Of the tag looked at last. */
    private Place tag = new Place(0, 0);
    private Map<String, Place> attributes = Map.of();

    /** @param file from its first byte on; it is read as far as it is asked for, and not closed */
    public AttributePlaces(InputStream file) throws IOException {
        BufferedInputStream bytes = new BufferedInputStream(file);
        bytes.mark(Encoding.BEGINNING);
        byte[] beginning = bytes.readNBytes(Encoding.BEGINNING);
        bytes.reset();
        text = new InputStreamReader(bytes, Encoding.charset(beginning));
        if (isAt('\uFEFF')) {
            at++;
        }
    }

    /**
     * The place of the first of some attributes that an element has; empty if it has none of them, or no tag begins there.
     *
     * @param start where its tag begins, not before what was asked for last
     */
    public Optional<Place> of(Place start, List<String> names) throws IOException {
        if (!start.equals(tag)) {
            tag = start;
            attributes = attributesOf(start);
        }
        return names.stream().filter(attributes::containsKey).findFirst().map(attributes::get);
    }

    private Map<String, Place> attributesOf(Place begin) throws IOException {
        Map<String, Place> found = new HashMap<>();
        while ((line < begin.line() || (line == begin.line() && column < begin.column())) && !isOver()) {
            next();
        }
        if (line != begin.line() || column != begin.column() || next() != '<') {
            return found;
        }
        word();
        for (skipBlanks(); !isAt('>') && !isAt('/') && !isOver(); skipBlanks()) {
            Place start = new Place(line, column);
            found.putIfAbsent(word(), start);
            skipBlanks();
            if (!isAt('=')) {
                return found;
            }
            next();
            skipBlanks();
            int quote = next();
            while (!isAt(quote) && !isOver()) {
                next();
            }
            next();
        }
        return found;
    }

    private String word() throws IOException {
        StringBuilder word = new StringBuilder();
        while (!isBlank() && !isAt('=') && !isAt('>') && !isAt('/') && !isOver()) {
            word.append((char) next());
        }
        return word.toString();
    }

    private void skipBlanks() throws IOException {
        while (isBlank()) {
            next();
        }
    }

    private boolean isBlank() throws IOException {
        return isAt(' ') || isAt('\n') || isAt('\t') || isAt('\r');
    }

    private boolean isOver() throws IOException {
        return isAt(END);
    }

    private boolean isAt(int wanted) throws IOException {
        return peek() == wanted;
    }

    private int peek() throws IOException {
        if (at == end) {
            at = 0;
            end = Math.max(0, text.read(piece, 0, piece.length));
        }
        return at < end ? piece[at] : END;
    }

    private int next() throws IOException {
        int character = peek();
        at += character == END ? 0 : 1;
        boolean endsLine = character == '\n' || (character == '\r' && !isAt('\n'));
        line += endsLine ? 1 : 0;
        column = endsLine ? 1 : column + 1;
        return character;
    }
}
