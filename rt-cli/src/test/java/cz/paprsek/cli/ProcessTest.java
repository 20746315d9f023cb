package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What only a process of its own shows: its streams, its memory, its locale and its end. */
@EnabledOnOs(OS.LINUX)
@Timeout(120)
class ProcessTest {
    @TempDir
    Path folder;

    private record Ended(int code, String out, String err) {}

    private ProcessBuilder builder(List<String> options, String... words) {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC"));
        command.addAll(options);
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), Main.class.getName()));
        command.addAll(List.of(words));
        return new ProcessBuilder(command);
    }

    private static Ended end(ProcessBuilder builder) throws Exception {
        Process process = builder.start();
        process.getOutputStream().close();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
        return new Ended(process.exitValue(), out, err);
    }

    @ParameterizedTest
    @ValueSource(strings = {"info S", "info S --json", "validate S", "validate S --json", "explain S 8,4", "db list S", "db tables S", "db list S --csv",
        "db extract S ball -o -", "compare P P", "compare P Q --json", "compare P Q", "grade S Q --csv", "schema", "--help", "render --help", "--version", "generate-completion", "render S -o P --json --quiet", "render S -o -"})
    void resultsThatAreLostAreAFailure(String line) throws Exception {
        Path scene = Scenes.ball(folder.resolve("s.xml"));
        Path picture = folder.resolve("p.png");
        Run.cli("render", scene, "-o", picture);
        Path other = folder.resolve("q.png");
        Run.cli("render", scene, "-o", other, "--mistake", "flip-x");
        String[] words = line.replace("S", scene.toString()).replace("P", picture.toString()).replace("Q", other.toString()).split(" ");
        ProcessBuilder builder = builder(List.of(), words).redirectOutput(Path.of("/dev/full").toFile());
        Process process = builder.start();
        String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).isEqualTo(1);
        assertThat(err.lines().filter(said -> said.startsWith("standard output: no space left on device"))).hasSize(1);
    }

    @Test
    void whoeverStopsListeningIsTold() throws Exception {
        Path scene = Scenes.ball(folder.resolve("s.xml"));
        Process process = builder(List.of(), "info", scene.toString()).start();
        process.getInputStream().close();
        assertThat(new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8)).isEqualTo("standard output: broken pipe; results are lost\n");
        assertThat(process.waitFor()).isEqualTo(1);
    }

    @Test
    void aPictureThatMemoryCannotHoldSaysWhatItTakesAndWhatWouldDo() throws Exception {
        Path scene = Scenes.ball(folder.resolve("s.xml"));
        Ended render = end(builder(List.of("-Xmx64m"), "render", scene.toString(), "-o", folder.resolve("p.bmp").toString(), "--size", "8000x8000"));
        assertThat(render.code()).isEqualTo(1);
        assertThat(render.err()).startsWith(scene + ": not enough memory: the picture of 8000x8000 pixels takes about 1.2 GB, but Java may use 6")
                .contains("PAPRSEK_JAVA_OPTIONS=-Xmx2g").doesNotContain("\tat ").hasLineCount(1);
    }

    @Test
    void aSceneThatMemoryCannotHoldLeavesNoTrace() throws Exception {
        Path scene = Scenes.scene(folder.resolve("s.xml"), "<sphere radius=\"1\" position=\"0 1 0\"/>".repeat(200_000));
        for (String command : List.of("render", "info", "validate")) {
            Ended run = end(builder(List.of("-Xmx24m"), command, scene.toString()).directory(folder.toFile()));
            assertThat(run.code()).isEqualTo(1);
            assertThat(run.err()).contains("not enough memory", "-Xmx1g").doesNotContain("\tat ").hasLineCount(1);
        }
    }

    @Test
    void whatALocaleCannotNameIsSaidInALineAndTheRestIsRendered() throws Exception {
        Path file = Files.writeString(folder.resolve("names.xml"), "<database xmlns=\"urn:paprsek:scene:1\">" + one("Žluťoučký kůň") + one("plain") + "</database>");
        ProcessBuilder render = builder(List.of(), "render", file.toString(), "-o", folder.resolve("o") + "/");
        render.environment().put("LC_ALL", "C");
        Ended rendered = end(render);
        assertThat(folder.resolve("o").toFile().list()).contains("plain.png");
        assertThat(rendered.err()).contains("LC_ALL=C.UTF-8 has\n");
        ProcessBuilder list = builder(List.of(), "db", "list", file.toString(), "--csv", "--columns", "name");
        list.environment().put("LC_ALL", "C");
        assertThat(end(list).out()).isEqualTo("name\r\nŽluťoučký kůň\r\nplain\r\n");
    }

    @Test
    void aFileThatALocaleCannotNameIsSaidWhereTheSceneNamesIt() throws Exception {
        Path scene = Scenes.scene(folder.resolve("s.xml"), "<sphere radius=\"1\"><material><image file=\"dlaždice.png\"/></material></sphere>");
        String other = Files.createDirectory(folder.resolve("other")).resolve("s.xml").toString();
        for (String[] words : new String[][] {{"render", scene.toString()}, {"validate", scene.toString()}, {"convert", scene.toString(), other}}) {
            ProcessBuilder builder = builder(List.of(), words);
            builder.environment().put("LC_ALL", "C");
            Ended ended = end(builder);
            assertThat(ended.code()).isEqualTo(words[0].equals("convert") ? 1 : 3);
            assertThat(ended.err()).contains("s.xml:").contains(": there can be no file of this name: the locale (").endsWith("LC_ALL=C.UTF-8 has\n").doesNotContain("\tat ");
        }
    }

    private static String one(String name) {
        return "<scene name=\"" + name + "\"><render width=\"4\" height=\"4\"/><camera position=\"0 1 5\" direction=\"0 0 -1\"/></scene>";
    }

    @Test
    void aFolderWithAnAccentIsFoundInAnyLocale() throws Exception {
        Path scene = Scenes.ball(Files.createDirectory(folder.resolve("háček")).resolve("s.xml"));
        ProcessBuilder validate = builder(List.of(), "validate", scene.toString());
        validate.environment().put("LC_ALL", "C");
        Ended valid = end(validate);
        assertThat(valid.out()).endsWith("/s.xml: valid\n");
        assertThat(valid.code()).isZero();
    }

    @Test
    void aDiskThatIsTooFullIsToldBeforeARayIsTraced() throws Exception {
        Path scene = Scenes.ball(folder.resolve("s.xml"));
        Path disk = Files.createDirectory(folder.resolve("disk"));
        assumeTrue(mounted("mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", disk.toString()), "small disks can be mounted by root only");
        try {
            Run known = Run.cli("render", scene, "-o", disk.resolve("p.pfm"), "--size", "100x100");
            assertThat(known.code()).isEqualTo(1);
            assertThat(known.err()).contains("p.pfm: no space left on device: the picture takes at least 0.1 MB, but 0.1 MB are free").hasLineCount(1);
            // Text of eight decimals for each of many pixels: how much, is known only when it is written.
            Run unknown = Run.cli("render", scene, "-o", disk.resolve("p.lum"), "--size", "150x150");
            assertThat(unknown.code()).isEqualTo(1);
            assertThat(unknown.err()).contains("p.lum: no space left on device\n");
            assertThat(disk).isEmptyDirectory();
        } finally {
            mounted("umount", disk.toString());
        }
    }

    private static boolean mounted(String... command) throws Exception {
        return new ProcessBuilder(command).start().waitFor() == 0;
    }

    @Test
    void anInterruptedBatchHasItsLastObject() throws Exception {
        Path scene = Scenes.ball(folder.resolve("s.xml"));
        for (int i = 0; i < 3; i++) {
            Process process = builder(List.of(), "render", scene.toString(), "--size", "6000x6000", "--samples", "16", "--json",
                    "-o", folder.resolve("p.png").toString()).start();
            try (BufferedReader messages = process.errorReader(StandardCharsets.UTF_8)) {
                assertThat(messages.readLine()).contains("rendering");
                new ProcessBuilder("kill", "-TERM", Long.toString(process.pid())).start().waitFor();
                String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
                assertThat(out).contains("\"outcome\":\"interrupted\"").endsWith("}\n");
            } finally {
                process.destroyForcibly();
            }
        }
    }

    @Test
    void whatShellsReadHasTheirDigitsWhateverTheLanguage() throws Exception {
        List<String> arabic = List.of("-Duser.language=ar", "-Duser.country=EG", "-Duser.extensions=u-nu-arab");
        assertThat(end(builder(arabic, "generate-completion")).out()).contains("local cmds0=(render)").isEqualTo(end(builder(List.of(), "generate-completion")).out());
    }

    @Test
    void aNameThatBeginsWithADashIsAFileBehindADot() throws Exception {
        Scenes.ball(folder.resolve("-dash.xml"));
        Ended plain = end(builder(List.of(), "validate", "-dash.xml").directory(folder.toFile()));
        assertThat(plain.code()).isEqualTo(2);
        assertThat(plain.err()).contains("if it is a file, say ./-dash.xml");
        assertThat(end(builder(List.of(), "validate", "./-dash.xml").directory(folder.toFile())).code()).isZero();
    }
}
