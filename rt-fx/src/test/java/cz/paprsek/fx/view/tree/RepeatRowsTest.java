package cz.paprsek.fx.view.tree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.fx.model.edit.Structure;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.xml.SceneFiles;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** What is repeated is a line of the tree, and one thing in all edits. */
class RepeatRowsTest {
    private final EditorModel model = new EditorModel(read("stair"));

    private static Scene read(String name) {
        try {
            return SceneFiles.read(Path.of("../scenes", name + ".xml"));
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }

    private List<String> lines(BodyAt... expanded) {
        return new TreeRows(Texts.in(Locale.ENGLISH), Set.of(expanded), model.copies(), "").of(model.scene()).stream().map(TreeRow::text).toList();
    }

    @Test
    void copiesAreNotLaidOut() {
        assertThat(lines()).containsExactly("camera", "sun", "floor", "post", "step × 24", "bar × 24", "rail × 24");
        model.open(read("gear"));
        assertThat(lines(ScenePath.body(1), ScenePath.body(1, 0), ScenePath.body(1, 0, 1))).containsSubsequence("gear", "union", "cylinder", "teeth × 24", "teeth", "holes × 6", "pinion")
                .doesNotContain("teeth[1]");
        model.open(read("forest"));
        assertThat(lines()).contains("fir × 400").hasSize(4);
    }

    @Test
    void whoseCopyIsSelectedHasTheFirstAndAllFollow() {
        int third = model.scene().objects().size() - 1;
        model.select(ScenePath.body(third));
        assertThat(model.selection()).containsExactly(ScenePath.body(4));
        model.select(ScenePath.body(2 + 3 * 3));
        assertThat(model.selection()).containsExactly(ScenePath.body(2));
        Scene before = model.scene();
        Gesture drag = model.begin(Label.of(Edit.MOVE));
        drag.preview(scene -> Moves.translated(scene, model.selection(), new Vec3(0, 1, 0)));
        drag.preview(scene -> Moves.translated(scene, model.selection(), new Vec3(0, 0.5, 0)));
        drag.commit();
        assertThat(model.scene().objects()).hasSize(before.objects().size());
        for (int i = 2; i < before.objects().size(); i += 3) {
            Vec3 was = before.objects().get(i).placement().position();
            assertThat(model.scene().objects().get(i).placement().position().y()).isCloseTo(was.y() + 0.5, org.assertj.core.data.Offset.offset(1e-12));
        }
        assertThat(model.scene().recipe().text()).contains("count=\"{steps}\"", "<intersection name=\"step\" material=\"oak\" position=\"0 0.5 0\">");
        model.undo();
        assertThat(model.scene()).isSameAs(before);
    }

    @Test
    void deletingTheFirstDeletesAllAndGroupingTakesAll() {
        model.editState(Label.of(Edit.DELETE), state -> Structure.delete(state, Set.of(ScenePath.body(3))));
        assertThat(lines()).containsExactly("camera", "sun", "floor", "post", "step × 24", "rail × 24");
        model.select(ScenePath.body(2));
        model.editState(Label.of(Edit.GROUP), state -> Structure.combine(state, state.selection(), cz.paprsek.shape.Csg.Operation.UNION, "all"));
        assertThat(ScenePath.body(2).in(model.scene()).operands()).hasSize(24);
    }

    @Test
    void whatIsMadeByAFormulaOfItsNumberIsRefused() {
        model.open(read("forest"));
        Gesture drag = model.begin(Label.of(Edit.MOVE));
        assertThatThrownBy(() -> drag.preview(scene -> Moves.translated(scene, Set.of(ScenePath.body(1)), new Vec3(1, 0, 0)))).hasMessageContaining("each copy has a position of its own");
        drag.cancel();
    }
}
