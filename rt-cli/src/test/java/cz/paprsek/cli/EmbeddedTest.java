package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.shard.Piecework;
import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Engines of many machines use the command line within their own process. */
class EmbeddedTest {
    private static final String MESH = """
            ply
            format ascii 1.0
            element vertex 3
            property float x
            property float y
            property float z
            element face 1
            property list uchar int vertex_indices
            end_header
            0 0 0
            1 0 0
            0 1 0
            3 0 1 2
            """;

    @TempDir
    Path folder;

    @Test
    void resultsAreKept() {
        ByteArrayOutputStream results = new ByteArrayOutputStream();
        assertThat(Embedded.run(results, new PrintWriter(new StringWriter()), List.of("render", "--help"))).isEqualTo(ExitCode.DONE);
        assertThat(results.toString(StandardCharsets.UTF_8)).contains("--size", "Exit codes:");
    }

    @Test
    void filmsAreMadePieceByPieceToTheSameBytes() throws Exception {
        Files.writeString(folder.resolve("leaf.ply"), MESH);
        Path scene = Files.writeString(folder.resolve("film.xml"), """
                <scene xmlns="urn:paprsek:scene:1" name="Film"><render width="64" height="32" samples="1"/><camera position="0 1 6" target="0 0 0" fovy="40"/>
                <sun-light direction="-1 -2 -1.2"/><mesh name="leaf" file="leaf.ply" position="0 0 0"/>
                <animate target="leaf" attribute="position"><key t="0" value="-1 0 0"/><key t="0.3" value="1 0.5 0"/></animate></scene>""");
        StringWriter told = new StringWriter();
        Piecework piecework = new Piecework(List.of("film.xml"));
        assertThat(Embedded.order(OutputStream.nullOutputStream(), new PrintWriter(told), List.of(scene.toString(), "--frames", "1-5"), piecework)).as(told.toString()).isEqualTo(ExitCode.DONE);
        assertThat(piecework.files()).containsOnlyKeys("leaf.ply").containsEntry("leaf.ply", MESH.getBytes(StandardCharsets.UTF_8));
        // More frames than stay prepared, and the first once more.
        for (int frame : new int[] {1, 2, 3, 4, 5, 1}) {
            for (var tile : piecework.tiles(32)) {
                piecework.make(folder.resolve("parts"), frame, tile, () -> false);
            }
        }
        assertThat(run("merge", folder.resolve("parts").toString(), "-o", folder.resolve("made-{frame}.png").toString())).isEqualTo(ExitCode.DONE);
        assertThat(run("render", scene.toString(), "--frames", "1-5", "--quiet", "-o", folder.resolve("whole-{frame}.png").toString())).isEqualTo(ExitCode.DONE);
        for (int frame = 1; frame <= 5; frame++) {
            assertThat(folder.resolve("made-000" + frame + ".png")).hasSameBinaryContentAs(folder.resolve("whole-000" + frame + ".png"));
        }
    }

    @Test
    void sidesOfTilesAreMultiplesOf32() {
        for (int side : new int[] {33, 0, -5, 65568, 2147483616}) {
            assertThatThrownBy(() -> Piecework.requireSide(side)).isInstanceOf(IllegalArgumentException.class).hasMessage("the side of a tile is a multiple of 32 pixels, from 32 to 65536, not " + side);
        }
        assertThat(Piecework.requireSide(65536)).isEqualTo(65536);
    }

    private static int run(String... words) {
        return Embedded.run(OutputStream.nullOutputStream(), new PrintWriter(System.err, true, StandardCharsets.UTF_8), List.of(words));
    }
}
