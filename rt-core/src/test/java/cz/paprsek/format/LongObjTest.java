package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.shape.mesh.Triangles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** OBJ files of several blocks, which threads read at once. */
class LongObjTest {
    private static final int STRIPS = 30_000;

    /** A strip of squares, each with two triangles; comments and unusual lines here and there. */
    private static String strip(Random random) {
        StringBuilder text = new StringBuilder("v 0 0 0\nv 0 0 1\n");
        for (int i = 1; i <= STRIPS; i++) {
            text.append("v ").append(i).append(" 0.").append(random.nextInt(1_000_000)).append(" 0\nv ").append(i).append(" 1e-1 1.0\n");
            int last = 2 * i + 2;
            text.append(i % 7 == 0 ? "f -4 -3 -2\n" : "f " + (last - 3) + ' ' + (last - 2) + ' ' + (last - 1) + '\n').append("f ").append(last - 1).append("\t").append(last - 2);
            text.append(i % 11 == 0 ? " \\\n" : " ").append(last).append(" \n");
            text.append(i % 13 == 0 ? "# a comment, to be passed over\n\n" : "");
            text.append(i % 10_000 == 0 ? "g part " + i + "\n" : "");
        }
        return text.toString();
    }

    private static Triangles read(String text) throws IOException {
        return Read.text(ForeignFormat.OBJ, text).triangles();
    }

    @ParameterizedTest
    @ValueSource(strings = {"\r\n", "\r"})
    void lineEndsMakeNoDifference(String end) throws IOException {
        String text = strip(new Random(5));
        assertThat(text.length()).as("several blocks").isGreaterThan(2_000_000);
        Triangles mesh = read(text);
        assertThat(mesh.count()).isEqualTo(2 * STRIPS);
        assertThat(mesh.vertexCount()).isEqualTo(2 * STRIPS + 2);
        assertThat(mesh.parts()).containsExactly("", "part 10000", "part 20000");
        assertThat(mesh.openEdges()).isEqualTo(2 * STRIPS + 2);
        assertThat(read(text.replace("\n", end))).isEqualTo(mesh);
        assertThat(Read.bytes(ForeignFormat.OBJ, text.getBytes(StandardCharsets.UTF_16)).triangles()).isEqualTo(mesh);
    }

    @Test
    void faultsAreSaidWithTheirLineWhereverTheyAre() {
        String text = strip(new Random(5));
        long lines = text.lines().count();
        assertThat(Read.fault(ForeignFormat.OBJ, text + "f 1 2 999999")).isEqualTo("line " + (lines + 1) + ": a corner names vertex 999999, but so far there are " + (2 * STRIPS + 2) + " vertices");
        assertThat(Read.fault(ForeignFormat.OBJ, text + "\nf 1 2 x\n" + text)).isEqualTo("line " + (lines + 2) + ": the number of a vertex must be a whole number, but is \"x\"");
        assertThat(Read.fault(ForeignFormat.OBJ, text.replace("v 20000 ", "v 2000O "))).endsWith(": x of a vertex must be a number, but is \"2000O\"");
    }

    /** As the platform's own reader of numbers has them, to the last bit. */
    @Test
    void numbersAreExact() throws IOException {
        Random random = new Random(7);
        String[] formats = {"%.3f", "%.6f", "%.9f", "%.15f", "%.17f", "%.20f", "%e", "%.16e", "%.0f", "%.1f"};
        StringBuilder text = new StringBuilder();
        String[] written = new String[3 * 9000];
        for (int i = 0; i < written.length; i++) {
            double value = (random.nextDouble() - 0.5) * StrictMath.pow(10, random.nextInt(16) - 5);
            String plain = String.format(Locale.ROOT, formats[random.nextInt(formats.length)], value);
            written[i] = random.nextInt(20) == 0 ? Double.toString(value) : random.nextInt(20) == 0 ? plain.replace("0.", ".") : plain;
            text.append(i % 3 == 0 ? "v " : " ").append(written[i]).append(i % 3 == 2 ? "\n" : "");
        }
        text.append("v 9 9 9\nv 8 9 9\n");
        for (int v = 1; v <= written.length / 3; v++) {
            text.append("f ").append(v).append(" -1 -2\n");
        }
        Triangles mesh = read(text.toString());
        int at = 0;
        for (int v = 0; v < written.length / 3; v++) {
            int vertex = v == 0 ? 0 : v + 2;
            for (double found : new double[] {mesh.x(vertex), mesh.y(vertex), mesh.z(vertex)}) {
                assertThat(found).as(written[at]).isEqualTo(Double.parseDouble(written[at++]));
            }
        }
    }
}
