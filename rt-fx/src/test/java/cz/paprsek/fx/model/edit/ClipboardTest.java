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
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
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
        assertThatThrownBy(() -> Clipboard.paste(kitchen, SceneFiles.format(Scene.EMPTY))).hasMessageContaining("nothing in the clipboard");
        assertThatThrownBy(() -> Clipboard.copy(kitchen, Set.of())).hasMessageContaining("select what is to be copied");
    }

    @Test
    void camerasAreCopiedAndPastedWithTheirLenses() throws SceneFileException {
        Camera wide = kitchen.scene().camera().withLens(Lens.Perspective.DEFAULT.withFovy(80).withAperture(0.1).withFocus(2));
        EditorState state = kitchen.withScene(kitchen.scene().withCameras(List.of(kitchen.scene().camera(), wide.named("wide"))));
        EditorState after = Clipboard.paste(state, Clipboard.copy(state, List.of(ScenePath.camera(1), ScenePath.camera(), ScenePath.light(0))));
        assertThat(after.scene().cameras()).containsExactly(kitchen.scene().camera(), wide.named("wide"), wide.named("wide 2"), kitchen.scene().camera().named("camera"));
        assertThat(after.selection()).containsExactly(ScenePath.light(2), ScenePath.camera(2), ScenePath.camera(3));
        assertThat(after.eye()).as("what is looked through stays").isEqualTo(state.eye());
        EditorState alone = Clipboard.paste(kitchen, Clipboard.copy(state, List.of(ScenePath.camera(1))));
        assertThat(alone.scene().cameras()).containsExactly(kitchen.scene().camera(), wide.named("wide"));
        assertThat(alone.selection()).containsExactly(ScenePath.camera(1));
        assertThat(Clipboard.paste(kitchen, Clipboard.copy(kitchen, List.of(body(0)))).scene().cameras()).as("the camera that any file needs stays there").hasSize(1);
    }

    @Test
    void lightsOfEveryKindAreCopiedAndPasted() throws SceneFileException {
        List<Light> lights = List.of(Light.at(1, 2, 3).withReferenceDistance(4), SpotLight.from(Vec3.Y, Vec3.X).withAngles(5, 20), SunLight.along(1, -2, 3).withDisc(2, true),
                AreaLight.disc(Vec3.Y, 0.5).shiningAt(Vec3.X), SphereLight.of(Vec3.Z, 0.25).withSamples(9));
        EditorState state = EditorState.of(Scene.EMPTY.withLights(lights));
        EditorState after = Clipboard.paste(state, Clipboard.copy(state, List.of(ScenePath.light(0), ScenePath.light(1), ScenePath.light(2), ScenePath.light(3), ScenePath.light(4))));
        assertThat(after.scene().lights().subList(5, 10)).isEqualTo(lights);
    }
}
