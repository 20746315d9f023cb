package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import cz.paprsek.xml.SceneFiles;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Scenes that come through standard input or a pipe are read once, by every command. */
class IncomingTest {
    @TempDir
    Path folder;

    private byte[] ball;
    private byte[] broken;
    private byte[] database;

    @BeforeEach
    void makeFiles() throws IOException {
        // With a mark and a processing instruction, so that the quick reader hands it on.
        ball = ("\uFEFF" + Files.readString(Scenes.ball(folder.resolve("ball.xml"))) + "<?end?>").getBytes(StandardCharsets.UTF_8);
        broken = Files.readAllBytes(Scenes.broken(folder.resolve("broken.xml")));
        database = Files.readAllBytes(Path.of("../scenes/database.xml"));
    }

    /** A call that finds something on its standard input. */
    static Run fed(byte[] input, Object... arguments) {
        InputStream before = System.in;
        try {
            System.setIn(new ByteArrayInputStream(input));
            return Run.cli(arguments);
        } finally {
            System.setIn(before);
        }
    }

    /** A call with a named pipe in the place of {@code PIPE}. */
    private Run piped(byte[] input, Object... arguments) throws Exception {
        Path pipe = folder.resolve("pipe" + input.length + arguments.length);
        assumeTrue(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() == 0);
        Thread writer = new Thread(() -> {
            try (OutputStream output = Files.newOutputStream(pipe)) {
                output.write(input);
            } catch (IOException hungUp) {
                // The reader had seen enough.
            }
        });
        writer.start();
        Object[] given = List.of(arguments).stream().map(word -> word.equals("PIPE") ? pipe : word).toArray();
        Run run = Run.cli(given);
        writer.join(20_000);
        assertThat(writer.isAlive()).as("all was read").isFalse();
        Files.delete(pipe);
        return run;
    }

    @Test
    void aPictureComesOutOfWhatGoesIn() throws Exception {
        Path picture = folder.resolve("a.png");
        Path expected = folder.resolve("expected.png");
        assertThat(Run.cli("render", folder.resolve("ball.xml"), "-o", expected).code()).isZero();
        assertThat(fed(ball, "render", "-", "-o", picture, "--quiet").err()).isEmpty();
        assertThat(picture).hasSameBinaryContentAs(expected);
        assertThat(fed(ball, "render", "-", "-o", "-").bytes()).isEqualTo(Files.readAllBytes(expected));
        assertThat(piped(ball, "render", "PIPE", "-o", picture, "--quiet").code()).isZero();
        assertThat(picture).hasSameBinaryContentAs(expected);
        assertThat(piped(ball, "render", "PIPE", "-o", folder + "/", "--quiet").code()).isZero();
        assertThat(folder.resolve("ball.png")).as("named after the scene").hasSameBinaryContentAs(expected);
    }

    @Test
    void aDatabaseIsRenderedSceneByScene() throws Exception {
        Run run = fed(database, "render", "-", "--size", "8x6", "--where", "name like \"C%\"", "-o", folder.resolve("out") + "/", "--quiet");
        assertThat(run.code()).as(run.err()).isZero();
        assertThat(folder.resolve("out").toFile().list()).hasSizeGreaterThan(1).allMatch(name -> name.startsWith("C"));
    }

    @Test
    void whatIsWrongIsToldOnceByLine() throws Exception {
        for (Run run : List.of(fed(broken, "validate", "-"), fed(broken, "info", "-"), fed(broken, "render", "-", "-o", folder.resolve("a.png")),
                fed(broken, "explain", "-", "1,1"), fed(broken, "convert", "-", folder.resolve("a.pov")), fed(broken, "db", "list", "-"))) {
            assertThat(run.code()).isEqualTo(3);
            assertThat(run.err().lines()).containsExactly("-:2:9: sphere radius must be a finite number above 0, but is \"-2\"",
                    "-:3:9: <sphere> has no attribute \"raduis\"; did you mean \"radius\"?");
        }
        Run run = piped(broken, "render", "PIPE", "-o", folder.resolve("a.png"));
        assertThat(run.code()).isEqualTo(3);
        assertThat(run.err()).hasLineCount(2).contains(":2:9: sphere radius must be");
        assertThat(fed(new byte[0], "render", "-").err()).startsWith("-:1:1: this file is empty");
    }

    @Test
    void everyCommandThatTakesScenesTakesThem() throws Exception {
        assertThat(fed(ball, "validate", "-").out()).isEqualTo("-: valid\n");
        assertThat(fed(ball, "info", "-", "--json").out()).contains("\"file\":\"-\"");
        assertThat(fed(ball, "explain", "-", "8,4").out()).contains("sphere");
        assertThat(fed(ball, "convert", "-", folder.resolve("a.xml")).code()).isZero();
        assertThat(SceneFiles.read(folder.resolve("a.xml"))).isEqualTo(SceneFiles.read(folder.resolve("ball.xml")));
        assertThat(fed(database, "db", "list", "-").out()).contains("Gears");
        assertThat(fed(database, "db", "extract", "-", "Gears", "-o", folder.resolve("gears.xml")).code()).isZero();
        assertThat(fed(database, "explain", "-", "40,30", "--scene", "Gears").code()).isZero();
        assertThat(fed(ball, "db", "add", folder.resolve("my.xml"), "-").code()).isZero();
        assertThat(fed(ball, "db", "add", folder.resolve("my.xml"), "-", "--name", "again").code()).isZero();
        assertThat(SceneFiles.readDatabase(folder.resolve("my.xml")).names()).containsExactly("ball", "again");
        assertThat(piped(ball, "validate", "PIPE").code()).isZero();
        assertThat(piped(ball, "info", "PIPE").code()).isZero();
        assertThat(piped(ball, "explain", "PIPE", "8,4").code()).isZero();
        assertThat(piped(database, "db", "find", "PIPE", "--where", "radius > 2").code()).isZero();
    }

    @ParameterizedTest
    @ValueSource(strings = {"db add - ball.xml", "db remove - x", "db rename - x y", "db merge - other.xml", "db init -"})
    void whatIsToBeChangedMustBeAFile(String line) {
        Run run = fed(database, (Object[]) line.split(" "));
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains(": a database that is to be changed must be a file, but '-' is standard input\n");
        assertThat(Path.of("-")).doesNotExist();
    }

    @Test
    void recordedPicturesLieBesideFilesOnly() {
        Run run = fed(ball, "crosscheck", "-", "--recorded");
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).contains("'-' is not a file, and recorded pictures lie beside files");
    }
}
