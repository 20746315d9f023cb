package cz.paprsek.fx.model.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Pattern;

/**
 * What a file begins with, and so what it is.
 *
 * @param isOther whether it neither is named as scenes are nor begins as XML does, in any encoding
 * @param isLesson whether a lesson is written in it, right or wrong
 */
public record FileHead(boolean isOther, boolean isLesson) {
    /** Bytes, within which a scene or lesson in XML begins. */
    private static final int LENGTH = 4096;

    private static final Pattern BEFORE_XML = Pattern.compile("^[\\s\\x00\u00EF\u00BB\u00BF\u00FE\u00FF]+");
    /** After the mark of an encoding, what says that it is XML, and comments. */
    private static final Pattern LESSON = Pattern.compile("^(?:[\\s\u00EF\u00BB\u00BF]++|<\\?[^>]*+>|<!--(?s:.*?)-->)*+<lesson[\\s>]");

    /** Of a file; one that cannot be read is neither: what is wrong with it is said by who opens it. */
    public static FileHead of(Path file) {
        if (!Files.isRegularFile(file)) {
            return new FileHead(false, false);
        }
        try (InputStream input = Files.newInputStream(file)) {
            String head = new String(input.readNBytes(LENGTH), StandardCharsets.ISO_8859_1);
            boolean isNamedSo = file.toString().toLowerCase(Locale.ROOT).endsWith(".xml");
            return new FileHead(!isNamedSo && !BEFORE_XML.matcher(head).replaceFirst("").startsWith("<"), LESSON.matcher(head).find());
        } catch (IOException unreadable) {
            return new FileHead(false, false);
        }
    }
}
