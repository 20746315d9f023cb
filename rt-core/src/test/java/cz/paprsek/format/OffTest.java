package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.format.model.Model;
import cz.paprsek.format.model.Polygon;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.mesh.Triangles;
import java.io.IOException;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** OFF as several programs write it: remarks, letters before the first word, colours in both ways. */
class OffTest {
    private static final Vec3 ORANGE = new Vec3(1, Rgb.linear(128), 0);

    /** Geomview writes the normal first, MeshLab the colour; a number with a point goes up to 1. */
    @ParameterizedTest
    @CsvSource({"COFF, 255 128 0", "COFF, 255 128 0 255", "COFF, 1.0 0.501960784 0 1.0", "CNOFF, 0 0 1 255 128 0", "NCOFF, 255 128 0 255 0 0 1", "NCOFF, 1 .501960784 0. 0 0 1"})
    void verticesHaveColoursAndNormals(String first, String more) throws IOException {
        Model model = Read.text(ForeignFormat.OFF, "# by hand\n\n" + first + "\n3 1 # no edges are told\n\n" + "X # a corner\nY\n# between\nZ\n3 0 1 2\n"
                .replace("X", "0 0 0 " + more).replace("Y", "1 0 0 " + more).replace("Z", "0 1 0 " + more));
        Triangles mesh = model.triangles();
        assertThat(IntStream.range(0, 3).mapToObj(mesh::color)).allSatisfy(color -> assertThat(color.minus(ORANGE).length()).isLessThan(1e-6));
        assertThat(mesh.hasNormals()).isEqualTo(first.contains("N"));
        assertThat(mesh.area()).isEqualTo(0.5);
        assertThat(model.notes()).isEmpty();
    }

    /** Vertices that faces of two colours share are two; what cannot be taken along is told once. */
    @Test
    void facesHaveColoursAndAnyNumberOfCorners() throws IOException {
        Model model = Read.text(ForeignFormat.OFF, "OFF4 5 0\n0 0 0\n1 0 0 9\n1 1 0\n0 1 0\n4 0 1 2 3 255 128 0 # four\n3 2 1 0\n3 3 2 0 1 .501960784 0\n2 0 1\n3 0 1 2 7\n");
        Triangles mesh = model.triangles();
        assertThat(mesh.count()).isEqualTo(5);
        assertThat(mesh.vertexCount()).as("four orange, three white").isEqualTo(7);
        assertThat(mesh.area()).isEqualTo(2.5);
        assertThat(mesh.color(mesh.corner(0, 0))).isEqualTo(mesh.color(mesh.corner(3, 0))).satisfies(color -> assertThat(color.minus(ORANGE).length()).isLessThan(1e-6));
        assertThat(mesh.color(mesh.corner(2, 0))).isEqualTo(Vec3.ONE);
        assertThat(model.notes()).containsExactly("line 3: numbers after a vertex of which the first line does not tell are not read",
                "line 9: faces of less than three corners are not read", "line 10: colours of faces by their number in a table are not read");
    }

    /** A whole number up to 1 is of the kind that the others in the file are. */
    @ParameterizedTest
    @CsvSource({"1 0 0 1, 0.5 0 0 1, 255", "0 1 0 1, 1 0 0 1, 0", "1 0 0 1, 1e0 0 0 1, 255", "1 0 0 255, 255 0 0 255, 1", "1 0 0, 2 0 0, 1"})
    void aFileHasOneScale(String first, String others, int red) throws IOException {
        String file = "3 1 0\n0 0 0 A\n1 0 0 B\n0 1 0 B\n".replace("A", first).replace("B", others);
        Triangles vertices = Read.text(ForeignFormat.OFF, "COFF " + file + "3 0 1 2\n").triangles();
        assertThat(vertices.color(0).x()).isCloseTo(Rgb.linear(red), within(1e-6));
        Triangles faces = Read.text(ForeignFormat.OFF, "OFF 3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 " + first + "\n3 2 1 0 " + others + "\n").triangles();
        assertThat(faces.color(faces.corner(0, 0)).x()).isCloseTo(Rgb.linear(red), within(1e-6));
    }

    @ParameterizedTest
    @CsvSource({"STOFF, .25 .75", "STCNOFF, 0 0 1 255 128 0 255 .25 .75", "NCSTOFF, 255 128 0 0 0 1 .25 .75", "STCOFF, 255 128 0 .25 .75"})
    void placesInPicturesComeLast(String first, String more) throws IOException {
        Triangles mesh = Read.text(ForeignFormat.OFF, first + "\n3 1\n0 0 0 M\n1 0 0 M\n0 1 0 M\n3 0 1 2\n".replace("M", more)).triangles();
        assertThat(mesh.hasMap()).isTrue();
        assertThat(List.of(mesh.u(2), mesh.v(2))).containsExactly(.25f, .75f);
        assertThat(mesh.color(1)).satisfies(color -> assertThat(color.minus(first.contains("C") ? ORANGE : Vec3.ONE).length()).isLessThan(1e-6));
    }

    /** Of edges nothing depends. */
    @ParameterizedTest
    @ValueSource(strings = {"OFF\n3\n1\n3\n", "OFF 3 1\n", "OFF 3 1 3\n", "OFF\n3 1\n3 # edges\n", "OFF\n3\n1 3\n", "OFF\n3 1 # no edges\n# none\n\n"})
    void countsAreInAnyLines(String counts) throws IOException {
        assertThat(Read.text(ForeignFormat.OFF, counts + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").triangles().area()).isEqualTo(0.5);
    }

    /** A band in zigzag: there with large steps, and back beside it; it has few ears, and each is looked for long. */
    @Test
    void aFaceThatWouldTakeTooLongIsCutSomehow() throws IOException {
        int n = 20_000;
        String places = IntStream.range(0, n).mapToObj(i -> i < n / 2 ? i + " " + i % 2 * 1000 : n - 1 - i + " " + ((n - 1 - i) % 2 * 1000 + 1)).collect(Collectors.joining(" 0\n", "", " 0\n"));
        Model model = Read.text(ForeignFormat.OFF, "OFF " + n + " 1 0\n" + places + n + ' ' + IntStream.range(0, n).mapToObj(String::valueOf).collect(Collectors.joining(" ")) + "\n");
        assertThat(model.notes()).containsExactly("face 0: " + Polygon.HURRIED);
        assertThat(model.triangles().count()).isEqualTo(n - 2);
    }

    @ParameterizedTest
    @ValueSource(strings = {"4OFF", "nOFF", "OFF BINARY", "plain"})
    void otherKindsAreQuoted(String first) {
        assertThat(Read.fault(ForeignFormat.OFF, first + "\n3 1 0\n")).startsWith("line 1: an OFF file that is text, ").endsWith(", but here is \"" + first + '"');
    }
}
