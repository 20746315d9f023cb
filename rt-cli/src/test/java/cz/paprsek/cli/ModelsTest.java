package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files of other programs, as users come with them. */
class ModelsTest {
    /** The corner of a cube: a quarter of the pixels and more show it. */
    private static final String OBJ = "v 0 0 0\nv 3 0 0\nv 0 4 0\nv 0 0 5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

    @TempDir
    Path folder;

    private Path obj;

    @BeforeEach
    void writeAModel() throws IOException {
        obj = Files.writeString(folder.resolve("corner.obj"), OBJ);
    }

    @Test
    void aModelIsRenderedAtOnce() throws IOException {
        Path picture = folder.resolve("p.png");
        assertThat(Run.cli("render", obj, "-o", picture, "--size", "48x36", "--samples", "1").code()).isZero();
        Image image = ImageFiles.read(picture);
        assertThat(image.width()).isEqualTo(48);
        assertThat(image.green(24, 18)).as("the body is brighter than its shadow").isGreaterThan(0.1f);
    }

    @Test
    void aFileOfTrianglesIsDescribed() {
        Run run = Run.cli("info", obj);
        assertThat(run.out().lines().map(String::strip).map(line -> line.replaceAll(" +", " "))).containsExactly(obj.toString(), "triangles 4, vertices 4", "closed yes",
                "volume 10", "area 37.36542462386205", "bounds 0 0 0 to 3 4 5", "unit not said, y is up");
        assertThat(Run.cli("info", obj, "--json").out()).contains("\"closed\":true,\"open-edges\":0,\"volume\":10,\"area\":37.36").contains("\"bounds\":{\"min\":[0,0,0],\"max\":[3,4,5]}").hasLineCount(1);
    }

    @Test
    void whatIsOpenIsSaid() throws IOException {
        Path open = Files.writeString(folder.resolve("open.obj"), OBJ.replace("f 2 3 4\n", ""));
        assertThat(Run.cli("info", open).out()).contains("no, 3 edges are open").doesNotContain("volume");
    }

    @Test
    void aModelBecomesASceneThatIsTheSamePicture() throws IOException {
        Path scene = folder.resolve("sub/corner.xml");
        Files.createDirectories(folder.resolve("sub"));
        assertThat(Run.cli("convert", obj, scene).code()).isZero();
        assertThat(folder.resolve("sub/corner.obj")).hasSameBinaryContentAs(obj);
        assertThat(Run.cli("validate", "--strict", scene).code()).isZero();
        assertThat(Run.cli("render", obj, "-o", folder.resolve("a.ppm"), "--size", "32x24").code()).isZero();
        assertThat(Run.cli("render", scene, "-o", folder.resolve("b.ppm"), "--size", "32x24").code()).isZero();
        assertThat(folder.resolve("b.ppm")).hasSameBinaryContentAs(folder.resolve("a.ppm"));
    }

    @Test
    void trianglesGoFromFormatToFormat() {
        Path stl = folder.resolve("corner.stl");
        Path back = folder.resolve("back.obj");
        assertThat(Run.cli("convert", obj, stl).code()).isZero();
        assertThat(Run.cli("convert", stl, back).code()).isZero();
        assertThat(Run.cli("info", back).out()).contains("volume      10").contains("vertices 4");
        assertThat(Run.cli("convert", stl, folder.resolve("a.pov"), "-q").code()).isZero();
        assertThat(folder.resolve("a.pov")).content().contains("mesh2");
    }

    @Test
    void openScadBecomesBodiesOfOurs() throws IOException {
        Path csg = Files.writeString(folder.resolve("thing.csg"), """
                difference() {
                    cube(size = [2, 2, 2], center = true);
                    sphere(r = 1.2);
                }
                hull() { cube(size=1); }
                linear_extrude(height=1,twist=90,slices=9,scale=[1,1]) { square(size=[1,1],center=false); }
                """);
        Path scene = folder.resolve("thing.xml");
        Run run = Run.cli("convert", csg, scene);
        assertThat(run.code()).isZero();
        assertThat(run.err()).isEqualTo(csg + ": note: line 5: hull() is not read, and left out\n");
        assertThat(scene).content().contains("<difference", "<sphere radius=\"1.2\"/>", "<mesh file=\"thing-1.obj\"");
        assertThat(Run.cli("validate", "--strict", scene).code()).isZero();
        assertThat(Run.cli("explain", csg, "400,300", "--samples", "1").code()).isZero();
    }

    @Test
    void whatIsWrongIsOneLine() throws IOException {
        Path bad = Files.writeString(folder.resolve("bad.stl"), "solid x\nfacet\nvertex 1 2\n");
        for (Run run : new Run[] {Run.cli("render", bad, "-o", folder.resolve("x.png")), Run.cli("info", bad), Run.cli("validate", bad), Run.cli("convert", bad, folder.resolve("x.xml")),
            Run.cli("explain", bad, "1,1")}) {
            assertThat(run.code()).isEqualTo(3);
            assertThat(run.err()).isEqualTo(bad + ": line 3: z of a corner is missing\n");
        }
    }
}
