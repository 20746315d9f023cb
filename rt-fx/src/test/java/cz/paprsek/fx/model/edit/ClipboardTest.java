package cz.paprsek.fx.model.edit;

import static cz.paprsek.fx.model.TestScenes.names;
import static cz.paprsek.scene.ScenePath.body;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.TestScenes;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class ClipboardTest {
    private final EditorState kitchen = TestScenes.kitchenState();

    @Test
    void whatIsCopiedIsASceneFile() throws SceneFileException {
        Scene copied = SceneFiles.parse(Clipboard.copy(kitchen, List.of(body(1), ScenePath.light(1))));
        assertThat(copied.objects()).containsExactly(kitchen.scene().objects().get(1));
        assertThat(copied.lights()).containsExactly(kitchen.scene().lights().get(1));
        assertThat(copied.materials()).containsOnlyKeys("red");
    }

    @Test
    void pastingIntoTheSameSceneGivesFreeNamesAndTheSelection() throws SceneFileException {
        EditorState after = Clipboard.paste(kitchen, Clipboard.copy(kitchen, List.of(body(0), body(1), ScenePath.light(0))));
        assertThat(names(after)).isEqualTo("ball, bowl, floor, ball 2, ball 3, bowl 2");
        assertThat(after.selection()).containsExactly(body(4), body(5), ScenePath.light(2));
        assertThat(after.scene().materials()).containsOnlyKeys("red");
    }

    @Test
    void materialsComeAlongAndDoNotOverwriteOthers() throws SceneFileException {
        EditorState other = EditorState.of(Scene.EMPTY.plus("red", Material.color(200, 30, 30)));
        EditorState after = Clipboard.paste(other, Clipboard.copy(kitchen, List.of(body(0))));
        assertThat(after.scene().objects().get(0).material()).isEqualTo(new MaterialName("red 2"));
        assertThat(after.scene().materials()).containsEntry("red 2", TestScenes.RED).containsEntry("red", Material.color(200, 30, 30));
    }

    @Test
    void operandIsCopiedAsAnObjectWhereItStands() throws SceneFileException {
        Scene copied = SceneFiles.parse(Clipboard.copy(kitchen, Set.of(body(1, 1, 0))));
        assertThat(copied.objects().get(0).placement().position()).isEqualTo(new Vec3(3.25, 0.5, 0));
        assertThat(copied.objects().get(0).material()).isEqualTo(TestScenes.BLUE);
    }

    @Test
    void whatIsNoSceneIsRefused() {
        assertThatThrownBy(() -> Clipboard.paste(kitchen, "shopping list")).isInstanceOf(SceneFileException.class);
        assertThatThrownBy(() -> Clipboard.paste(kitchen, SceneFiles.format(Scene.EMPTY))).hasMessageContaining("no objects or lights");
        assertThatThrownBy(() -> Clipboard.copy(kitchen, Set.of(ScenePath.camera()))).hasMessageContaining("select objects");
    }
}
