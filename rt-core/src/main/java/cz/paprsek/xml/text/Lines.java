package cz.paprsek.xml.text;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/** Ends the lines of a text in another way, and indents those by more or less that do not begin within a text or value. */
final class Lines {
    private final Source source;
    private final byte[] text;
    private final String indent;
    private final byte[] newIndent;
    private final byte[] lineBreak;
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();

    /** @param indent what each line begins with that is to begin with the new one */
    Lines(Source source, String indent, String newIndent, String lineBreak) {
        this.source = source;
        text = source.bytes();
        this.indent = indent;
        this.newIndent = newIndent.getBytes(StandardCharsets.UTF_8);
        this.lineBreak = lineBreak.getBytes(StandardCharsets.UTF_8);
    }

    byte[] changed() {
        boolean isText = false;
        int at = 0;
        for (int token = source.nextToken(0); token < text.length; token = source.nextToken(at)) {
            copy(at, token, !isText && isBlank(at, token));
            at = source.tokenEnd(token);
            if (text[token + 1] == '!' || text[token + 1] == '?') {
                copy(token, at, !isText && source.has("<!--", token));
            } else {
                copyTag(token, at);
                // Of all elements, this one holds text.
                isText = source.isNamed("description", token);
            }
        }
        copy(at, text.length, true);
        return out.toByteArray();
    }

    private void copyTag(int from, int to) {
        int at = from;
        for (int quote = from; quote < to; quote++) {
            if (text[quote] == '"' || text[quote] == '\'') {
                int close = source.indexOf(text[quote], quote + 1);
                copy(at, quote, true);
                copy(quote, close, false);
                at = close;
                quote = close;
            }
        }
        copy(at, to, true);
    }

    private void copy(int from, int to, boolean isIndented) {
        for (int at = from; at < to; at++) {
            if (text[at] != '\n' && text[at] != '\r') {
                out.write(text[at]);
                continue;
            }
            at = source.has("\r\n", at) ? at + 1 : at;
            out.writeBytes(lineBreak);
            int next = at + 1;
            if (isIndented && source.has(indent, next) && !isBlankLine(next)) {
                out.writeBytes(newIndent);
                at += indent.length();
            }
        }
    }

    private boolean isBlank(int from, int to) {
        int at = from;
        while (at < to && Source.isBlank(text[at])) {
            at++;
        }
        return at == to;
    }

    private boolean isBlankLine(int from) {
        int at = from;
        while (at < text.length && (text[at] == ' ' || text[at] == '\t')) {
            at++;
        }
        return at == text.length || text[at] == '\n' || text[at] == '\r';
    }
}
