package cz.paprsek.cli.manual;

import java.util.List;
import java.util.stream.Stream;
import picocli.CommandLine.Help.Ansi;

/** What commands and options say of themselves, as picocli understands it: {@code %n} ends a line, markup is for terminals. */
final class Said {
    private Said() {}

    static List<String> lines(String... texts) {
        return Stream.of(texts).flatMap(said -> Ansi.OFF.string(said.replace("%n", "\n").replace("%%", "%")).lines()).toList();
    }

    /** Without its full stop. */
    static String firstSentence(String... texts) {
        String all = String.join(" ", lines(texts)).replaceAll("\\s+", " ").strip();
        int end = all.indexOf(". ");
        return (end < 0 ? all : all.substring(0, end)).replaceFirst("\\.$", "");
    }
}
