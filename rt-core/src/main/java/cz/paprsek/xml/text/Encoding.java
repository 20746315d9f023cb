package cz.paprsek.xml.text;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.CharsetEncoder;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.nio.charset.UnsupportedCharsetException;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The encoding of a file, found as XML says: by its first bytes, or as it declares. A byte-order mark is a character like others. */
public final class Encoding {
    /** How much of a file is looked at for a declaration, in bytes. */
    static final int BEGINNING = 400;
    private static final Pattern DECLARED = Pattern.compile("^<\\?xml[^>]{0,200}?\\sencoding\\s*=\\s*[\"']([A-Za-z0-9._-]{1,60})[\"']");

    private final Charset charset;

    private Encoding(Charset charset) {
        this.charset = charset;
    }

    public static Encoding of(byte[] file) {
        return new Encoding(charset(file));
    }

    static Charset charset(byte[] file) {
        int first = file.length < 4 ? 0 : ByteBuffer.wrap(file).getInt();
        return switch (first >>> 16) {
            case 0xfeff, 0x003c -> StandardCharsets.UTF_16BE;
            case 0xfffe, 0x3c00 -> (first & 0xffff) == 0 ? Charset.forName("UTF-32LE") : StandardCharsets.UTF_16LE;
            case 0 -> Charset.forName("UTF-32BE");
            case 0xefbb -> StandardCharsets.UTF_8;
            case 0x4c6f -> declared(beginning(file, "IBM037"));
            default -> declared(beginning(file, "ISO-8859-1"));
        };
    }

    private static String beginning(byte[] file, String charset) {
        return new String(file, 0, Math.min(file.length, BEGINNING), Charset.forName(charset));
    }

    private static Charset declared(String beginning) {
        Matcher declaration = DECLARED.matcher(beginning);
        try {
            return declaration.find() ? Charset.forName(declaration.group(1)) : StandardCharsets.UTF_8;
        } catch (IllegalCharsetNameException | UnsupportedCharsetException e) {
            throw new Unpatchable("the encoding " + declaration.group(1) + " is not known");
        }
    }

    /** The text in UTF-8. */
    public byte[] toUtf8(byte[] file) {
        if (charset.equals(StandardCharsets.UTF_8)) {
            return file;
        }
        byte[] text = new String(file, charset).getBytes(StandardCharsets.UTF_8);
        if (!Arrays.equals(fromUtf8(text), file)) {
            throw new Unpatchable("the file is not quite in the encoding " + charset);
        }
        return text;
    }

    /** Whether the first bytes of a file tell it, whatever it declares. */
    public static boolean isTold(byte[] file) {
        int first = file.length < 4 ? 0 : ByteBuffer.wrap(file).getInt() >>> 16;
        return first == 0xfeff || first == 0xfffe || first == 0x003c || first == 0x3c00 || first == 0;
    }

    /** The text as it is in the file; characters that its encoding does not have as references. */
    public byte[] fromUtf8(byte[] text) {
        if (charset.equals(StandardCharsets.UTF_8)) {
            return text;
        }
        CharsetEncoder encoder = charset.newEncoder();
        CharBuffer characters = CharBuffer.wrap(new String(text, StandardCharsets.UTF_8));
        if (!encoder.canEncode(characters)) {
            StringBuilder all = new StringBuilder();
            characters.codePoints().forEach(c -> all.append(encoder.canEncode(Character.toString(c)) ? Character.toString(c) : "&#" + c + ";"));
            characters = CharBuffer.wrap(all);
        }
        try {
            ByteBuffer encoded = charset.newEncoder().encode(characters);
            byte[] bytes = new byte[encoded.remaining()];
            encoded.get(bytes);
            return bytes;
        } catch (CharacterCodingException e) {
            throw new Unpatchable("the text cannot be written in the encoding " + charset);
        }
    }
}
