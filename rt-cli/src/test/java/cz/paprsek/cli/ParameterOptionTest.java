package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Other values for parameters of scenes, on every command that reads one. */
class ParameterOptionTest {
    private static final String SCENE = """
            <scene xmlns="urn:paprsek:scene:1">
              <param name="n" value="3" min="1" max="9" step="1"/>
              <param name="paint" value="red"/>
              <render width="16" height="9"/> <ambient color="200 200 200"/>
              <camera position="0 0 9" target="0 0 0"/>
              <repeat name="ball" count="{n}" position="1.2 0 0"><sphere radius="{0.5 + n/100}"><material color="{paint}"/></sphere></repeat>
            </scene>
            """;

    @TempDir
    private Path folder;

    @Test
    void allCommandsTakeOtherValues() throws Exception {
        String file = Files.writeString(folder.resolve("row.xml"), SCENE).toString();
        assertThat(Run.cli("info", file).out()).contains("n            3, from 1 to 9, in steps of 1", "paint        red", "objects      3");
        assertThat(Run.cli("info", "--json", file, "-D", "n=5").out()).contains("{\"name\":\"n\",\"formula\":\"5\",\"value\":5,\"min\":1,\"max\":9,\"step\":1}", "\"objects\":5");
        assertThat(Run.cli("validate", file, "-D", "n={2*2}", "-D", "paint=blue").code()).isZero();
        Path written = folder.resolve("out.xml");
        assertThat(Run.cli("convert", file, written.toString(), "-D", "paint=blue").code()).isZero();
        assertThat(Files.readString(written)).contains("<param name=\"paint\" value=\"blue\"/>", "count=\"{n}\"");
        Path pov = folder.resolve("out.pov");
        assertThat(Run.cli("convert", file, pov.toString(), "-D", "n=7").code()).isZero();
        assertThat(Files.readString(pov).split("sphere", -1)).hasSizeGreaterThanOrEqualTo(8);
        String one = Run.cli("render", file, "--format", "txt", "-o", "-", "-q").text();
        assertThat(Run.cli("render", file, "--format", "txt", "-o", "-", "-q", "-D", "n=3").text()).isEqualTo(one).isNotBlank();
        assertThat(Run.cli("render", file, "--format", "txt", "-o", "-", "-q", "-D", "n=1").text()).isNotEqualTo(one);
        assertThat(Run.cli("explain", file, "8,4").out()).contains("ball[0]");
    }

    @Test
    void whatASceneIncludesComesFromTheFolderThatIsSaid() throws Exception {
        Path other = Files.createDirectory(folder.resolve("parts"));
        Files.writeString(other.resolve("post.xml"), "<scene xmlns=\"urn:paprsek:scene:1\"><define name=\"post\"><cylinder radius=\"1\" height=\"2\"/></define></scene>");
        String file = Files.writeString(folder.resolve("fence.xml"), """
                <scene xmlns="urn:paprsek:scene:1">
                  <render width="16" height="9"/> <ambient color="white"/> <camera position="0 0 9" target="0 0 0"/>
                  <include file="post.xml"/> <instance name="first" of="post"/>
                </scene>
                """).toString();
        assertThat(Run.cli("validate", file).err()).contains("fence.xml:3:12: \"post.xml\": there is no such file beside the scene");
        Files.writeString(other.resolve("bad.xml"), "<scene xmlns=\"urn:paprsek:scene:1\"><define name=\"post\"><cylinder/></define></scene>");
        String[] assets = {"--assets", other.toString()};
        assertThat(Run.cli("validate", file, assets[0], assets[1]).code()).isZero();
        String bad = Files.writeString(folder.resolve("bad-fence.xml"), Files.readString(Path.of(file)).replace("post.xml", "bad.xml")).toString();
        assertThat(Run.cli("validate", bad, assets[0], assets[1]).err()).contains(other.resolve("bad.xml") + ":1:56: <cylinder> needs the attribute radius");
        assertThat(Run.cli("info", file, assets[0], assets[1]).out()).contains("objects      1");
        assertThat(Run.cli("explain", file, "8,4", assets[0], assets[1]).out()).contains("first");
        assertThat(Run.cli("render", file, "--format", "txt", "-o", "-", "-q", assets[0], assets[1]).text()).contains("255");
        assertThat(Run.cli("convert", file, folder.resolve("out.pov").toString(), assets[0], assets[1]).code()).isZero();
        assertThat(folder.resolve("out.pov")).content().contains("cylinder");
    }

    @Test
    void valuesThatCannotBeAreRefusedInOneLine() throws Exception {
        String file = Files.writeString(folder.resolve("row.xml"), SCENE).toString();
        Run beyond = Run.cli("render", file, "-D", "n=12", "-o", folder.resolve("x.png").toString());
        assertThat(beyond.code()).isEqualTo(3);
        assertThat(beyond.err()).contains(file + ":2:19: the parameter \"n\" must be a number from 1 to 9, but is 12");
        Run unknown = Run.cli("validate", file, "-D", "paimt=blue");
        assertThat(unknown.code()).isEqualTo(3);
        assertThat(unknown.err()).contains("there is no parameter \"paimt\"; did you mean \"paint\"?");
        assertThat(Run.cli("info", file, "-D", "n").code()).isEqualTo(2);
    }

    /** Another scene of the database may have a parameter of the same name with another range. */
    @Test
    void valuesAreForTheSceneThatIsChosen() throws Exception {
        String few = SCENE.replace("<scene ", "<scene name=\"few\" ").replace(" xmlns=\"urn:paprsek:scene:1\"", "");
        String many = few.replace("\"few\"", "\"many\"").replace("max=\"9\"", "max=\"20\"").replace("\"n\"", "\"m\"").replace("{n}", "{m}").replace("n/100", "m/100");
        String both = few + few.replace("\"few\"", "\"wide\"").replace("max=\"9\"", "max=\"20\"") + many;
        String file = Files.writeString(folder.resolve("rows.xml"), "<database xmlns=\"urn:paprsek:scene:1\">" + both + "</database>").toString();
        String[] wide = {"render", file, "--where", "name = 'wide'", "--format", "txt", "-o", "-", "-q", "-D"};
        String one = folder.resolve("row.xml").toString();
        Files.writeString(Path.of(one), SCENE.replace("max=\"9\"", "max=\"20\""));
        assertThat(Run.cli(with(wide, "n=12")).text()).isEqualTo(Run.cli("render", one, "--format", "txt", "-o", "-", "-q", "-D", "n=12").text()).isNotBlank();
        assertThat(Run.cli("explain", file, "8,4", "--scene", "wide", "-D", "n=12").code()).isZero();
        Run beyond = Run.cli("explain", file, "8,4", "--scene", "few", "-D", "n=12");
        assertThat(beyond.code()).isEqualTo(2);
        assertThat(beyond.err()).contains("rows.xml: scene \"few\": the parameter \"n\" must be a number from 1 to 9, but is 12");
        assertThat(Run.cli(with(wide, "m=4")).err()).contains("rows.xml: scene \"wide\": there is no parameter \"m\"");
        assertThat(Run.cli(with(wide, "n=21")).err()).contains("scene \"wide\": the parameter \"n\" must be a number from 1 to 20, but is 21");
    }

    private static Object[] with(String[] words, String last) {
        return Stream.concat(Stream.of(words), Stream.of(last)).toArray();
    }
}
