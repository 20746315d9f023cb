package cz.paprsek.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.image.Image;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Bodies of a scene that become definitions. */
@Timeout(60)
class DefinedTest {
    @TempDir
    private Path folder;

    private static Scene scene(String inside) throws SceneFileException {
        return SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><render width='48' height='27'/><camera position='0 2 9' target='0 0 0'/><point-light position='2 5 6'/>" + inside + "</scene>");
    }

    private static float[] picture(Scene scene) {
        Image image = Renderer.render(RenderScene.of(scene), RenderOptions.of(scene), RenderMonitor.NONE).image();
        float[] all = new float[3 * image.width() * image.height()];
        for (int i = 0; i < image.width() * image.height(); i++) {
            all[3 * i] = image.red(i % image.width(), i / image.width());
            all[3 * i + 1] = image.green(i % image.width(), i / image.width());
            all[3 * i + 2] = image.blue(i % image.width(), i / image.width());
        }
        return all;
    }

    @Test
    void thePictureStaysAndTheFileKeepsIt() throws Exception {
        Path file = Files.writeString(folder.resolve("bowl.xml"), "<scene xmlns='urn:paprsek:scene:1'>\n <!-- one --><render width='48' height='27'/><camera position='0 2 9' target='0 0 0'/>"
                + "<point-light position='2 5 6'/>\n <param name='r' value='1.2'/>\n"
                + " <difference name='bowl' position='1 0.1 0' rotation='10 20 33' scale='0.7'><material color='200 90 60'/><sphere radius='{r}'/><block min='-2 0 -2' max='2 2 2' rotation='5 0 0'/></difference>\n"
                + "</scene>\n");
        SceneFile opened = SceneFiles.open(file);
        Scene before = opened.scene();
        Scene defined = SceneFiles.defined(before, List.of(0), "bowl");
        assertThat(defined.withRecipe(Recipe.NONE)).isEqualTo(before.withRecipe(Recipe.NONE));
        assertThat(picture(defined)).isEqualTo(picture(before));
        opened.save(defined);
        assertThat(Files.readString(file)).contains("<!-- one -->", "<define name=\"bowl\">", "radius='{r}'", "<instance of=\"bowl\" name='bowl' position='1 0.1 0' rotation='10 20 33' scale='0.7'");
        Scene again = SceneFiles.read(file);
        assertThat(picture(again)).isEqualTo(picture(before));
        assertThat(SceneFiles.makers(again)).singleElement().satisfies(maker -> assertThat(maker.attribute("of")).isEqualTo("bowl"));
        Scene two = SceneFiles.usedAgain(again, 0, 2.5);
        assertThat(two.objects()).hasSize(2);
        assertThat(two.objects().get(1).placement().position()).isEqualTo(new Vec3(3.5, 0.1, 0));
        assertThat(two.objects().get(1).shape()).isEqualTo(before.objects().get(0).shape());
        Scene three = SceneFiles.usedAgain(two, 0, -2.5);
        assertThat(three.objects().subList(0, 2)).as("all others keep their numbers").isEqualTo(two.objects());
    }

    @Test
    void operandsCopiesAndInstancesMayBeDefinitionsToo() throws Exception {
        Scene plain = scene("<union position='0 1 0'><sphere radius='1' position='-1 0 0'/><sphere radius='1' position='{0.5*2} 0 0'/></union>"
                + "<repeat name='row' count='3' position='2 0 0'><block min='-4 -1 -1' max='-3 0 0' rotation='0 {10*i} 0'/></repeat>");
        for (List<Integer> body : List.of(List.of(0), List.of(0, 1), List.of(1))) {
            Scene defined = SceneFiles.defined(plain, body, "it");
            assertThat(defined.withRecipe(Recipe.NONE)).as("%s", body).isEqualTo(plain.withRecipe(Recipe.NONE));
            assertThat(defined.recipe().text()).contains("<define name=\"it\">", "<instance of=\"it\"");
            assertThat(SceneFiles.read(write(defined)).withRecipe(Recipe.NONE)).isEqualTo(plain.withRecipe(Recipe.NONE));
        }
        Scene twice = SceneFiles.defined(SceneFiles.defined(plain, List.of(0, 0), "it"), List.of(0, 1), "it");
        assertThat(twice.recipe().text()).contains("<define name=\"it\">", "<define name=\"it-2\">");
        Scene whole = SceneFiles.defined(plain, List.of(0), "it");
        assertThatThrownBy(() -> SceneFiles.defined(whole, List.of(0, 1), "part")).hasMessageContaining("made by a definition");
        Scene byFormula = SceneFiles.defined(plain, List.of(0, 1), "it");
        assertThat(SceneFiles.usedAgain(byFormula, 0, 1.5).recipe().text()).contains("position=\"{0.5*2 + 1.5} 0 0\"");
    }

    /** The x of a use by a formula, as it is written, and what it comes to 1.5 beside that. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"{r}|3.5", "-{r}|-0.5", "+{r}|3.5", "{r > 1 ? r : 5}|3.5", "{r == 2 or r == 3}|2.5", "2{r}|23.5", "{all}|3.5", "2e0|3.5"})
    void anotherUseStandsBesideWhateverFormulaSaysWhere(String x, double moved) throws Exception {
        Scene one = scene("<param name='r' value='2'/><param name='all' value='2 0 0'/><define name='it'><sphere radius='1'/></define>"
                + "<instance of='it' position='" + x + (x.equals("{all}") ? "" : " 0 {r - 2}") + "'/>");
        Scene two = SceneFiles.usedAgain(one, 0, 1.5);
        assertThat(two.objects()).hasSize(2);
        assertThat(two.objects().get(1).placement().position()).isEqualTo(new Vec3(moved, 0, 0));
    }

    @Test
    void whatIsNoUseCannotBeUsedAgain() throws Exception {
        Scene row = scene("<repeat count='3' position='2 0 0'><sphere radius='1'/></repeat>");
        for (int maker : new int[] {-1, 0, 7}) {
            assertThatThrownBy(() -> SceneFiles.usedAgain(row, maker, 1)).isInstanceOf(IllegalArgumentException.class).hasMessage("there is no use of a definition with the number " + maker);
        }
        Scene odd = scene("<define name='it'><sphere radius='1'/></define><repeat count='3' position='2 0 0'><instance of='it' position='1{i} 0 0'/></repeat>");
        assertThatThrownBy(() -> SceneFiles.usedAgain(odd, 1, 1)).hasMessage("where this is, \"1{i} 0 0\" says, to which nothing can be added; write its x as one formula in braces");
    }

    @Test
    void aSceneWithoutFormulasHasOneThen() {
        Scene scene = Scene.EMPTY.withSettings(new RenderSettings(48, 27, 5, 1)).plus(cz.paprsek.scene.SceneObject.of(new cz.paprsek.shape.Sphere(1)).at(1, 2, 3));
        Scene defined = SceneFiles.defined(scene, List.of(0), "ball");
        assertThat(defined.withRecipe(Recipe.NONE)).isEqualTo(scene);
        assertThat(SceneFiles.format(defined)).contains("<instance of=\"ball\" position=\"1 2 3\"/>");
    }

    private Path write(Scene scene) throws Exception {
        Path file = folder.resolve("written.xml");
        SceneFiles.write(scene, file);
        return file;
    }
}
