package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class InfoCommandTest {
    @TempDir
    Path folder;

    private Path file;

    @BeforeEach
    void writeAScene() throws IOException {
        file = Scenes.scene(folder.resolve("a.xml"), "<point-light name=\"key\" position=\"2 3 4\" intensity=\"0.5\"/>"
                + "<material name=\"red\" color=\"255 0 0\"/><plane/><sphere radius=\"1\" position=\"0 1 0\" material=\"red\"/>"
                + "<difference><block min=\"-3 0 0\" max=\"-2 1 1\"/><sphere radius=\"0.5\"/></difference>");
    }

    @Test
    void aSceneIsDescribedForPeople() {
        Run run = Run.cli("info", file);
        assertThat(run.code()).isZero();
        assertThat(run.out().lines().map(String::strip).map(line -> line.replaceAll(" +", " "))).containsExactly(
                file.toString(),
                "name ball",
                "background 0 0 0",
                "ambient 0 0 0",
                "picture 16x8, max-depth 5, samples 1",
                "camera position 0 1 5, direction 0 0 -1, up 0 1 0, fovy 45",
                "lights 1",
                "key point-light: position 2 3 4, color 255 255 255, intensity 0.5",
                "materials 1",
                "red color 255 0 0, diffusion 0.8",
                "objects 3, with 2 operands",
                "block 0 and 1 operand",
                "difference 1",
                "plane 1",
                "sphere 1 and 1 operand",
                "bounds -3 0 -1 to 1 2 1, and 1 without bounds");
    }

    @Test
    void aSceneIsDescribedForScripts() {
        assertThat(Run.cli("info", file, "--json").out())
                .startsWith("{\"file\":\"")
                .contains("\"render\":{\"width\":16,\"height\":8,\"max-depth\":5,\"integrator\":\"whitted\",\"samples\":1,\"filter\":\"box\",\"exposure\":0,\"tone\":\"none\"}")
                .contains("\"lights\":[{\"name\":\"key\",\"kind\":\"point-light\",\"position\":[2,3,4],\"color\":[255,255,255],\"intensity\":0.5}]")
                .contains("\"objects\":3,\"kinds\":{\"block\":{\"objects\":0,\"operands\":1},")
                .endsWith("\"unbounded\":1,\"bounds\":{\"min\":[-3,0,-1],\"max\":[1,2,1]}}\n")
                .hasLineCount(1);
    }

    @Test
    void whatCountsIsTold_notWhatStandsForNothingGiven() throws IOException {
        Path scene = folder.resolve("b.xml");
        Files.writeString(scene, "<scene xmlns=\"urn:paprsek:scene:1\" name=\"lit from above\"><camera name=\"down\" position=\"0 5 0\" direction=\"0 -1 0\"/>"
                + "<camera name=\"sharp\" position=\"0 3 4\" target=\"0 0 0\" aperture=\"0.1\"/>"
                + "<spot-light name=\"narrow\" position=\"1 1 1\" target=\"0 0 0\" outer-angle=\"20\"/>"
                + "<spot-light name=\"wide\" position=\"1 1 1\" target=\"0 0 0\" reference-distance=\"2\"/></scene>");
        assertThat(Run.cli("info", scene).out().lines().map(line -> line.strip().replaceAll(" +", " "))).contains(
                "down position 0 5 0, direction 0 -1 0, up 0 0 -1, fovy 45",
                "sharp position 0 3 4, target 0 0 0, up 0 1 0, fovy 45, aperture 0.1, focus 5",
                "narrow spot-light: position 1 1 1, target 0 0 0, color 255 255 255, intensity 1, inner-angle 20, outer-angle 20",
                "wide spot-light: position 1 1 1, target 0 0 0, color 255 255 255, intensity 1, reference-distance 2, inner-angle 30, outer-angle 45");
        assertThat(Run.cli("info", "--json", scene).out()).contains("\"up\":[0,0,-1],\"projection\":\"perspective\",\"fovy\":45,\"aperture\":0}",
                "\"intensity\":1,\"inner-angle\":20,\"outer-angle\":20}");
        assertThat(Run.cli("info", "--json", scene).out()).contains("\"name\":\"down\",\"position\":[0,5,0],\"direction\":[0,-1,0],\"up\"",
                "\"target\":[0,0,0],\"up\":[0,1,0],\"projection\":\"perspective\",\"fovy\":45,\"aperture\":0.1,\"focus\":5,\"direction\":[0,-0.6,-0.8]}");
        assertThat(Run.cli("db", "show", "light", scene, "--csv").text()).contains("20,20").doesNotContain(",0,");
        assertThat(Run.cli("db", "list", scene, "--where", "not most-samples >= 0 and not error > 0 and exists(camera where focus = 5)").out()).contains("lit from above");
    }

    @Test
    void ofMaterialsSkiesAndSettingsThatIsToldWhichMatters() throws IOException {
        Path scene = folder.resolve("c.xml");
        Files.writeString(scene, "<scene xmlns=\"urn:paprsek:scene:1\" name=\"glow\"><render samples=\"2..8\" filter=\"tent\"/><sky zenith=\"1 2 3\"/><camera position=\"0 5 0\" "
                + "target=\"0 0 0\"/><material name=\"ruby\" transparency=\"1\" refractive-index=\"1.5\" attenuation-color=\"230 20 40\" attenuation-distance=\"2\" specular=\"0.5\"/>"
                + "<material name=\"lamp\" emission=\"255 0 0\" attenuation-color=\"1 1 1\" refractive-index=\"2\"/></scene>");
        assertThat(Run.cli("info", scene).out().lines().map(line -> line.strip().replaceAll(" +", " "))).contains(
                "sky zenith 1 2 3, horizon 206 220 236, ground 112 104 96",
                "picture 800x600, max-depth 5, samples 2..8, error 0.01, confidence 0.95, filter tent",
                "ruby color 255 255 255, diffusion 0.8, specular 0.5, shininess 30, transparency 1, refractive-index 1.5, attenuation-color 230 20 40, attenuation-distance 2",
                "lamp color 255 255 255, diffusion 0.8, emission 255 0 0, emission-strength 1");
        assertThat(Run.cli("info", "--json", scene).out()).contains("\"sky\":{\"zenith\":[1,2,3],", "\"samples\":2,\"most-samples\":8,\"error\":0.01")
                .contains("\"thin\":false,\"emission\":[255,0,0],\"emission-strength\":1}");
        assertThat(Run.cli("db", "find", scene, "--where", "emission.red = 255 and not refractive-index > 0").out()).contains("lamp").doesNotContain("ruby");
        assertThat(Run.cli("db", "list", scene, "--where", "sky = \"gradient\" and background = \"0 0 0\"").out()).contains("glow");
    }

    /** Every number that is told of it would be wrong nearly everywhere. */
    @Test
    void ofAShareThatAPatternSaysThatIsToldAndFromWhatToWhat() throws IOException {
        Path scene = folder.resolve("d.xml");
        Files.writeString(scene, "<scene xmlns=\"urn:paprsek:scene:1\"><camera position=\"0 0 5\" target=\"0 0 0\"/><material name=\"floor\">"
                + "<reflection><checker size=\"1\" even=\"51 51 51\" odd=\"110 110 110\"/></reflection><roughness channel=\"red\"><image file=\"a.png\"/></roughness></material>"
                + "<sphere radius=\"1\" material=\"floor\"/></scene>");
        assertThat(Run.cli("info", scene).out()).contains("diffusion 0.8, reflection 0.2..0.4314 by checker, roughness 0..1 by image");
        String checker = "\"reflection\":{\"least\":0.2,\"most\":0.4313725490196078,\"pattern\":\"checker\"}";
        String image = "\"roughness\":{\"least\":0,\"most\":1,\"pattern\":\"image\"}";
        assertThat(Run.cli("info", scene, "--json").out()).contains(checker, image, "\"diffusion\":0.8");
        for (String table : List.of("material", "sphere")) {
            assertThat(Run.cli("db", "show", table, scene, "--columns", "diffusion,reflection,roughness", "--csv").text())
                    .isEqualTo("diffusion,reflection,roughness\n0.8,0.2..0.4314 by checker,0..1 by image\n");
            assertThat(Run.cli("db", "show", table, scene, "--columns", "reflection").out()).contains("0.2..0.4314 by checker");
            assertThat(Run.cli("db", "show", table, scene, "--json").out()).contains(checker, image);
        }
    }

    @Test
    void theSchemaIsPrintedOrWritten() {
        assertThat(Run.cli("schema").text()).isEqualTo(SceneFiles.schema());
        Path xsd = folder.resolve("scene.xsd");
        assertThat(Run.cli("schema", "-o", xsd).code()).isZero();
        assertThat(xsd).hasContent(SceneFiles.schema());
        assertThat(Run.cli("schema", "-o", folder).err()).contains("this is a directory");
    }
}
