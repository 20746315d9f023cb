package cz.paprsek.fx.view.manual;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Words of one kind within a line.
 *
 * @param link where they lead, or a picture's file; empty if nowhere
 */
record Span(String text, Style style, String link) {
    enum Style { PLAIN, BOLD, ITALIC, CODE, PICTURE }

    private static final Pattern MARK = Pattern.compile("`([^`]+)`|\\*\\*(.+?)\\*\\*|\\*([^*\\s](?:[^*]*[^*\\s])?)\\*|\\[((?:[^\\[\\]]|`[^`]*`)+)]\\(([^)\\s]+)\\)|<(https?://[^>\\s]+)>|!\\[([^]]*)]\\(([^)\\s]+)\\)");

    /** Takes a line apart. */
    static List<Span> of(String line) {
        return of(line, Style.PLAIN, "");
    }

    private static List<Span> of(String line, Style style, String link) {
        List<Span> spans = new ArrayList<>();
        Matcher mark = MARK.matcher(line);
        int from = 0;
        while (mark.find(from)) {
            add(spans, line.substring(from, mark.start()), style, link);
            if (mark.group(1) != null) {
                spans.add(new Span(mark.group(1), Style.CODE, link));
            } else if (mark.group(2) != null) {
                spans.addAll(of(mark.group(2), Style.BOLD, link));
            } else if (mark.group(3) != null) {
                spans.addAll(of(mark.group(3), Style.ITALIC, link));
            } else if (mark.group(6) != null) {
                spans.add(new Span(mark.group(6), style, mark.group(6)));
            } else if (mark.group(8) != null) {
                spans.add(new Span(mark.group(7), Style.PICTURE, mark.group(8)));
            } else {
                spans.addAll(of(mark.group(4), style, mark.group(5)));
            }
            from = mark.end();
        }
        add(spans, line.substring(from), style, link);
        return spans;
    }

    private static void add(List<Span> spans, String text, Style style, String link) {
        if (!text.isEmpty()) {
            spans.add(new Span(text.replaceAll("\\\\([\\\\`*_{}\\[\\]()#+.!|<>-])", "$1").replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&").replace("<br/>", "\n"), style, link));
        }
    }

    static String plain(List<Span> spans) {
        return spans.stream().map(Span::text).collect(Collectors.joining());
    }
}
