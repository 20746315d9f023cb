package cz.paprsek.xml.text;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Pieces of a text that are to be replaced. */
final class Edits {
    private final List<Edit> edits = new ArrayList<>();

    private record Edit(int from, int to, String text) {}

    /** Those at one place come in the order in which they were added; what is added there comes before what is taken away. */
    void replace(int from, int to, String text) {
        edits.add(new Edit(from, to, text));
    }

    void insert(int at, String text) {
        replace(at, at, text);
    }

    void remove(int from, int to) {
        replace(from, to, "");
    }

    boolean isEmpty() {
        return edits.isEmpty();
    }

    Edits copy() {
        Edits copy = new Edits();
        copy.edits.addAll(edits);
        return copy;
    }

    byte[] applied(byte[] text) {
        return applied(text, 0, text.length);
    }

    /** A piece of the text with all that is to be replaced in it. */
    byte[] applied(byte[] text, int from, int to) {
        List<Edit> sorted = new ArrayList<>(edits);
        sorted.sort(Comparator.comparingInt(Edit::from).thenComparing(edit -> edit.to() > edit.from()));
        ByteArrayOutputStream out = new ByteArrayOutputStream(to - from + 1024);
        int at = from;
        for (Edit edit : sorted) {
            if (edit.from() < at || edit.to() > to) {
                throw new Unpatchable("two changes meet");
            }
            out.write(text, at, edit.from() - at);
            out.writeBytes(edit.text().getBytes(StandardCharsets.UTF_8));
            at = edit.to();
        }
        out.write(text, at, to - at);
        return out.toByteArray();
    }
}
