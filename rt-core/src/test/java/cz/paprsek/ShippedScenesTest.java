package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class ShippedScenesTest {
    static Stream<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("../scenes"))) {
            return files.filter(file -> file.toString().endsWith(".xml")).sorted().toList().stream();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everySceneRendersToSomethingToLookAt(Path file) throws Exception {
        Scene scene = SceneFiles.read(file);
        Image image = Renderer.render(scene.withSettings(scene.settings().withSize(160, 90).withSamples(1)));
        for (int y = 0; y < 90; y++) {
            for (int x = 0; x < 160; x++) {
                float sum = image.red(x, y) + image.green(x, y) + image.blue(x, y);
                assertThat(sum).isFinite().isNotNegative();
            }
        }
        assertThat(Arrays.stream(image.toArgb()).distinct().count()).as("different colours").isGreaterThan(200);
    }
}
