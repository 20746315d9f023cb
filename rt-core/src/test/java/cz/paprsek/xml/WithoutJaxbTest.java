package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What is left of the library where all other libraries are missing. */
@Timeout(120)
class WithoutJaxbTest {
    private static final Path SCENE = Path.of("../scenes/showcase.xml");
    private static final Path DATABASE = Path.of("../scenes/database.xml");

    @TempDir
    Path folder;

    /** And of Java no more than its base: no parser, no validator, no AWT. */
    @Test
    void goodFilesAreReadAndRendered() throws Exception {
        assertThat(run("java.base", ownClasses(), SCENE, DATABASE)).isEqualTo(String.valueOf(checksum(SceneFiles.read(SCENE))) + "\n"
                + SceneFiles.readDatabase(DATABASE).size() + "\n");
    }

    @Test
    void ofAFileThatIsNotGoodOneLineSaysWhatIsMissing() throws Exception {
        Path wrong = Files.writeString(folder.resolve("wrong.xml"), "<scene xmlns='urn:paprsek:scene:1'><sphere raduis='1'/></scene>");
        String sentence = wrong + ": something is wrong with this file, or unusual; to tell what, the library %s (JAXB) is needed, which is missing on the class path\n";
        assertThat(run("java.base,java.xml", ownClasses(), wrong, wrong)).isEqualTo(String.format(sentence, "jakarta.xml.bind-api"));
        assertThat(run("java.base,java.xml,java.logging", all("jaxb-runtime"), wrong, wrong)).isEqualTo(String.format(sentence, "jaxb-runtime"));
        assertThat(run("java.base,java.xml,java.logging", all("jaxb-core"), wrong, wrong)).isEqualTo(String.format(sentence, "jaxb-core"));
    }

    private static String ownClasses() {
        return Stream.of(SceneFiles.class, WithoutJaxbTest.class).map(WithoutJaxbTest::place).collect(Collectors.joining(File.pathSeparator));
    }

    private static String place(Class<?> type) {
        try {
            return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI()).toString();
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Everything but one library. */
    private static String all(String without) {
        return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator)).filter(entry -> !entry.contains(without))
                .collect(Collectors.joining(File.pathSeparator));
    }

    private static String run(String modules, String classPath, Path scene, Path database) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "--limit-modules", modules, "-cp", classPath,
                Reader.class.getName(), scene.toString(), database.toString()).redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(said).isZero();
        return said;
    }

    private static int checksum(Scene scene) {
        Image image = Renderer.render(scene.withSettings(scene.settings().withSize(48, 36)));
        return Arrays.hashCode(image.toArgb());
    }

    /** The other process. */
    static final class Reader {
        private Reader() {}

        public static void main(String[] files) throws Exception {
            PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
            try {
                out.println(checksum(SceneFiles.read(Path.of(files[0]))));
                out.println(DatabaseFile.open(Path.of(files[1])).database().size());
            } catch (IOException missing) {
                out.println(missing.getMessage());
            }
        }
    }
}
