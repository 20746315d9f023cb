package cz.paprsek.fx.view.tree;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.Screenshots;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.fx.model.edit.Structure;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.command.SelectionCommands;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import javafx.scene.Node;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.input.ContextMenuEvent;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.stage.Window;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;

@TestInstance(Lifecycle.PER_CLASS)
class ObjectTreeTest {
    private final Scene start = Scene.EMPTY
            .plus(Light.at(1, 2, 3).named("key"))
            .plus(Light.at(4, 5, 6).named("fill"))
            .plus(SceneObject.of(new Sphere(0.5)).named("ball"),
                    SceneObject.of(Csg.difference(Operand.of(new Sphere(1)).named("outer"), Operand.of(new Block(Vec3.ZERO, Vec3.ONE)))).named("bowl"),
                    SceneObject.of(new Rectangle(-1, -1, 1, 1)).named("floor"),
                    SceneObject.of(new Sphere(2)).named("moon"));
    private final EditorModel model = new EditorModel(start);
    private final Gui gui = Gui.show(() -> new ObjectTree(model, Texts.in(Locale.ENGLISH), new SelectionCommands(new Edits(model, Texts.in(Locale.ENGLISH)))), 260, 420);

    @BeforeEach
    void openTheScene() {
        // So that no click is the second of two.
        gui.click(find());
        gui.act(() -> {
            model.open(start);
            find().clear();
            list().requestFocus();
        });
        gui.pulse();
    }

    @AfterAll
    void close() {
        gui.close();
    }

    @Test
    void showsCameraLightsAndObjectsAndOperandsWithinTheirOperation() {
        assertThat(texts()).containsExactly("camera", "key", "fill", "ball", "bowl", "floor", "moon");
        gui.click(part("bowl", ".row-arrow"));
        assertThat(texts()).containsExactly("camera", "key", "fill", "ball", "bowl", "outer", "block", "floor", "moon");
        gui.act(() -> model.select(ScenePath.body(1, 1), ScenePath.light(0)));
        Screenshots.save(gui, "tree-light");
        gui.act(() -> Theme.DARK.applyTo(gui.stage().getScene()));
        Screenshots.save(gui, "tree-dark");
        gui.act(() -> Theme.LIGHT.applyTo(gui.stage().getScene()));
    }

    @Test
    void operationsStayOpenWhileTheyAreEditedAndAreClosedInAnotherFile() {
        gui.click(part("bowl", ".row-arrow"));
        gui.act(() -> model.editState(cz.paprsek.fx.model.Label.of(Edit.DELETE), state -> Structure.delete(state, Set.of(ScenePath.body(0)))));
        assertThat(texts()).containsExactly("camera", "key", "fill", "bowl", "outer", "block", "floor", "moon");
        gui.act(() -> model.open(model.scene()));
        assertThat(texts()).containsExactly("camera", "key", "fill", "bowl", "floor", "moon");
        gui.act(() -> model.open(Scene.EMPTY));
        assertThat(texts()).containsExactly("camera");
    }

    @Test
    void clicksSelectOneMoreAndRanges() {
        gui.click(cell("ball"));
        assertThat(model.selection()).containsExactly(ScenePath.body(0));
        gui.hold(KeyCode.SHIFT);
        gui.click(cell("moon"));
        gui.letGo(KeyCode.SHIFT);
        assertThat(model.selection()).containsExactly(ScenePath.body(0), ScenePath.body(1), ScenePath.body(2), ScenePath.body(3));
        gui.hold(KeyCode.CONTROL);
        gui.click(cell("bowl"));
        gui.letGo(KeyCode.CONTROL);
        assertThat(model.selection()).containsExactly(ScenePath.body(0), ScenePath.body(2), ScenePath.body(3));
    }

    @Test
    void keysGoThroughTheLinesAndIntoOperations() {
        gui.click(cell("ball"));
        gui.keys(KeyCode.DOWN);
        gui.keys(KeyCode.RIGHT);
        gui.keys(KeyCode.RIGHT);
        assertThat(model.selection()).containsExactly(ScenePath.body(1, 0));
        gui.keys(KeyCode.SHIFT, KeyCode.DOWN);
        assertThat(model.selection()).containsExactly(ScenePath.body(1, 0), ScenePath.body(1, 1));
        gui.keys(KeyCode.LEFT);
        assertThat(model.selection()).containsExactly(ScenePath.body(1));
        gui.keys(KeyCode.HOME);
        assertThat(model.selection()).containsExactly(ScenePath.camera());
        gui.keys(KeyCode.CONTROL, KeyCode.A);
        assertThat(model.selection()).hasSize(8).doesNotContain(ScenePath.camera());
    }

    @Test
    void whatIsSelectedElsewhereIsOpenedAndMarked() {
        gui.act(() -> model.select(ScenePath.body(1, 1)));
        gui.until("the operand is shown", () -> list().getItems().stream().anyMatch(row -> row.text().equals("block")));
        assertThat(cell("block").getPseudoClassStates()).anyMatch(state -> state.getPseudoClassName().equals("chosen"));
    }

    @Test
    void nameIsChangedInPlace() {
        gui.click(cell("moon"));
        gui.keys(KeyCode.F2);
        gui.until("the name can be changed", () -> gui.stage().getScene().getFocusOwner() instanceof TextField);
        gui.keys(KeyCode.X);
        gui.keys(KeyCode.ENTER);
        assertThat(model.scene().objects().get(3).name()).isEqualTo("x");
        gui.act(model::undo);
        assertThat(model.scene()).isSameAs(start);
    }

    @Test
    void takenNameIsRefusedInWords() {
        gui.act(() -> model.select(ScenePath.body(3)));
        gui.keys(KeyCode.F2);
        gui.act(() -> ((TextField) gui.stage().getScene().getFocusOwner()).setText("ball"));
        gui.keys(KeyCode.ENTER);
        assertThat(model.scene()).isSameAs(start);
        assertThat(((Label) gui.node(".refusal")).getText()).contains("already an object named \"ball\"");
    }

    @Test
    void eyeAndLockHideAndLock() {
        gui.moveTo(cell("ball"), 20, 10);
        gui.click(part("ball", ".row-eye"));
        gui.click(part("ball", ".row-lock"));
        assertThat(model.state().isHidden(ScenePath.body(0))).isTrue();
        assertThat(model.state().isLocked(ScenePath.body(0))).isTrue();
        gui.click(part("ball", ".row-eye"));
        assertThat(model.state().isHidden(ScenePath.body(0))).isFalse();
        assertThat(model.selection()).isEmpty();
    }

    /** What can be clicked at the end of a line is in sight however long the name is; a hint has all of that. */
    @Test
    void aLongNameLeavesRoomForEyeAndLock() {
        String name = "a ball of which there is very much to be said in its name";
        gui.act(() -> model.open(Scene.EMPTY.plus(SceneObject.of(new Sphere(1)).named(name))));
        gui.until("it is shown", () -> cells().stream().anyMatch(cell -> cell.getItem().text().equals(name)));
        gui.moveTo(cell(name), 20, 10);
        gui.pulse();
        Node eye = part(name, ".row-eye");
        assertThat(Gui.on(() -> eye.localToScene(eye.getLayoutBounds()).getMaxX())).isLessThanOrEqualTo(Gui.on(() -> list().getWidth()));
        Label label = (Label) part(name, ".label");
        assertThat(Gui.on(() -> label.getTooltip().getText())).isEqualTo(name);
        assertThat(Gui.on(() -> label.localToScene(label.getLayoutBounds()).getMaxX())).isLessThanOrEqualTo(Gui.on(() -> eye.localToScene(eye.getLayoutBounds()).getMinX()));
    }

    @Test
    void draggedLinesAreReordered() {
        dragTo("ball", "moon", 0.9);
        assertThat(names()).containsExactly("bowl", "floor", "moon", "ball");
        gui.act(model::undo);
        gui.pulse();
        dragTo("fill", "key", 0.1);
        assertThat(model.scene().lights()).extracting(Light::name).containsExactly("fill", "key");
    }

    @Test
    void solidDraggedIntoAnOperationBecomesItsOperandAndASurfaceIsRefused() {
        dragTo("moon", "bowl", 0.5);
        assertThat(names()).containsExactly("ball", "bowl", "floor");
        assertThat(((Csg) model.scene().objects().get(1).shape()).operands()).extracting(Operand::name).containsExactly("outer", "", "moon");
        gui.pulse();
        dragTo("floor", "bowl", 0.5);
        assertThat(((Label) gui.node(".refusal")).getText()).contains("has no inside");
    }

    @Test
    void escapeCancelsADrag() {
        Node from = cell("ball");
        Node to = cell("moon");
        gui.moveTo(from, 40, 10);
        gui.press(MouseButton.PRIMARY);
        gui.moveTo(to, 40, 24);
        gui.keys(KeyCode.ESCAPE);
        gui.release(MouseButton.PRIMARY);
        assertThat(model.scene()).isSameAs(start);
    }

    @Test
    void lettersFind() {
        gui.click(cell("ball"));
        gui.keys(KeyCode.O);
        gui.until("letters go to the field", () -> find().getText().equals("o"));
        gui.act(() -> find().setText("outer"));
        assertThat(texts()).containsExactly("bowl", "outer");
        gui.keys(KeyCode.ENTER);
        assertThat(model.selection()).containsExactly(ScenePath.body(1, 0));
    }

    @Test
    void menuCombinesAndDissolves() {
        gui.act(() -> model.select(ScenePath.body(0), ScenePath.body(3)));
        fire("object-union");
        assertThat(names()).containsExactly("union", "bowl", "floor");
        fire("object-dissolve");
        assertThat(names()).containsExactly("ball", "moon", "bowl", "floor");
        gui.act(() -> model.editState(cz.paprsek.fx.model.Label.of(Edit.LOCK),
                state -> Structure.lock(state, List.of(ScenePath.body(1)), true)));
        fire("edit-menu-delete");
        assertThat(names()).as("what is locked stays").containsExactly("moon", "bowl", "floor");
    }

    @Test
    void tenThousandObjectsMakeAsManyLinesButFewCells() {
        List<SceneObject> objects = new ArrayList<>();
        for (int i = 0; i < 10_000; i++) {
            objects.add(SceneObject.of(new Sphere(1)).named("ball " + i).at(i, 0, 0));
        }
        gui.act(() -> model.open(Scene.EMPTY.withObjects(objects)));
        gui.until("all are there", () -> list().getItems().size() == 10_001);
        gui.act(() -> model.select(ScenePath.body(9_999)));
        gui.until("the last is seen", () -> cells().stream().anyMatch(cell -> Objects.equals(cell.getItem().text(), "ball 9999")));
        assertThat(Gui.on(this::cells)).hasSizeLessThan(40);
        gui.keys(KeyCode.UP);
        assertThat(model.selection()).containsExactly(ScenePath.body(9_998));
    }

    private void fire(String id) {
        gui.act(() -> list().fireEvent(new ContextMenuEvent(ContextMenuEvent.CONTEXT_MENU_REQUESTED, 5, 5, 50, 50, false, null)));
        gui.act(() -> {
            ContextMenu menu = Window.getWindows().stream().filter(ContextMenu.class::isInstance).map(ContextMenu.class::cast).findFirst().orElseThrow();
            menu.getItems().stream().filter(item -> id.equals(item.getId())).forEach(item -> {
                assertThat(item.isDisable()).as(id).isFalse();
                item.fire();
            });
            menu.hide();
        });
        gui.pulse();
    }

    /** Drags a line to a height within another: 0 is its top, 1 its bottom. */
    private void dragTo(String from, String to, double share) {
        Node start = cell(from);
        Node end = cell(to);
        gui.moveTo(start, 60, 13);
        gui.press(MouseButton.PRIMARY);
        gui.moveTo(end, 60, 13);
        gui.moveTo(end, 60, 26 * share);
        gui.release(MouseButton.PRIMARY);
        gui.pulse();
    }

    @SuppressWarnings("unchecked")
    private ListView<TreeRow> list() {
        return (ListView<TreeRow>) gui.stage().getScene().lookup("#tree-list");
    }

    private TextField find() {
        return (TextField) gui.stage().getScene().lookup("#tree-find");
    }

    private List<String> texts() {
        return Gui.on(() -> list().getItems().stream().map(TreeRow::text).toList());
    }

    private List<String> names() {
        return model.scene().objects().stream().map(SceneObject::name).toList();
    }

    private List<RowCell> cells() {
        return list().lookupAll(".tree-row").stream().map(RowCell.class::cast).filter(cell -> !cell.isEmpty()).toList();
    }

    private RowCell cell(String text) {
        return Gui.on(() -> cells().stream().filter(cell -> cell.getItem().text().equals(text)).findFirst().orElseThrow());
    }

    private Node part(String text, String selector) {
        RowCell cell = cell(text);
        return Gui.on(() -> cell.lookup(selector));
    }
}
