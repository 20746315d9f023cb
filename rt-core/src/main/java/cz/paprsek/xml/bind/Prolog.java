package cz.paprsek.xml.bind;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.Charset;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
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

    private static final byte[] XML = "<?xml".getBytes(StandardCharsets.US_ASCII);

    private final String text;
    /** What the bytes are found to be; empty if they may be anything with a byte for each character of ASCII, or are none. */
    private final String found;
    private final boolean isMarked;
    private final int rootAt;

    /** Of what is a text already. */
    Prolog(String start) {
        this(start, "");
    }

    private Prolog(String start, String found) {
        this.found = found;
        isMarked = start.startsWith("\uFEFF");
        text = isMarked ? start.substring(1) : start;
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
        Charset charset = charset(start);
        return new Prolog(new String(start, charset), charset.equals(StandardCharsets.UTF_8) ? "" : charset.name().substring(0, "UTF-16".length()));
    }

    private static Charset charset(byte[] start) {
        ByteBuffer bytes = ByteBuffer.wrap(Arrays.copyOf(start, 4));
        return switch (bytes.getInt(0)) {
            case 0x0000feff, 0x0000003c -> Charset.forName("UTF-32BE");
            case 0xfffe0000, 0x3c000000 -> Charset.forName("UTF-32LE");
            default -> switch (bytes.getShort(0) & 0xffff) {
                case 0xfeff, 0x003c -> StandardCharsets.UTF_16BE;
                case 0xfffe, 0x3c00 -> StandardCharsets.UTF_16LE;
                default -> StandardCharsets.UTF_8;
            };
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

    /** Whether there are bytes that no text has, and it does not begin as XML does: a disk that is pulled out leaves files with zeros at their end. */
    boolean isBinary() {
        return !text.stripLeading().startsWith("<") && text.substring(0, Math.min(text.length(), 1000)).indexOf('\0') >= 0;
    }

    /** Whether the file claims to have more bytes or fewer for each character than were found. */
    boolean isMisdeclared() {
        String claimed = encoding();
        return found.isEmpty() ? text.startsWith("<?xml") && isUnlikeAscii(claimed)
                : found.equals("UTF-32") || (claimed.isEmpty() ? !isMarked : !isWide(claimed));
    }

    /** Whether what has been read as ASCII cannot be of that encoding. */
    private static boolean isUnlikeAscii(String encoding) {
        return isWide(encoding) || (isKnown(encoding) && !new String(XML, Charset.forName(encoding)).equals("<?xml"));
    }

    private static boolean isKnown(String encoding) {
        try {
            return Charset.isSupported(encoding);
        } catch (IllegalCharsetNameException e) {
            return false;
        }
    }

    private static boolean isWide(String encoding) {
        return encoding.toUpperCase(Locale.ROOT).matches("UTF-?(16|32).*|.*UCS-?[24].*");
    }

    /** The sentence for a file whose bytes are no text in the encoding that it claims. */
    String wrongEncoding() {
        if (isBinary()) {
            return "this is a binary file, not a scene file";
        }
        String claimed = encoding();
        if (found.equals("UTF-32")) {
            return "this is text in UTF-32, which cannot be read here; save it as UTF-8";
        }
        if (!found.isEmpty() && !isWide(claimed)) {
            return "this is text in " + found + ", but " + (claimed.isEmpty() ? "the mark that says so is missing at its start"
                    : "the file claims to be " + claimed) + "; save it as UTF-8";
        }
        if (!claimed.isEmpty() && !isKnown(claimed) && !isWide(claimed)) {
            return "the encoding \"" + claimed + "\", which the file claims to have, is not known here; save it as UTF-8";
        }
        return claimed.isEmpty() ? "this is not text in UTF-8, and the file names no other encoding; save it as UTF-8"
                : "this is not text in the encoding " + claimed + ", which the file claims to have; save it as UTF-8";
    }

    /** Empty if the file claims none. */
    private String encoding() {
        Matcher matcher = ENCODING.matcher(text.substring(0, Math.min(text.length(), 400)));
        return matcher.find() ? matcher.group(1) : "";
    }
}
