package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.view.look.Hint;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/** A label, what it belongs to, and under it why a value was refused. */
final class SheetRow extends VBox {
    private static final double LABEL_WIDTH = 114;
    private static final double GAP = 5;

    private final Label label;
    private final Label refusal = new Label();

    SheetRow(String text) {
        label = new Label(text);
        Hint.of(label).set(text);
        getStyleClass().add("sheet-row");
        refusal.getStyleClass().add("refusal");
        refusal.setWrapText(true);
        refusal.setMinHeight(Region.USE_PREF_SIZE);
        show(Optional.empty());
    }

    /** The label, by which a number may be dragged. */
    Label label() {
        return label;
    }

    /** Puts something small behind the label. */
    void mark(Node sign) {
        if (getChildren().get(0) instanceof HBox line) {
            line.getChildren().add(line.getChildren().indexOf(label) + 1, sign);
        }
    }

    /** Whether something is in it. */
    boolean holds(Node node) {
        Node at = node;
        while (at != null && at != this) {
            at = at.getParent();
        }
        return at == this;
    }

    /** Whether the last value was refused. */
    boolean isRefused() {
        return refusal.isVisible();
    }

    /** Puts an editor beside the label, which takes two lines if its words need them. */
    SheetRow beside(Node editor) {
        label.setWrapText(true);
        label.setMinHeight(Region.USE_PREF_SIZE);
        label.setMinWidth(LABEL_WIDTH);
        label.setPrefWidth(LABEL_WIDTH);
        label.setMaxWidth(LABEL_WIDTH);
        HBox.setHgrow(editor, Priority.ALWAYS);
        HBox line = new HBox(GAP, label, editor);
        line.setAlignment(Pos.CENTER_LEFT);
        return filled(line, editor);
    }

    /** Puts an editor below the label, with something small at the end of the label's line. */
    SheetRow below(Node editor, Node... atEnd) {
        Region gap = new Region();
        HBox.setHgrow(gap, Priority.ALWAYS);
        HBox line = new HBox(label, gap);
        line.getChildren().addAll(atEnd);
        line.setAlignment(Pos.CENTER_LEFT);
        getChildren().add(line);
        return filled(editor, editor);
    }

    private SheetRow filled(Node content, Node editor) {
        label.setLabelFor(editor);
        getChildren().addAll(content, refusal);
        return this;
    }

    /** Tells why a value was refused, or takes it back. */
    void show(Optional<String> reason) {
        refusal.setText(reason.orElse(""));
        refusal.setVisible(reason.isPresent());
        refusal.setManaged(reason.isPresent());
        pseudoClassStateChanged(PseudoClass.getPseudoClass("refused"), reason.isPresent());
    }
}
