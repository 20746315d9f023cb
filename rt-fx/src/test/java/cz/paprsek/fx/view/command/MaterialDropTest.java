package cz.paprsek.fx.view.command;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.util.Locale;
import org.junit.jupiter.api.Test;

class MaterialDropTest {
    private static final Scene GOLD = Scene.EMPTY.plus("gold", Material.color(255, 196, 70));

    private final EditorModel model = new EditorModel(Scene.EMPTY.plus(SceneObject.of(new Sphere(1)).named("ball")));
    private final Edits edits = new Edits(model, Texts.in(Locale.ENGLISH));

    @Test
    void onlyOneMaterialAndNothingElseIsDroppedOnABody() {
        assertThat(MaterialDrop.material(SceneFiles.format(GOLD))).get().extracting(Scene::materials).isEqualTo(GOLD.materials());
        assertThat(MaterialDrop.material(SceneFiles.format(GOLD.plus("steel", Material.color(180, 190, 200))))).isEmpty();
        assertThat(MaterialDrop.material(SceneFiles.format(GOLD.plus(SceneObject.of(new Sphere(1)))))).isEmpty();
        assertThat(MaterialDrop.material("gold")).isEmpty();
        assertThat(MaterialDrop.material("")).isEmpty();
    }

    @Test
    void theBodyIsMadeOfItInOneStepAndSelected() {
        Scene before = model.scene();
        edits.give(ScenePath.body(0), GOLD);
        assertThat(model.scene().objects().get(0).material()).isEqualTo(new MaterialName("gold"));
        assertThat(model.selection()).containsExactly(ScenePath.body(0));
        model.undo();
        assertThat(model.scene()).isSameAs(before);
    }

    @Test
    void whatABodyCannotBeMadeOfIsRefusedInASentence() {
        Material board = Material.DEFAULT.withPattern(new Pattern.Checkerboard(2, 2, Rgb.WHITE, Rgb.BLACK));
        edits.give(ScenePath.body(0), Scene.EMPTY.plus("board", board));
        assertThat(edits.refusalProperty().get()).contains("checkerboard");
        assertThat(model.scene().materials()).isEmpty();
    }
}
