package cz.paprsek.teach;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import cz.paprsek.image.Image;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.mistake.Mistake;
import cz.paprsek.teach.mistake.Mistakes;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class PlainTracerTest {
    private static final Path SCENES = Path.of("../scenes");
    /** In every build few pixels are looked at; the proof, which takes longer, is to be had by {@code -Dpaprsek.proof}. */
    private static final int WIDTH = System.getProperty("paprsek.proof") == null ? 32 : 480;

    static Stream<Named<Scene>> known() throws IOException {
        return all().stream().filter(scene -> PlainTracer.unknown(scene, scene.settings()).isEmpty()).map(scene -> Named.of(scene.name(), scene));
    }

    private static List<Scene> all() throws IOException {
        try (Stream<Path> files = Files.list(SCENES)) {
            return files.filter(file -> file.toString().endsWith(".xml")).sorted().flatMap(PlainTracerTest::read).toList();
        }
    }

    private static Stream<Scene> read(Path file) {
        try {
            return SceneFiles.readAll(file).stream();
        } catch (IOException | SceneFileException e) {
            throw new IllegalStateException(e);
        }
    }

    @ParameterizedTest
    @MethodSource("known")
    void withoutMistakesItIsTheRendererToTheLastBit(Scene scene) {
        RenderSettings settings = scene.settings().withSize(WIDTH, WIDTH * 9 / 16).withSamples(1);
        assertSame(scene, settings);
        assertSame(scene, settings.withSize(9, 5).withSamples(3));
    }

    private static void assertSame(Scene scene, RenderSettings settings) {
        Image right = Renderer.render(scene.withSettings(settings), RenderOptions.of(settings), RenderMonitor.NONE).image();
        Image plain = PlainTracer.of(scene, settings, Mistakes.NONE).render(() -> false);
        int different = 0;
        String first = "";
        for (int y = 0; y < right.height(); y++) {
            for (int x = 0; x < right.width(); x++) {
                if (right.red(x, y) != plain.red(x, y) || right.green(x, y) != plain.green(x, y) || right.blue(x, y) != plain.blue(x, y)) {
                    different++;
                    first = first.isEmpty() ? x + "," + y + ": " + right.red(x, y) + " " + plain.red(x, y) : first;
                }
            }
        }
        assertThat(different).as(first).isZero();
    }

    @Test
    void itKnowsADozenOfTheScenesAndSaysWhatItDoesNotKnowOfOthers() throws IOException, SceneFileException {
        assertThat(known()).hasSizeGreaterThan(5);
        Scene chess = SceneFiles.read(SCENES.resolve("chess.xml"));
        assertThatThrownBy(() -> PlainTracer.of(chess, chess.settings(), Mistakes.NONE)).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("mistakes are made by a plain tracer, to be read aloud, which does not know cone, torus");
    }

    /** Mistakes make rays that nobody else makes: what lies far behind, directions that are none, levels without end. */
    @Test
    void picturesWithAnyMistakeComeToAnEnd() throws IOException {
        Scene cube = all().stream().filter(scene -> scene.name().equals("Puzzle cube")).findFirst().orElseThrow();
        RenderSettings settings = cube.settings().withSize(64, 36).withSamples(1);
        assertTimeoutPreemptively(Duration.ofMinutes(1), () -> Stream.of(Mistake.values())
                .forEach(mistake -> assertThat(PlainTracer.of(cube, settings, Mistakes.of(mistake)).render(() -> false).width()).isEqualTo(64)));
    }
}
