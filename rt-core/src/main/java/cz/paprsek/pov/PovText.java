package cz.paprsek.pov;

import cz.paprsek.io.PlainText;
import cz.paprsek.math.Vec3;
import cz.paprsek.text.Numbers;
import java.io.IOException;
import java.util.List;
import java.util.stream.Collectors;

/** Lines of POV-Ray's language, indented by how many braces are open. */
final class PovText {
    private final Appendable out;
    private int depth;

    PovText(Appendable out) {
        this.out = out;
    }

    void line(String line) throws IOException {
        out.append("  ".repeat(depth)).append(line).append('\n');
    }

    /** Writes somebody's text where it does no harm; nothing if it is empty. */
    void comment(String words) throws IOException {
        if (!words.isEmpty()) {
            line("// " + PlainText.of(words, Integer.MAX_VALUE));
        }
    }

    void open(String keyword) throws IOException {
        line(keyword + " {");
        depth++;
    }

    /** Closes what was opened last, after some more words. */
    void close(String words) throws IOException {
        if (!words.isEmpty()) {
            line(words);
        }
        depth--;
        line("}");
    }

    static String vector(Vec3 v) {
        return vector(v.x(), v.y(), v.z());
    }

    static String vector(double x, double y, double z) {
        return "<" + Numbers.text(x) + ", " + Numbers.text(y) + ", " + Numbers.text(z) + ">";
    }

    /** The texts with a blank between them, without the empty ones. */
    static String joined(List<String> texts) {
        return texts.stream().filter(text -> !text.isEmpty()).collect(Collectors.joining(" "));
    }
}
