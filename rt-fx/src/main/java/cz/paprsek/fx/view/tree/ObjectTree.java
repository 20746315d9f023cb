package cz.paprsek.fx.view.tree;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.command.MaterialDrop;
import cz.paprsek.fx.view.command.SelectionCommands;
import cz.paprsek.fx.view.command.UndoKeys;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Csg;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import javafx.application.Platform;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.WeakChangeListener;
import javafx.scene.control.IndexedCell;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.control.skin.VirtualFlow;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.BorderPane;

/**
 * The scene's camera, lights and objects, operands within their operations. What is selected is what the model says is selected: the list
 * keeps no selection of its own, and so is never out of step. Lines exist for what is seen only.
 */
public final class ObjectTree extends BorderPane {
    private static final double ROW_HEIGHT = 26;

    private final EditorModel model;
    private final Texts texts;
    private final ListView<TreeRow> list = new ListView<>();
    private final TextField find = new TextField();
    private final Label refusal = new Label();
    private final Expansion expansion;
    private final TreeState state;
    /** Held here, for the model, which outlives the window's content, holds them weakly. */
    private final ChangeListener<Scene> onScene = (property, was, is) -> later();
    private final ChangeListener<Set<ScenePath>> onSelection = (property, was, is) -> reveal(is);
    private final ChangeListener<Number> onOpened = (property, was, is) -> opened();
    private boolean isStale;
    /** Whether the lines are those of another file. */
    private boolean isOther;
    /** The scene that the lines are of, or one that has the same. */
    private Scene shown = Scene.EMPTY;

    /** @param commands what can be done with what is selected */
    public ObjectTree(EditorModel model, Texts texts, SelectionCommands commands) {
        this.model = model;
        this.texts = texts;
        expansion = new Expansion(model.scene());
        Edits edits = commands.edits();
        state = new TreeState(edits, list::requestFocus);
        TreeSelection selection = new TreeSelection(model);
        setId("object-tree");
        getStyleClass().add("object-tree");
        getStylesheets().add(Objects.requireNonNull(ObjectTree.class.getResource("tree.css")).toExternalForm());
        find.setId("tree-find");
        find.setPromptText(texts.of("tree.find"));
        find.textProperty().addListener((property, was, is) -> refresh());
        find.addEventFilter(KeyEvent.KEY_PRESSED, this::findKey);
        list.setId("tree-list");
        list.setFixedCellSize(ROW_HEIGHT);
        list.setCellFactory(view -> new RowCell(model, state, texts));
        list.setAccessibleText(texts.of("tree.list"));
        new TreeKeys(this, selection, state, edits, find).attach(list);
        new TreeMouse(this, selection, state, edits, model).attach(list);
        list.setContextMenu(commands.contextMenu());
        MaterialDrop.accept(list, edits, event -> TreeMouse.row(event.getPickResult()).flatMap(row ->
                row.item() instanceof BodyAt at ? Optional.of(at) : Optional.empty()), this::highlight);
        refusal.getStyleClass().add("refusal");
        refusal.setWrapText(true);
        refusal.textProperty().bind(edits.refusalProperty());
        refusal.managedProperty().bind(refusal.textProperty().isNotEmpty());
        refusal.visibleProperty().bind(refusal.managedProperty());
        setTop(find);
        setCenter(list);
        setBottom(refusal);
        UndoKeys.reach(model, this);
        model.openingsProperty().addListener(new WeakChangeListener<>(onOpened));
        model.sceneProperty().addListener(new WeakChangeListener<>(onScene));
        model.selectionProperty().addListener(new WeakChangeListener<>(onSelection));
        refresh();
    }

    /** Begins to give what is selected another name. */
    public void rename() {
        model.selection().stream().findFirst().ifPresent(state::rename);
    }

    private void highlight(Optional<BodyAt> body) {
        state.setDrop(body.flatMap(at -> rows().stream().filter(row -> row.item().equals(at)).findFirst()).map(row -> new Drop(row, Drop.Where.INTO)));
    }

    /** The lines as they are now. */
    List<TreeRow> rows() {
        refreshIfStale();
        return list.getItems();
    }

    /** Shows or hides what an operation is made of. */
    void expand(TreeRow row, boolean open) {
        if (row.operation() && row.item() instanceof BodyAt at) {
            expansion.set(at, open);
            refresh();
        }
    }

    /** Scrolls so that a line is seen. */
    void scrollTo(int index) {
        if (list.lookup(".virtual-flow") instanceof VirtualFlow<?> flow) {
            IndexedCell<?> first = flow.getFirstVisibleCell();
            IndexedCell<?> last = flow.getLastVisibleCell();
            if (first == null || last == null || index <= first.getIndex() || index >= last.getIndex()) {
                flow.scrollTo(index);
                list.layout();
                boolean isLate = last != null && index >= last.getIndex();
                if (isLate) {
                    flow.scrollTo(Math.max(0, index - Math.max(1, (int) (list.getHeight() / ROW_HEIGHT) - 2)));
                }
            }
        }
    }

    /** Once for all that changes before the window is drawn anew. */
    private void later() {
        if (!isStale) {
            isStale = true;
            Platform.runLater(this::refreshIfStale);
        }
    }

    private void refreshIfStale() {
        if (isStale && (isOther || !hasSameLines(model.scene(), shown))) {
            refresh();
        }
        isStale = false;
        shown = model.scene();
    }

    /** Whether nothing but numbers differs, as while something is dragged. */
    private static boolean hasSameLines(Scene scene, Scene other) {
        return names(scene.cameras(), Camera::name).equals(names(other.cameras(), Camera::name)) && names(scene.lights(), ObjectTree::line).equals(names(other.lights(), ObjectTree::line))
                && scene.objects().size() == other.objects().size()
                && Arrays.stream(scene.objectsOtherThanIn(other)).allMatch(i -> hasSameLine(scene.objects().get(i), other.objects().get(i)));
    }

    private static <T> List<String> names(List<T> things, Function<T, String> name) {
        return things.stream().map(name).toList();
    }

    private static String line(Light light) {
        return light.getClass().getName() + " " + light.name();
    }

    private static boolean hasSameLine(SceneObject object, SceneObject other) {
        return object.name().equals(other.name()) && (object.shape() == other.shape()
                || (object.shape().getClass() == other.shape().getClass() && !(object.shape() instanceof Csg)));
    }

    private void opened() {
        expansion.closeAll();
        isOther = true;
        later();
    }

    private void refresh() {
        isStale = false;
        isOther = false;
        shown = model.scene();
        expansion.follow(model.scene());
        List<TreeRow> now = new TreeRows(texts, expansion.open(), model.copies(), find.getText()).of(model.scene());
        if (!now.equals(list.getItems())) {
            list.getItems().setAll(now);
        }
    }

    /** Brings what was selected elsewhere into sight. */
    private void reveal(Set<ScenePath> items) {
        if (items.size() != 1) {
            return;
        }
        ScenePath item = items.iterator().next();
        expansion.follow(model.scene());
        if (item instanceof BodyAt at && expansion.reveal(at)) {
            refresh();
        }
        List<TreeRow> rows = rows();
        for (int i = 0; i < rows.size(); i++) {
            if (rows.get(i).item().equals(item)) {
                scrollTo(i);
                return;
            }
        }
    }

    private void findKey(KeyEvent event) {
        if (event.getCode() == KeyCode.ESCAPE) {
            find.clear();
            list.requestFocus();
            event.consume();
        } else if (event.getCode() == KeyCode.ENTER || event.getCode() == KeyCode.DOWN) {
            List<TreeRow> rows = rows();
            found(rows).ifPresent(row -> model.select(row.item()));
            list.requestFocus();
            event.consume();
        }
    }

    /** The first line that is looked for itself, rather than being around such a one. */
    private Optional<TreeRow> found(List<TreeRow> rows) {
        String wanted = find.getText().strip().toLowerCase(texts.locale());
        return rows.stream().filter(row -> row.text().toLowerCase(texts.locale()).contains(wanted)).findFirst()
                .or(() -> rows.stream().findFirst());
    }
}
