package cz.paprsek.pov;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Examples;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** That the words mean the same to POV-Ray is the cross-check's to show. */
class PovFilesTest {
    private static final Path FOLDER = Path.of("src/test/resources/pov");

    @Test
    void everythingIsWrittenInTheWordsOfPovRay(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("everything.pov");
        PovFiles.write(SceneFiles.read(FOLDER.resolve("everything.xml")), file);
        assertThat(Files.readString(file)).isEqualTo(Files.readString(FOLDER.resolve("everything.pov"), StandardCharsets.UTF_8));
    }

    @Test
    void whatIsNotExactIsSaid() throws Exception {
        Scene scene = SceneFiles.read(FOLDER.resolve("everything.xml"));
        assertThat(PovFiles.write(scene, new StringBuilder())).containsExactly(
                "POV-Ray does not sample pixels on a grid; for the same picture render it 2 times as wide and high, and average",
                "object 9: POV-Ray does not count rays that go straight through as a level of max-depth",
                "object 10 has surfaces of several refractive indices; POV-Ray knows one inside only and is told 1.5");
    }

    /** To render it larger and average would be the box filter. */
    @ParameterizedTest
    @CsvSource({"3, 0, MITCHELL, on a grid", "2, 8, GAUSS, at random", "2, 2, TENT, at random"})
    void aFilterThatPovRayHasNotIsSaid(int least, int most, PixelFilter filter, String how) throws Exception {
        Scene scene = Scene.EMPTY.withSettings(Scene.EMPTY.settings().withSamples(least, most).withFilter(filter));
        assertThat(PovFiles.write(scene, new StringBuilder())).containsExactly("POV-Ray does not sample pixels " + how + ", nor weighs their rays by the filter "
                + filter + "; it is given one ray through the centre of each");
        Scene oneRay = scene.withSettings(scene.settings().withSamples(1));
        assertThat(PovFiles.write(oneRay, new StringBuilder())).isEmpty();
    }

    static Stream<Described> attributesOfMaterials() {
        return Described.inline(Material.class).stream();
    }

    /** An attribute that comes later is told to POV-Ray, or a sentence says that it is not. */
    @ParameterizedTest
    @MethodSource("attributesOfMaterials")
    void noAttributeOfAMaterialIsLostWithoutAWord(Described one) throws Exception {
        Map<String, String> attributes = new LinkedHashMap<>(Map.of("specular", "0.5", "transparency", "0.5", "refractive-index", "1.5", "reflection", "0.5", "attenuation-color", "90 90 90",
                "emission", "90 90 90"));
        String before = everything(attributes);
        attributes.put(one.name(), switch (one.says().value().form()) {
            case COLOR -> "1 2 3";
            case FLAG -> String.valueOf(one.says().otherwise().equals("false"));
            case WORD -> Arrays.stream(one.type().getEnumConstants()).map(constant -> Described.word((Enum<?>) constant))
                    .filter(word -> !word.equals(one.says().otherwise())).findFirst().orElseThrow();
            default -> "0.75";
        });
        assertThat(everything(attributes)).isNotEqualTo(before);
    }

    /** What is written of a scene with a ball of such a material, and the sentences. */
    private static String everything(Map<String, String> attributes) throws Exception {
        StringBuilder text = new StringBuilder("<scene xmlns='" + SceneFiles.NAMESPACE + "'><camera position='0 0 5' direction='0 0 -1'/><sphere radius='1'><material");
        attributes.forEach((name, value) -> text.append(' ').append(name).append("='").append(value).append('\''));
        StringBuilder out = new StringBuilder();
        List<String> warnings = PovFiles.write(SceneFiles.parse(text.append("/></sphere></scene>").toString()), out);
        return out + String.join("\n", warnings);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, 1})
    void totalReflectionIsExactOnlyIfNoLightIsLost(double transparency) throws Exception {
        String xml = "<scene xmlns='" + SceneFiles.NAMESPACE + "'>"
                + "<camera position='0 0 5' direction='0 0 -1'/><sphere radius='1'><material transparency='" + transparency
                + "' refractive-index='1.5'/></sphere></scene>";
        List<String> warnings = PovFiles.write(SceneFiles.parse(xml), new StringBuilder());
        if (transparency == 1) {
            assertThat(warnings).isEmpty();
        } else {
            assertThat(warnings).singleElement().asString().contains("we give back reflection + transparency = 0.5");
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-4, 1e6})
    void aSceneOfASizeThatPovRayCannotHandleIsSaidToBeSo(double size) throws Exception {
        Scene scene = Scene.EMPTY.withCamera(Camera.looking(new Vec3(0, 0, size), new Vec3(0, 0, -1))).plus(SceneObject.of(new Sphere(size / 9)));
        assertThat(PovFiles.write(scene, new StringBuilder())).singleElement().asString().contains("scale it to about 1 to 100");
    }

    static List<Shape> shapes() {
        return List.copyOf(Examples.ALL.values());
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void thereAreWordsForEveryShape(Shape shape) throws IOException {
        StringBuilder text = new StringBuilder();
        PovFiles.write(Scene.EMPTY.plus(SceneObject.of(shape)), text);
        assertThat(text.chars().filter(c -> c == '{').count()).isEqualTo(text.chars().filter(c -> c == '}').count());
    }

    @ParameterizedTest
    @CsvSource({"samples=\"2..8\", at random", "samples=\"3\" filter=\"tent\", nor weighs their rays by the filter tent", "samples=\"3\", on a grid"})
    void howManyRaysAPixelTakesIsTold(String attributes, String told) throws Exception {
        String xml = "<scene xmlns=\"urn:paprsek:scene:1\"><render " + attributes + "/><camera position=\"0 0 9\" direction=\"0 0 -1\"/><point-light position=\"1 2 3\"/><sphere radius=\"1\"/></scene>";
        List<String> warnings = PovFiles.write(SceneFiles.parse(xml), new StringBuilder());
        assertThat(warnings).singleElement().asString().contains(told);
    }
}
