package cz.paprsek.xml;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What stands before the root element. The parser tells where a tag ends, and of white space before the root nothing at all, so the place of the
 * root is found here.
 */
final class Prolog {
    /** How much of a file is looked at; a root that starts later is told to start where this ends. */
    private static final int LONGEST = 1 << 16;
    private static final Pattern ENCODING = Pattern.compile("^<\\?xml[^>]{0,200}?\\sencoding\\s*=\\s*[\"']([^\"'<>]{1,60})[\"']");

    private final String text;
    private final int rootAt;

    Prolog(String start) {
        text = start.startsWith("\uFEFF") ? start.substring(1) : start;
        int at = 0;
        int before;
        do {
            before = at;
            while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
                at++;
            }
            at = after("<?", "?>", after("<!--", "-->", at));
        } while (at > before);
        rootAt = at;
    }

    /** Reads the start of a stream and puts it back. */
    static Prolog of(BufferedInputStream input) throws IOException {
        input.mark(LONGEST);
        byte[] start = input.readNBytes(LONGEST);
        input.reset();
        return new Prolog(new String(start, charset(start)));
    }

    private static Charset charset(byte[] start) {
        int first = start.length < 2 ? 0 : ((start[0] & 0xff) << 8) | (start[1] & 0xff);
        return switch (first) {
            case 0xfeff, 0x003c -> StandardCharsets.UTF_16BE;
            case 0xfffe, 0x3c00 -> StandardCharsets.UTF_16LE;
            default -> StandardCharsets.UTF_8;
        };
    }

    private int after(String opening, String closing, int at) {
        int end = text.startsWith(opening, at) ? text.indexOf(closing, at) : -1;
        return end < 0 ? at : end + closing.length();
    }

    int rootLine() {
        return 1 + (int) text.substring(0, rootAt).chars().filter(c -> c == '\n').count();
    }

    int rootColumn() {
        return rootAt - text.lastIndexOf('\n', rootAt - 1);
    }

    boolean isEmpty() {
        return text.isBlank();
    }

    /** Whether there are bytes that no text has. */
    boolean isBinary() {
        return text.substring(0, Math.min(text.length(), 1000)).indexOf('\0') >= 0;
    }

    /** Whether the file claims to have two bytes for each character, but was found to have one. */
    boolean isMisdeclared() {
        return text.startsWith("<?xml") && encoding().toUpperCase(Locale.ROOT).startsWith("UTF-16");
    }

    /** The sentence for a file whose bytes are no text in the encoding that it claims. */
    String wrongEncoding() {
        return isBinary() ? "this is a binary file, not a scene file"
                : "this is not text in the encoding " + encoding() + ", which the file claims to have; save it as UTF-8";
    }

    /** UTF-8 if the file claims none. */
    private String encoding() {
        Matcher matcher = ENCODING.matcher(text.substring(0, Math.min(text.length(), 400)));
        return matcher.find() ? matcher.group(1) : "UTF-8";
    }
}
