package cz.paprsek.xml.typing;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/** The tags, attributes and comments of a text that may be unfinished or broken, as far as they can be told. All places count characters from 0. Immutable. */
public final class LooseMarkup {
    /** What a piece of the text is. */
    public enum Kind { TAG, ATTRIBUTE, VALUE, COMMENT }

    /** A piece of the text that is of a kind; what is between tags is of none. */
    public record Piece(Kind kind, int from, int to) {}

    /**
     * An element.
     *
     * @param from where its start tag begins
     * @param to behind its end tag; where the text ends if it has none yet
     */
    public record Span(String name, int from, int to) {}

    /** What the text breaks off in. */
    enum Place { CONTENT, NAME, END_TAG, ATTRIBUTE, VALUE, ELSEWHERE }

    private final String text;
    private final List<Piece> pieces = new ArrayList<>();
    private final List<Span> spans = new ArrayList<>();
    private final Deque<Open> open = new ArrayDeque<>();
    private Place place = Place.CONTENT;
    /** Where what the text breaks off in begins. */
    private int begin;
    private String tag = "";
    private String attribute = "";
    private final List<String> given = new ArrayList<>();

    private record Open(String name, int from) {}

    private LooseMarkup(String text) {
        this.text = text;
        int at = 0;
        while (at >= 0 && at < text.length()) {
            int tag = text.indexOf('<', at);
            at = tag < 0 ? -1 : piece(tag);
        }
        begin = place == Place.CONTENT ? text.length() : begin;
        open.forEach(one -> spans.add(new Span(one.name(), one.from(), text.length())));
    }

    public static LooseMarkup of(String text) {
        return new LooseMarkup(Objects.requireNonNull(text, "text"));
    }

    /** In the order of the text. */
    public List<Piece> pieces() {
        return List.copyOf(pieces);
    }

    /** All elements, in no order. */
    public List<Span> spans() {
        return List.copyOf(spans);
    }

    Place place() {
        return place;
    }

    int begin() {
        return begin;
    }

    /** The element whose start tag the text breaks off in. */
    String tag() {
        return tag;
    }

    /** The attribute whose value the text breaks off in. */
    String attribute() {
        return attribute;
    }

    /** The attributes that the unfinished tag has. */
    List<String> given() {
        return List.copyOf(given);
    }

    /** The elements that are not closed, outermost first. */
    List<String> around() {
        List<String> names = new ArrayList<>();
        open.descendingIterator().forEachRemaining(one -> names.add(one.name()));
        return names;
    }

    /** Takes in what begins at a {@code <}; −1 if the text breaks off in it. */
    private int piece(int at) {
        if (text.startsWith("<!--", at)) {
            return passed(at, "-->", Optional.of(Kind.COMMENT));
        }
        if (text.startsWith("<![CDATA[", at)) {
            return passed(at, "]]>", Optional.empty());
        }
        if (text.startsWith("<?", at)) {
            return passed(at, "?>", Optional.of(Kind.COMMENT));
        }
        return text.startsWith("</", at) ? endTag(at) : startTag(at);
    }

    private int passed(int at, String end, Optional<Kind> kind) {
        int found = text.indexOf(end, at + 2);
        int to = found < 0 ? text.length() : found + end.length();
        kind.ifPresent(known -> pieces.add(new Piece(known, at, to)));
        return found < 0 ? broken(Place.ELSEWHERE, at) : to;
    }

    private int broken(Place where, int from) {
        place = where;
        begin = from;
        return -1;
    }

    private int endTag(int at) {
        int name = word(at + 2);
        int end = blanks(name);
        if (end == text.length()) {
            pieces.add(new Piece(Kind.TAG, at, end));
            return broken(Place.END_TAG, at);
        }
        int to = text.charAt(end) == '>' ? end + 1 : name;
        pieces.add(new Piece(Kind.TAG, at, to));
        String closed = text.substring(at + 2, name);
        if (open.stream().anyMatch(one -> one.name().equals(closed))) {
            boolean isFound = false;
            while (!isFound) {
                Open one = open.pop();
                isFound = one.name().equals(closed);
                spans.add(new Span(one.name(), one.from(), isFound ? to : at));
            }
        }
        return to;
    }

    private int startTag(int from) {
        int at = word(from + 1);
        pieces.add(new Piece(Kind.TAG, from, at));
        tag = text.substring(from + 1, at);
        given.clear();
        if (at == text.length()) {
            return broken(Place.NAME, from);
        }
        while (true) {
            at = blanks(at);
            if (at == text.length()) {
                return broken(Place.ATTRIBUTE, at);
            }
            char c = text.charAt(at);
            if (c == '<') {
                // Somebody is writing the tag before this one.
                spans.add(new Span(tag, from, at));
                return at;
            }
            if (c == '>' || (c == '/' && at + 1 < text.length() && text.charAt(at + 1) == '>')) {
                return closed(from, at, c == '/');
            }
            at = c == '=' || c == '/' || c == '"' || c == '\'' ? at + 1 : attribute(at);
            if (at < 0) {
                return at;
            }
        }
    }

    private int closed(int from, int at, boolean isEmpty) {
        int to = at + (isEmpty ? 2 : 1);
        pieces.add(new Piece(Kind.TAG, at, to));
        if (isEmpty) {
            spans.add(new Span(tag, from, to));
        } else {
            open.push(new Open(tag, from));
        }
        return to;
    }

    private int attribute(int from) {
        int name = word(from);
        pieces.add(new Piece(Kind.ATTRIBUTE, from, name));
        if (name == text.length()) {
            return broken(Place.ATTRIBUTE, from);
        }
        attribute = text.substring(from, name);
        given.add(attribute);
        int at = blanks(name);
        if (at == text.length() || text.charAt(at) != '=') {
            return at;
        }
        at = blanks(at + 1);
        if (at == text.length() || (text.charAt(at) != '"' && text.charAt(at) != '\'')) {
            return at;
        }
        int close = text.indexOf(text.charAt(at), at + 1);
        int tagBefore = text.indexOf('<', at + 1);
        int to = close < 0 ? text.length() : close + 1;
        if (tagBefore >= 0 && tagBefore < to) {
            pieces.add(new Piece(Kind.VALUE, at, tagBefore));
            return tagBefore;
        }
        pieces.add(new Piece(Kind.VALUE, at, to));
        return close < 0 ? broken(Place.VALUE, at + 1) : to;
    }

    private int word(int from) {
        int at = from;
        while (at < text.length() && !Character.isWhitespace(text.charAt(at)) && "<>/=\"'".indexOf(text.charAt(at)) < 0) {
            at++;
        }
        return Math.min(text.length(), at);
    }

    private int blanks(int from) {
        int at = from;
        while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
            at++;
        }
        return at;
    }
}
