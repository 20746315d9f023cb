package cz.paprsek.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.standard.StandardScenes;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Renders in processes of their own, which are given too little memory: they say how much would do, and with that they are done. */
@Timeout(120)
class MemoryTest {
    private static final Pattern ADVICE = Pattern.compile("out of memory: (.*), but Java may use (\\d+) MB for everything; -Xmx(\\d+)m would do(.*)");

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "picture | 100 | a picture of 6000 × 3000 pixels takes 275 MB and its scene of 6 bodies 1 MB | , or render it in parts, region by region",
        "scene   | 60  | a scene of 200000 bodies takes 96 MB                                         | ''",
    })
    void whoRunsOutOfMemoryIsToldWhatTakesItAndHowMuchWouldDo(String what, int megabytes, String takes, String otherwise) throws Exception {
        Matcher advice = ADVICE.matcher(run(what, "-Xmx" + megabytes + "m"));
        assertThat(advice.matches()).as(advice.toString()).isTrue();
        assertThat(advice.group(1)).isEqualTo(takes);
        assertThat(Integer.parseInt(advice.group(2))).isLessThanOrEqualTo(megabytes + 16);
        assertThat(advice.group(4)).isEqualTo(otherwise);
        assertThat(run(what, "-Xmx" + advice.group(3) + "m")).isEqualTo("done");
    }

    @Test
    void whatTheRestOfTheProgramTakesIsNotBlamedOnTheScene() throws Exception {
        Matcher advice = ADVICE.matcher(run("rest", "-Xmx64m"));
        assertThat(advice.matches()).as(advice.toString()).isTrue();
        assertThat(Integer.parseInt(advice.group(3))).isGreaterThanOrEqualTo(96);
    }

    @Test
    void aFileThatMemoryCannotHoldIsToldLikeOneThatCannotBeRead(@TempDir Path folder) throws Exception {
        Path file = Files.writeString(folder.resolve("s.xml"), "<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 5' target='0 0 0'/>"
                + "<sphere radius='1' position='0 1 0'/>".repeat(200_000) + "</scene>");
        assertThat(run(file.toString(), "-Xmx24m")).isEqualTo(file + ": not enough memory for what is in this file; give Java more with -Xmx");
    }

    private static String run(String what, String limit) throws Exception {
        Process process = new ProcessBuilder(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), limit,
                "-Dstdout.encoding=UTF-8", "-Dsun.stdout.encoding=UTF-8", "-cp", System.getProperty("java.class.path"), Hungry.class.getName(), what)).redirectErrorStream(true).start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
        assertThat(process.waitFor(100, TimeUnit.SECONDS)).isTrue();
        return said;
    }

    /** Renders, and says what came of it. */
    static final class Hungry {
        private Hungry() {}

        public static void main(String[] what) {
            RenderSettings small = new RenderSettings(16, 16, 1, 1);
            Scene few = StandardScenes.few();
            try {
                switch (what[0]) {
                    case "picture" -> Renderer.render(few.withSettings(new RenderSettings(6000, 3000, 1, 1))).toArgb();
                    case "scene" -> Renderer.render(StandardScenes.cloud(200_000).withSettings(small));
                    case "rest" -> beside(new byte[35 << 20], few.withSettings(new RenderSettings(1500, 1500, 1, 1)));
                    default -> SceneFiles.read(Path.of(what[0]));
                }
                System.out.println("done");
            } catch (IllegalStateException | IOException | SceneFileException told) {
                System.out.println(told.getCause() instanceof OutOfMemoryError ? told.getMessage() : told);
            }
        }

        private static void beside(byte[] rest, Scene scene) {
            int[] pixels = Renderer.render(scene).toArgb();
            System.out.println(rest.length + pixels.length);
        }
    }
}
