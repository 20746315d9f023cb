package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import javafx.scene.control.ComboBox;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A mesh comes into the scene from the palette, out of its folder or from elsewhere. */
class MeshesInEditorTest {
    private static final String CORNER = "v 0 0 0\nv 30 0 0\nv 0 40 0\nv 0 0 50\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

    @TempDir
    Path folder;

    private Path scenes = Path.of("");
    private EditorGui editor;

    @BeforeEach
    void start() throws IOException {
        scenes = Files.createDirectories(folder.resolve("scenes"));
        Files.writeString(folder.resolve("corner.obj"), CORNER);
        editor = new EditorGui(folder.resolve("settings"), Scene.EMPTY);
    }

    @AfterEach
    void close() {
        editor.close();
    }

    private void open(Scene scene) throws Exception {
        Path file = scenes.resolve("scene.xml");
        SceneFiles.write(scene, file);
        editor.gui.act(() -> editor.editor.files().open(file));
        editor.gui.until("the scene is there", () -> editor.gui.stage().getTitle().startsWith("scene.xml"));
    }

    private SceneObject last() {
        return editor.model().scene().objects().get(editor.model().scene().objects().size() - 1);
    }

    @Test
    void oneFromElsewhereIsCopiedBesideTheSceneAndInASizeThatIsSeen() throws Exception {
        open(Scene.EMPTY.plus(SceneObject.of(new Sphere(1))));
        editor.dialogs.chosen = Optional.of(folder.resolve("corner.obj"));
        editor.dialogs.copies = true;
        editor.menu("menu-add-mesh");
        editor.gui.until("the mesh is there", () -> editor.model().scene().objects().size() == 2);
        assertThat(last().shape()).isInstanceOfSatisfying(Mesh.class, mesh -> {
            assertThat(mesh.file()).isEqualTo("corner.obj");
            assertThat(mesh.isRead()).isTrue();
        });
        assertThat(last().placement().scale().x()).isIn(0.1, 0.01);
        assertThat(scenes.resolve("corner.obj")).hasContent(CORNER.strip());
    }

    @Test
    void oneThatIsNotToBeCopiedStaysWhereItIs() throws Exception {
        open(Scene.EMPTY.plus(SceneObject.of(new Sphere(1))));
        editor.dialogs.chosen = Optional.of(folder.resolve("corner.obj"));
        editor.menu("menu-add-mesh");
        editor.gui.until("told", () -> editor.status().contains("corner.obj"));
        assertThat(editor.model().scene().objects()).hasSize(1);
        assertThat(scenes.resolve("corner.obj")).doesNotExist();
    }

    @Test
    void aSceneThatIsNotSavedYetTakesItAlongWhenItIs() throws Exception {
        editor.dialogs.chosen = Optional.of(folder.resolve("corner.obj"));
        editor.menu("menu-add-mesh");
        editor.gui.until("the mesh is there", () -> !editor.model().scene().objects().isEmpty());
        editor.dialogs.save = Optional.of(scenes.resolve("new.xml"));
        editor.gui.act(() -> editor.editor.files().save());
        assertThat(scenes.resolve("corner.obj")).hasContent(CORNER.strip());
        assertThat(SceneFiles.read(scenes.resolve("new.xml")).files()).containsExactly("corner.obj");
    }

    @Test
    void whatIsWrongWithAFileIsToldInALine() throws Exception {
        Path bad = Files.writeString(scenes.resolve("bad.stl"), "solid x\nfacet\nvertex 1 2\n");
        open(Scene.EMPTY);
        editor.dialogs.chosen = Optional.of(bad);
        editor.menu("menu-add-mesh");
        editor.gui.until("told", () -> editor.status().contains("line 3: z of a corner is missing"));
        assertThat(editor.dialogs.faults).isEmpty();
    }

    @Test
    void anotherOneIsChosenInTheSheet() throws Exception {
        Files.writeString(scenes.resolve("other.obj"), CORNER);
        open(Scene.EMPTY.plus(SceneObject.of(new Sphere(1))));
        editor.dialogs.chosen = Optional.of(folder.resolve("corner.obj"));
        editor.dialogs.copies = true;
        editor.menu("menu-add-mesh");
        editor.gui.until("the mesh is there", () -> editor.model().scene().objects().size() == 2);
        editor.dialogs.asked.clear();
        editor.dialogs.chosen = Optional.of(scenes.resolve("other.obj"));
        editor.gui.act(() -> editor.model().select(Set.of(ScenePath.body(1))));
        editor.gui.pulse();
        editor.gui.click("#shape-file-choose");
        assertThat(editor.dialogs.asked).containsExactly("mesh");
        assertThat(((Mesh) last().shape()).file()).isEqualTo("other.obj");
    }

    @Test
    void theSheetSaysThatOneIsMadeOfWhatItsFileSays() throws Exception {
        Files.writeString(scenes.resolve("two.mtl"), "newmtl red\nKd 0.8 0.1 0.1\n");
        Files.writeString(scenes.resolve("two.obj"), "mtllib two.mtl\nusemtl red\n" + CORNER);
        Files.writeString(scenes.resolve("one.obj"), CORNER);
        open(Scene.EMPTY.plus(SceneObject.of(Mesh.of("two.obj"))).plus(SceneObject.of(Mesh.of("one.obj"))));
        editor.gui.act(() -> editor.model().select(Set.of(ScenePath.body(0))));
        editor.gui.pulse();
        assertThat(chosenMaterial()).isEqualTo("as its file has it");
        editor.gui.act(() -> editor.model().select(Set.of(ScenePath.body(1))));
        editor.gui.pulse();
        assertThat(chosenMaterial()).isEqualTo("none: matte white");
    }

    private String chosenMaterial() {
        return Gui.on(() -> {
            @SuppressWarnings("unchecked")
            ComboBox<Object> choice = (ComboBox<Object>) editor.gui.stage().getScene().lookup("#material");
            return choice.getConverter().toString(choice.getValue());
        });
    }
}
