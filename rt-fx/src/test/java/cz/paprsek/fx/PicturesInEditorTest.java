package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import javafx.scene.control.Labeled;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pictures for patterns and skies are chosen by a button, and the scene has them by names in its own folder. */
class PicturesInEditorTest {
    @TempDir
    Path folder;

    private Path scenes = Path.of("");
    private EditorGui editor;

    @BeforeEach
    void openASceneWithAPicture() throws Exception {
        scenes = folder.resolve("scenes");
        Files.createDirectories(scenes.resolve("pictures"));
        picture(scenes.resolve("pictures/red.png"), 1);
        Path file = scenes.resolve("scene.xml");
        SceneFiles.write(Scene.EMPTY.withSky(new Sky.Picture("pictures/none.png", 0, 1))
                .plus(SceneObject.of(new Sphere(1)).named("ball").madeOf(Material.DEFAULT.withPattern(Pattern.Picture.of("missing.png")))), file);
        editor = new EditorGui(folder.resolve("settings"), Scene.EMPTY);
        editor.gui.act(() -> editor.editor.files().open(file));
        editor.gui.until("the scene is there", () -> editor.gui.stage().getTitle().startsWith("scene.xml"));
    }

    @AfterEach
    void close() {
        editor.close();
    }

    private static void picture(Path file, double red) throws IOException {
        Image image = new Image(2, 2);
        image.set(0, 0, red, 0, 0);
        ImageFiles.write(image, file);
    }

    private void select(ScenePath... places) {
        editor.gui.act(() -> editor.model().select(Set.of(places)));
        editor.gui.pulse();
    }

    private String pattern() {
        return ((Pattern.Picture) ((Material) editor.model().scene().objects().get(0).material()).pattern()).file();
    }

    @Test
    void oneThatIsMissingIsToldInALineAndIsNoFaultOfTheProgram() {
        editor.gui.until("told", () -> editor.status().contains("none.png") || editor.status().contains("missing.png"));
        assertThat(editor.dialogs.faults).isEmpty();
    }

    /** Which are in the program itself, and come along when the scene is saved. */
    @Test
    void thoseOfAnExampleAreThereAndAreSavedWithIt() throws IOException {
        editor.menu("example-pictures");
        for (String name : editor.model().scene().files()) {
            assertThat(editor.model().assets().bytes(name).remaining()).as(name).isPositive();
        }
        Path saved = Files.createDirectories(folder.resolve("mine")).resolve("mine.xml");
        editor.dialogs.save = Optional.of(saved);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.S);
        assertThat(folder.resolve("mine/pictures/globe.png")).exists();
    }

    @Test
    void oneInTheFolderOrBelowIsTakenByItsNameThere() {
        editor.dialogs.chosen = Optional.of(scenes.resolve("pictures/red.png"));
        select(ScenePath.body(0));
        editor.gui.click("#pattern-file-choose");
        assertThat(editor.dialogs.asked).containsExactly("picture in scenes");
        assertThat(pattern()).isEqualTo("pictures/red.png");
        editor.gui.pulse();
        assertThat(Gui.on(() -> ((TextField) editor.gui.stage().getScene().lookup("#pattern-file")).getText())).isEqualTo("pictures/red.png");
        assertThat(Screenshots.save(editor.gui, "picture-chosen")).isNotEmptyFile();
        editor.gui.act(() -> editor.model().undo());
        assertThat(pattern()).isEqualTo("missing.png");
    }

    @Test
    void soIsOneForTheSkyByTheKeyboard() {
        editor.dialogs.chosen = Optional.of(scenes.resolve("pictures/red.png"));
        select();
        editor.gui.act(() -> editor.gui.stage().getScene().lookup("#sky-file-choose").requestFocus());
        editor.gui.keys(KeyCode.SPACE);
        assertThat(editor.model().scene().sky()).isEqualTo(new Sky.Picture("pictures/red.png", 0, 1));
    }

    @Test
    void oneFromElsewhereIsCopiedIfThatIsWishedAndKeepsOutOfTheWayOfOthers() throws IOException {
        Path elsewhere = Files.createDirectories(folder.resolve("elsewhere")).resolve("blue.png");
        picture(elsewhere, 0.5);
        picture(scenes.resolve("blue.png"), 0.1);
        editor.dialogs.chosen = Optional.of(elsewhere);
        select(ScenePath.body(0));
        editor.gui.click("#pattern-file-choose");
        assertThat(editor.dialogs.asked).containsExactly("picture in scenes", "copy blue.png");
        assertThat(pattern()).as("not wished").isEqualTo("missing.png");
        assertThat(((Labeled) editor.gui.node(".refusal")).getText()).contains("blue.png is not in the folder of the scene");
        editor.dialogs.copies = true;
        editor.gui.click("#pattern-file-choose");
        assertThat(pattern()).isEqualTo("blue-2.png");
        assertThat(scenes.resolve("blue-2.png")).hasSameBinaryContentAs(elsewhere);
        editor.gui.click("#pattern-file-choose");
        assertThat(pattern()).as("the same again").isEqualTo("blue-2.png");
        assertThat(scenes.resolve("blue-3.png")).doesNotExist();
    }

    @Test
    void aLinkThatLeadsOutIsElsewhere() throws IOException {
        Path elsewhere = folder.resolve("secret.png");
        picture(elsewhere, 0.5);
        editor.dialogs.chosen = Optional.of(Files.createSymbolicLink(scenes.resolve("link.png"), elsewhere));
        select(ScenePath.body(0));
        editor.gui.click("#pattern-file-choose");
        assertThat(editor.dialogs.asked).contains("copy link.png");
        assertThat(pattern()).isEqualTo("missing.png");
    }

    @Test
    void aSceneWithoutAFolderSaysSo() {
        editor.gui.act(() -> editor.editor.document().openedWithoutFile(editor.model().scene(), Assets.none()));
        select(ScenePath.body(0));
        editor.gui.click("#pattern-file-choose");
        assertThat(((Labeled) editor.gui.node(".refusal")).getText()).contains("Save the scene first");
        assertThat(editor.dialogs.asked).isEmpty();
    }
}
