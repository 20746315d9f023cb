package cz.paprsek.cli;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.resume.Checkpoint;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Processes killed in the middle of their work, at random moments: the old file or the new one is there, whole. The number of kills is the system
 * property {@code paprsek.kills}, {@value #FEW} if not given.
 */
class KillTest {
    private static final int FEW = 6;
    private static final int KILLS = Integer.getInteger("paprsek.kills", FEW);

    @TempDir
    Path folder;

    /** Saves two scenes into one file, in turn, until it is killed. */
    static final class SavesForEver {
        private SavesForEver() {}

        public static void main(String[] args) throws IOException {
            Path file = Path.of(args[0]);
            for (int i = 0; ; i++) {
                SceneFiles.write(i % 2 == 0 ? small() : large(), file);
                System.out.println(i);
            }
        }
    }

    static Scene small() {
        return Scene.EMPTY.plus(Light.at(1, 2, 3));
    }

    static Scene large() {
        SceneObject[] balls = new SceneObject[20_000];
        Arrays.setAll(balls, i -> SceneObject.of(new Sphere(1 + i)));
        return Scene.EMPTY.plus(balls);
    }

    @Test
    void aSaveThatIsKilledLeavesTheOldFileOrTheNew() throws Exception {
        Path file = folder.resolve("scene.xml");
        List<String> whole = List.of(SceneFiles.format(small()), SceneFiles.format(large()));
        Random random = new Random(1);
        for (int i = 0; i < KILLS; i++) {
            Process process = java(SavesForEver.class, file);
            process.getInputStream().read();
            process.waitFor(random.nextInt(120), TimeUnit.MILLISECONDS);
            kill(process);
            assertThat(whole).contains(Files.readString(file));
        }
    }

    @Test
    void aRenderThatIsKilledLeavesTheOldPictureOrTheNew() throws Exception {
        Path picture = folder.resolve("picture.pfm");
        byte[] fresh = rendered(picture);
        byte[] old = {1, 2, 3};
        Random random = new Random(2);
        for (int i = 0; i < KILLS; i++) {
            Files.write(picture, old);
            Process process = java(Main.class, "render", "../scenes/lens.xml", "--size", "400x300", "-o", picture, "--quiet");
            process.waitFor(200 + random.nextInt(1200), TimeUnit.MILLISECONDS);
            kill(process);
            byte[] found = Files.readAllBytes(picture);
            assertThat(Arrays.equals(found, old) || Arrays.equals(found, fresh)).as("the picture is whole").isTrue();
        }
    }

    @Test
    void aRenderKilledAgainAndAgainIsDoneInTheEnd() throws Exception {
        Path picture = folder.resolve("picture.pfm");
        byte[] fresh = rendered(picture);
        Random random = new Random(3);
        for (int i = 0; i < KILLS; i++) {
            Files.deleteIfExists(picture);
            Process process = java(Main.class, "render", "../scenes/lens.xml", "--size", "400x300", "-o", picture, "--quiet", "--resume");
            process.waitFor(200 + random.nextInt(1200), TimeUnit.MILLISECONDS);
            kill(process);
        }
        assertThat(Run.cli("render", "../scenes/lens.xml", "--size", "400x300", "-o", picture, "--resume").code()).isEqualTo(ExitCode.DONE);
        assertThat(picture).hasBinaryContent(fresh);
        assertThat(Checkpoint.fileFor(picture)).doesNotExist();
    }

    private static byte[] rendered(Path picture) throws IOException {
        assertThat(Run.cli("render", "../scenes/lens.xml", "--size", "400x300", "-o", picture).code()).isEqualTo(ExitCode.DONE);
        return Files.readAllBytes(picture);
    }

    private static void kill(Process process) throws InterruptedException {
        process.destroyForcibly();
        process.waitFor();
    }

    private static Process java(Class<?> main, Object... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), main.getName()));
        for (Object argument : arguments) {
            command.add(argument.toString());
        }
        return new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
    }
}
