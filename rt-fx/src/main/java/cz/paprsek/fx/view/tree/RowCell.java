package cz.paprsek.fx.view.tree;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.Arranging;
import cz.paprsek.fx.model.edit.Arranging.Role;
import cz.paprsek.fx.view.look.Icons;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import java.util.Locale;
import java.util.Optional;
import javafx.beans.InvalidationListener;
import javafx.beans.WeakInvalidationListener;
import javafx.css.PseudoClass;
import javafx.geometry.Insets;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.javafx.FontIcon;

/** Draws a line of the tree: an arrow if it has operands, its icon, its name, its lock and its eye. */
final class RowCell extends ListCell<TreeRow> {
    private static final PseudoClass SELECTED = PseudoClass.getPseudoClass("chosen");
    private static final PseudoClass DIMMED = PseudoClass.getPseudoClass("dimmed");
    private static final PseudoClass ON = PseudoClass.getPseudoClass("on");
    private static final double INDENT = 16;
    /** Of lock and eye, pixels. */
    private static final double MARKS = 44;

    private final EditorModel model;
    private final TreeState tree;
    private final HBox box = new HBox();
    /** Over the end of the name, which makes room for it as long as it is seen. */
    private final HBox marks = new HBox();
    private final StackPane line = new StackPane(box, marks);
    private final FontIcon arrowIcon = new FontIcon("mdi2c-chevron-right");
    private final StackPane arrow = part(arrowIcon, "row-arrow");
    private final FontIcon icon = new FontIcon();
    private final Label name = new Label();
    private final FontIcon lockIcon = new FontIcon("mdi2l-lock-open-variant-outline");
    private final FontIcon eyeIcon = new FontIcon("mdi2e-eye-outline");
    private final StackPane lock = part(lockIcon, "row-lock");
    private final StackPane eye = part(eyeIcon, "row-eye");
    private final RenameField rename;
    private final InvalidationListener onChange = property -> restyle();
    /** As it has been styled; each change of the scene asks. */
    private @Nullable Look look;

    /** What tells a line from others, besides what stands in it. */
    private record Look(boolean chosen, boolean looking, boolean hidden, boolean locked, boolean dimmed, Optional<Role> role, Optional<Drop.Where> drop, boolean renamed) {
        static final Look NONE = new Look(false, false, false, false, false, Optional.empty(), Optional.empty(), false);
    }

    RowCell(EditorModel model, TreeState tree, Texts texts) {
        this.model = model;
        this.tree = tree;
        rename = new RenameField(tree);
        getStyleClass().add("tree-row");
        Region gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        name.setMinWidth(0);
        lock.setAccessibleText(texts.of("tree.lock"));
        eye.setAccessibleText(texts.of("tree.hide"));
        box.setAlignment(Pos.CENTER_LEFT);
        box.getChildren().addAll(arrow, part(icon, "row-icon"), name, gap);
        marks.getChildren().addAll(lock, eye);
        marks.setAlignment(Pos.CENTER);
        marks.setMaxWidth(Region.USE_PREF_SIZE);
        StackPane.setAlignment(marks, Pos.CENTER_RIGHT);
        // As wide as the list: what can be clicked at its end never lies beyond the edge.
        setPrefWidth(0);
        hoverProperty().addListener(property -> makeRoom());
        name.widthProperty().addListener(property -> hint());
        WeakInvalidationListener weak = new WeakInvalidationListener(onChange);
        model.stateProperty().addListener(weak);
        tree.dropProperty().addListener(weak);
        tree.renamedProperty().addListener(weak);
    }

    @Override
    protected void updateItem(TreeRow row, boolean empty) {
        super.updateItem(row, empty);
        setText(null);
        setGraphic(empty || row == null ? null : line);
        if (!empty && row != null) {
            arrow.setVisible(row.operation());
            arrowIcon.setIconLiteral(row.expanded() ? "mdi2c-chevron-down" : "mdi2c-chevron-right");
            icon.setIconLiteral(row.icon());
            name.setText(row.text());
            name.getStyleClass().removeAll("unnamed");
            if (!row.named()) {
                name.getStyleClass().add("unnamed");
            }
            hint();
        }
        look = null;
        restyle();
    }

    /** A name that has no room is told whole by a hint. */
    private void hint() {
        if (name.getWidth() >= name.prefWidth(-1)) {
            name.setTooltip(null);
        } else if (name.getTooltip() == null) {
            name.setTooltip(new Tooltip(name.getText()));
        } else {
            name.getTooltip().setText(name.getText());
        }
    }

    private void makeRoom() {
        TreeRow row = getItem();
        boolean isMarked = isHover() || (row != null && (model.state().isHidden(row.item()) || model.state().isLocked(row.item())));
        box.setPadding(new Insets(0, isMarked ? MARKS : 0, 0, row == null ? 0 : row.depth() * INDENT));
    }

    private void restyle() {
        TreeRow row = getItem();
        Look now = row == null || isEmpty() ? Look.NONE : look(row);
        if (now.equals(look)) {
            return;
        }
        look = now;
        pseudoClassStateChanged(SELECTED, now.chosen);
        if (row != null && row.item() instanceof CameraAt) {
            icon.setIconLiteral(now.looking ? Icons.LOOKING : Icons.CAMERA);
        }
        pseudoClassStateChanged(DIMMED, now.dimmed);
        for (Role each : Role.values()) {
            pseudoClassStateChanged(PseudoClass.getPseudoClass(each.name().toLowerCase(Locale.ROOT)), now.role.equals(Optional.of(each)));
        }
        toggled(eye, eyeIcon, now.hidden, "mdi2e-eye-off-outline", "mdi2e-eye-outline");
        toggled(lock, lockIcon, now.locked, "mdi2l-lock-outline", "mdi2l-lock-open-variant-outline");
        makeRoom();
        for (Drop.Where where : Drop.Where.values()) {
            pseudoClassStateChanged(where.pseudoClass(), now.drop.equals(Optional.of(where)));
        }
        Node shownName = now.renamed ? rename : name;
        if (box.getChildren().get(2) != shownName) {
            box.getChildren().set(2, shownName);
            HBox.setHgrow(rename, Priority.ALWAYS);
            if (now.renamed && row != null) {
                rename.begin(row);
            }
        }
    }

    private Look look(TreeRow row) {
        EditorState state = model.state();
        boolean hidden = state.isHidden(row.item());
        boolean dimmed = hidden || (row.item() instanceof BodyAt at && at.way().anyMatch(around -> around.find(state.scene()).filter(Body::hidden).isPresent()));
        return new Look(state.selection().contains(row.item()), row.item() instanceof CameraAt camera && camera.index() == state.eye(), hidden, state.isLocked(row.item()), dimmed,
                row.item() instanceof BodyAt at && at.isIn(state.scene()) ? Arranging.role(state.scene(), at) : Optional.empty(),
                tree.dropProperty().get().filter(drop -> drop.row().item().equals(row.item())).map(Drop::where), tree.renamedProperty().get().equals(Optional.of(row.item())));
    }

    private static void toggled(StackPane button, FontIcon icon, boolean on, String onLiteral, String offLiteral) {
        button.pseudoClassStateChanged(ON, on);
        icon.setIconLiteral(on ? onLiteral : offLiteral);
    }

    private static StackPane part(FontIcon icon, String styleClass) {
        StackPane part = new StackPane(icon);
        part.getStyleClass().addAll("row-part", styleClass);
        return part;
    }
}
