package cz.paprsek.fx.view.xml;

import cz.paprsek.fx.model.typing.Page;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.xml.Problem;
import cz.paprsek.xml.typing.LooseMarkup;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.fxmisc.richtext.model.StyleSpans;
import org.fxmisc.richtext.model.StyleSpansBuilder;

/** Which pieces of the text look how: by what they are, what is selected, and what is wrong. */
final class XmlStyles {
    /** The problems of the text itself, rather than of a file that it includes, have this for a file. */
    static final String OWN = "text";

    private XmlStyles() {}

    /** A piece of the text. */
    record Piece(int from, int to) {}

    static StyleSpans<Collection<String>> of(Page page, Collection<ScenePath> selection) {
        String text = page.text();
        StyleSpans<Collection<String>> kinds = spans(text, LooseMarkup.of(text).pieces().stream()
                .map(piece -> new Styled("xml-" + piece.kind().name().toLowerCase(Locale.ROOT), piece.from(), piece.to())));
        StyleSpans<Collection<String>> selected = spans(text, selection.stream().flatMap(place -> page.of(place).stream())
                .map(stand -> new Styled("xml-selected", stand.from(), stand.to())));
        StyleSpans<Collection<String>> wrong = spans(text, page.problems().stream().flatMap(problem -> piece(text, problem).stream())
                .map(piece -> new Styled("xml-mistake", piece.from(), piece.to())));
        return kinds.overlay(selected, XmlStyles::both).overlay(wrong, XmlStyles::both);
    }

    private record Styled(String style, int from, int to) {}

    private static Collection<String> both(Collection<String> one, Collection<String> other) {
        if (other.isEmpty()) {
            return one;
        }
        List<String> both = new ArrayList<>(one);
        both.addAll(other);
        return both;
    }

    private static StyleSpans<Collection<String>> spans(String text, Stream<Styled> styled) {
        StyleSpansBuilder<Collection<String>> spans = new StyleSpansBuilder<>();
        int at = 0;
        for (Styled one : (Iterable<Styled>) styled.sorted(Comparator.comparingInt(Styled::from))::iterator) {
            int from = Math.max(at, Math.min(one.from(), text.length()));
            int to = Math.max(from, Math.min(one.to(), text.length()));
            spans.add(List.of(), from - at);
            spans.add(List.of(one.style()), to - from);
            at = to;
        }
        return spans.add(List.of(), text.length() - at).create();
    }

    /** What a problem is about: the attribute or the tag that begins where it is said to be; empty if it is in another file. */
    static Optional<Piece> piece(String text, Problem problem) {
        if (!problem.file().equals(OWN)) {
            return Optional.empty();
        }
        int at = 0;
        for (int line = 1; line < problem.line(); line++) {
            int end = text.indexOf('\n', at);
            if (end < 0) {
                break;
            }
            at = end + 1;
        }
        int lineEnd = text.indexOf('\n', at) < 0 ? text.length() : text.indexOf('\n', at);
        int from = Math.max(0, Math.min(at + problem.column() - 1, lineEnd));
        int to = from;
        boolean isQuoted = false;
        while (to < lineEnd && (isQuoted || (!Character.isWhitespace(text.charAt(to)) && text.charAt(to) != '>'))) {
            isQuoted ^= text.charAt(to) == '"';
            to++;
        }
        return Optional.of(to > from ? new Piece(from, to) : new Piece(Math.max(at, Math.min(from, lineEnd) - 1), Math.max(Math.min(lineEnd, from + 1), Math.min(text.length(), at + 1))));
    }
}
