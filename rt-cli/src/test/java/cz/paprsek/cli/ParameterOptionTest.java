package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
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
}
