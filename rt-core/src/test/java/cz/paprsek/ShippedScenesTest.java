package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.image.Image;
import cz.paprsek.material.Rgb;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class ShippedScenesTest {
    static Stream<Arguments> scenes() throws IOException, SceneFileException {
        List<Path> files;
        try (Stream<Path> all = Files.list(Path.of("../scenes"))) {
            files = all.filter(file -> file.toString().endsWith(".xml")).sorted().toList();
        }
        List<Arguments> scenes = new ArrayList<>();
        for (Path file : files) {
            SceneFiles.readAll(file).forEach(scene -> scenes.add(Arguments.of(Named.of(file.getFileName() + ": " + scene.name(), scene))));
        }
        return scenes.stream();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everySceneRendersToSomethingToLookAt(Scene scene) {
        Scene small = scene.withSettings(scene.settings().withSize(160, 90).withSamples(1));
        Image image = Renderer.render(ShippedPictures.ready(small), RenderOptions.of(small), RenderMonitor.NONE).image();
        for (int y = 0; y < 90; y++) {
            for (int x = 0; x < 160; x++) {
                float sum = image.red(x, y) + image.green(x, y) + image.blue(x, y);
                assertThat(sum).isFinite().isNotNegative();
            }
        }
        assertThat(scene.tags()).isNotEmpty();
        assertThat(scene.description()).isNotEmpty();
        // Paths are random one by one: so many as are asked for are a picture, where rays on a grid show stairs.
        assertThat(scene.settings().isAdaptive() || scene.settings().integrator() == Integrator.PATH).as("as many rays as it needs").isTrue();
        assertThat(Arrays.stream(image.toArgb()).distinct().count()).as("different colours, but where nothing is to be seen").isGreaterThan(scene.tags().contains("proof") ? 0 : 200);
    }

    /** Whatever is in it, everything is as bright as its wall: emission · (1 + albedo + albedo² …), as often as light is scattered. */
    @Test
    void nothingIsToBeSeenInTheFurnace() throws Exception {
        Scene furnace = SceneFiles.read(Path.of("../scenes/furnace.xml"));
        Image image = Renderer.render(furnace.withSettings(furnace.settings().withSize(24, 18)));
        double albedo = Rgb.grey(188).linearRed();
        double expected = Rgb.grey(124).linearRed() * (1 - Math.pow(albedo, 25)) / (1 - albedo);
        double sum = 0;
        for (int i = 0; i < 24 * 18; i++) {
            assertThat((double) image.red(i % 24, i / 24)).isCloseTo(expected, within(0.06));
            sum += image.red(i % 24, i / 24);
        }
        assertThat(sum / (24 * 18)).isCloseTo(expected, within(0.001));
    }

    @Test
    void theDatabaseHasScenesEnoughAndIsWrittenAsItWouldBeSaved() throws Exception {
        Path file = Path.of("../scenes/database.xml");
        assertThat(SceneFiles.formatAll(SceneFiles.readAll(file))).isEqualTo(Files.readString(file));
        assertThat(SceneFiles.readDatabase(file).size()).isGreaterThanOrEqualTo(20);
        assertThat(SceneFiles.examples()).as("what a new database begins with").isEqualTo(SceneFiles.readDatabase(file));
    }
}
