package cz.paprsek.xml.quick;

import cz.paprsek.xml.format.SceneFormat;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Set;

/** Tells well-formed files of the plain kind that scene files are, without the parser of the Java platform. */
public final class PlainMarkup {
    private PlainMarkup() {}

    /** Whether a file is such a one; if not, it may be well-formed all the same. */
    public static boolean isIn(byte[] file) throws IOException {
        try {
            read(new Markup(new ByteArrayInputStream(file)));
            return true;
        } catch (Unusual unusual) {
            return false;
        }
    }

    private static void read(Markup markup) throws IOException {
        Deque<byte[]> open = new ArrayDeque<>();
        do {
            boolean isStart = markup.nextTag();
            Unusual.unless(isStart || !open.isEmpty());
            if (!isStart) {
                markup.endTag(open.pop());
                continue;
            }
            byte[] element = markup.nameBytes();
            Unusual.unless(element.length > 0 && element[0] != '-');
            Set<String> attributes = new HashSet<>();
            while (markup.nextAttribute()) {
                byte[] name = markup.nameBytes();
                Unusual.unless(name.length > 0 && name[0] != '-' && attributes.add(new String(name, StandardCharsets.US_ASCII)));
                markup.value();
            }
            if (!markup.isEmptyElement()) {
                open.push(element);
                Unusual.unless(open.size() < SceneFormat.DEEPEST);
                markup.content();
            }
        } while (!open.isEmpty());
        markup.end();
    }
}
