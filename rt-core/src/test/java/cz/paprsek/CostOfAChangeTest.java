package cz.paprsek;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** How many files know of one attribute, or of one shape: so many does the next one cost. docs/architecture.md says the numbers. */
class CostOfAChangeTest {
    /** The record that says it, the bean that reads it, and those who compute with just this one: that an exponent is one cannot be said in general. */
    @Test
    void anAttributeIsKnownWhereItIsSaidReadAndUsed() throws IOException {
        assertThat(filesThatKnow("\\b[sS]hininess\\b")).containsExactlyInAnyOrder(
                "Material.java", "MaterialBean.java",
                "Finish.java", "Paths.java", "Tracer.java", "LightSteps.java", "Exercise.java", "RayExercise.java", "PovMaterials.java", "MtlReader.java",
                "Wording.java");
    }

    /** The record, the list of solids and its bean; besides, whoever likes to do more for it: POV-Ray is told its form, it has an icon of its own, and another program's extrusion is one. */
    @Test
    void aShapeIsKnownWhereItIsMadeReadAndDrawn() throws IOException {
        assertThat(filesThatKnow("\\bTorus\\b|\"torus\"")).containsExactlyInAnyOrder(
                "Torus.java", "Solid.java", "ShapeBeans.java",
                "PovShapes.java", "Icons.java", "Extrusion.java");
    }

    private static List<String> filesThatKnow(String word) throws IOException {
        Pattern pattern = Pattern.compile(word);
        try (Stream<Path> files = Stream.of("rt-core", "rt-cli", "rt-fx").flatMap(CostOfAChangeTest::sources)) {
            return files.filter(file -> pattern.matcher(read(file)).find()).map(file -> String.valueOf(file.getFileName())).toList();
        }
    }

    private static Stream<Path> sources(String module) {
        try (Stream<Path> files = Files.walk(Path.of("..", module, "src/main/java"))) {
            return files.filter(file -> file.toString().endsWith(".java")).toList().stream();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
