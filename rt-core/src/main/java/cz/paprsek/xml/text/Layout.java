package cz.paprsek.xml.text;

/** How a text is laid out in lines: what stands on a line of its own, what belongs to it, and how far it is indented. */
final class Layout {
    private final Source source;
    private final byte[] text;
    private final String lineBreak;
    private final String unit;

    Layout(Source source) {
        this.source = source;
        text = source.bytes();
        int first = 0;
        while (first < text.length && !isBreak(text[first])) {
            first++;
        }
        lineBreak = source.has("\r\n", first) ? "\r\n" : first < text.length && text[first] == '\r' ? "\r" : "\n";
        String indent = indent(source.firstChild());
        unit = indent.isEmpty() ? "  " : indent;
    }

    /** How this text ends its lines. */
    String lineBreak() {
        return lineBreak;
    }

    /** What each level is indented by. */
    String unit() {
        return unit;
    }

    /** Whether nothing but blanks stands before it on its line. */
    boolean beginsLine(Element element) {
        return beginsLine(element.start());
    }

    private boolean beginsLine(int place) {
        return lineBreakBefore(place) >= 0 || backOverBlanks(place) == 0;
    }

    /** The blanks before the element's line; none if it does not begin it. */
    String indent(Element element) {
        return indent(element.start());
    }

    private String indent(int place) {
        return beginsLine(place) ? source.text(backOverBlanks(place), place) : "";
    }

    /** Where the line break begins before which nothing but blanks stands; negative if something else does. */
    int lineBreakBefore(int place) {
        int at = backOverBlanks(place);
        if (at == 0 || !isBreak(text[at - 1])) {
            return -1;
        }
        return source.has("\r\n", at - 2) ? at - 2 : at - 1;
    }

    /** Where the line ends, if nothing but blanks, comments and instructions stands between; negative if something else does. */
    int lineEnd(int place) {
        int at = place;
        while (true) {
            while (at < text.length && (text[at] == ' ' || text[at] == '\t')) {
                at++;
            }
            if (at == text.length || isBreak(text[at])) {
                return at;
            }
            if (!source.has("<!--", at) && !source.has("<?", at)) {
                return -1;
            }
            at = source.tokenEnd(at);
        }
    }

    /** Behind the element and the comments and instructions that follow on its line. */
    int endWithComments(Element element) {
        return Math.max(element.end(), lineEnd(element.end()));
    }

    /** Where the comments and instructions begin that stand on lines of their own directly above the element; its own start if there are none. */
    int startWithComments(Element element) {
        int start = element.start();
        while (true) {
            int above = lineBreakBefore(start);
            int end = above < 0 ? 0 : backOverBlanks(above);
            boolean isComment = source.has("-->", end - 3);
            if (!isComment && !source.has("?>", end - 2)) {
                return start;
            }
            int open = end - 2;
            while (open >= 0 && !source.has(isComment ? "<!--" : "<?", open)) {
                open--;
            }
            if (lineBreakBefore(Math.max(open, 0)) < 0) {
                return start;
            }
            start = open;
        }
    }

    private int backOverBlanks(int place) {
        int at = place;
        while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\t')) {
            at--;
        }
        return at;
    }

    private static boolean isBreak(byte c) {
        return c == '\n' || c == '\r';
    }
}
