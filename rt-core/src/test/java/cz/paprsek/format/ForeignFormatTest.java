package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Files are known by what they begin with; texts that only begin with the same words are none. */
class ForeignFormatTest {
    @ParameterizedTest
    @ValueSource(strings = {"render() {\\n return 1;\\n}", "group() {\\n return 1;\\n}", "union (a) {", "color (red) ;", "import(x)", "import os", "text (a) {",
        "OFF the record", "OFF\\nthe record", "OFFICE 5", "# a\\nOFF topic", "OFF 5 people", "CNC OFF\\n3 1 0", "difference is"})
    void wordsAloneAreNoFormat(String text) {
        assertThat(ForeignFormat.of("notes.txt", head(text.translateEscapes()))).isEmpty();
        assertThat(ForeignFormat.of("-", head(text.translateEscapes()))).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"'polyhedron(points = [LONG], faces = [[0, 1, 2]]);', OPENSCAD", "'import(file = \"a.stl\", layer = \"\");', OPENSCAD", "'\\n%group() {\\n\\tgroup();\\n}', OPENSCAD",
        "'group();', OPENSCAD", "'union() {}', OPENSCAD", "'group() {\\n\\t#import(file = \"a.stl\");\\n}', OPENSCAD", "'render(convexity = 1) {', OPENSCAD", "'cube([1,2,3]);', OPENSCAD",
        "'color([1, 0, 0, 1]) {', OPENSCAD", "'sphere($fn = 0, r = 1);', OPENSCAD", "'# made\\n\\n# by hand\\nOFF # three\\n3 1 0', OFF", "'OFF4 5 0', OFF", "'CNOFF\\r\\n3\\r\\n1', OFF",
        "'STCNOFF 3 1', OFF", "'NCSTOFF 3 1', OFF", "'OFF BINARY\\n', OFF", "'# LONG\\n# LONG\\nOFF\\n3 1 0', OFF", "'# LONG\\nv\\nfrom 0 0 9\\n', NFF", "'l 5 5 5\\nb 0 0 0\\n# eye\\nl 1 1 1\\nv\\nfrom 0 0 9\\n', NFF",
        "'v from 0 0 9\\n', NFF", "'# LONG\\nv 0 0 9\\n', OBJ"})
    void whatFormatsBeginWithIsKnown(String text, ForeignFormat format) {
        byte[] head = head(text.translateEscapes().replace("LONG", "[0, 0, 1], ".repeat(200)));
        assertThat(ForeignFormat.of("notes.txt", head)).contains(format);
        assertThat(ForeignFormat.of("-", head)).contains(format);
    }

    /** An OpenSCAD program may begin as a dump does. */
    @ParameterizedTest
    @ValueSource(strings = {"cube([1,2,3]);", "union() { cube(1); }"})
    void programsAreNoDumps(String text) {
        assertThat(ForeignFormat.of("m.scad", head(text))).isEmpty();
    }

    /** So many lines of remarks as there can be. */
    @ParameterizedTest
    @ValueSource(strings = {"#\n", "\n", "l 1\n", "b 1\n#\n", "\t", "#", "OFF\n#\n"})
    void noHeadIsTooMuch(String line) {
        assertThat(ForeignFormat.of("notes.txt", head(line.repeat(ForeignFormat.HEAD)))).isEmpty();
    }

    private static byte[] head(String text) {
        byte[] all = text.getBytes(StandardCharsets.ISO_8859_1);
        return Arrays.copyOf(all, Math.min(all.length, ForeignFormat.HEAD));
    }
}
