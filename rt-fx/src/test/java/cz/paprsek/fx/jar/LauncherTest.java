package cz.paprsek.fx.jar;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Launcher;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A process of its own, on a machine without a screen. */
@EnabledOnOs(OS.LINUX)
@Timeout(60)
class LauncherTest {
    private record Started(int code, String out, String err) {}

    private static Started start(String display, String... words) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp", System.getProperty("java.class.path"));
        if (Runtime.version().feature() >= 24) {
            // As the jar's manifest says, which a class path has not: else Java warns of how JavaFX loads what it has in C.
            builder.command().add("--enable-native-access=ALL-UNNAMED");
        }
        builder.command().add(Launcher.class.getName());
        builder.command().addAll(List.of(words));
        builder.environment().remove("DISPLAY");
        if (!display.isEmpty()) {
            builder.environment().put("DISPLAY", display);
        }
        Process process = builder.start();
        process.getOutputStream().close();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor(50, TimeUnit.SECONDS)).isTrue();
        return new Started(process.exitValue(), out, err);
    }

    @ParameterizedTest
    @CsvSource({"--help, Usage: java -jar rt-fx.jar", "-h, Usage:", "--version, Paprsek ", "-V, Paprsek "})
    void helpAndVersionNeedNoScreen(String option, String words) throws Exception {
        Started editor = start("", option);
        assertThat(editor.out()).startsWith(words);
        assertThat(editor.err()).isEmpty();
        assertThat(editor.code()).isZero();
    }

    @ParameterizedTest
    @CsvSource({"'', DISPLAY is not set", ":4711, DISPLAY names cannot be opened"})
    void withoutAScreenOneLineSaysSo(String display, String words) throws Exception {
        Started editor = start(display, "scene.xml");
        assertThat(editor.err()).startsWith("paprsek: the editor needs a screen").contains(words).hasLineCount(1);
        assertThat(editor.code()).isEqualTo(1);
    }

    @Test
    void anUnknownOptionIsNoFile() throws Exception {
        Started editor = start("", "--fullscreen");
        assertThat(editor.err()).startsWith("paprsek: unknown option \"--fullscreen\"").hasLineCount(1);
        assertThat(editor.code()).isEqualTo(2);
    }
}
