package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class SceneFilesTest {
    static Stream<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("../scenes"))) {
            return files.filter(file -> file.toString().endsWith(".xml")).sorted().toList().stream();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everyShippedSceneIsWrittenAsItWasRead(Path file) throws Exception {
        Scene scene = SceneFiles.read(file);
        assertThat(SceneFiles.format(scene)).isEqualTo(Files.readString(file));
        assertThat(SceneFiles.parse(SceneFiles.format(scene))).isEqualTo(scene);
    }
}
