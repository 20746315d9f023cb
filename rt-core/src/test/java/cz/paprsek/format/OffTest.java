package cz.paprsek.format;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.format.model.Model;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.mesh.Triangles;
import java.io.IOException;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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
}
