package cz.paprsek.fx.view.explain;

import cz.paprsek.render.explain.text.Outline;
import cz.paprsek.words.Words;
import java.util.function.Predicate;
import javafx.css.PseudoClass;
import javafx.scene.control.TreeCell;
import javafx.scene.control.TreeItem;
import javafx.scene.control.skin.TreeCellSkin;
import javafx.scene.shape.Rectangle;

/** A ray in the outline: the colour of its light, its name, and what it meets; in italics, as dark as can be read with ease, if it is still to come. */
final class OutlineCell extends TreeCell<Outline> {
    private static final PseudoClass TO_COME = PseudoClass.getPseudoClass("to-come");
    private static final double FAINT = 0.35;
    /** What the arrow that folds takes beside a row, and the gap after it, in pixels. */
    private static final double ARROW = 24;

    private final Words words;
    private final Predicate<Outline> isShown;
    private final Rectangle patch = new Rectangle(14, 14);

    OutlineCell(Words words, Predicate<Outline> isShown) {
        this.words = words;
        this.isShown = isShown;
        // As wide as the tree, in as many lines as it needs.
        setPrefWidth(0);
        setWrapText(true);
    }

    /** A cell of JavaFX's takes no account of how far it is indented, and cuts a line that has room only without that. */
    @Override
    protected double computePrefHeight(double width) {
        TreeItem<Outline> shown = getTreeItem();
        if (shown == null || width < 0 || !(getSkin() instanceof TreeCellSkin<?> skin)) {
            return super.computePrefHeight(width);
        }
        double indent = getTreeView().getTreeItemLevel(shown) * skin.getIndent() + ARROW;
        return super.computePrefHeight(Math.max(1, width - indent));
    }

    @Override
    protected void updateItem(Outline outline, boolean empty) {
        super.updateItem(outline, empty);
        boolean isToCome = !empty && !isShown.test(outline);
        pseudoClassStateChanged(TO_COME, isToCome);
        patch.setOpacity(isToCome ? FAINT : 1);
        if (empty) {
            setText("");
            setGraphic(null);
            return;
        }
        patch.setFill(SampleList.color(outline.ray().light()));
        setGraphic(patch);
        setText(outline.name() + "  " + outline.percent(words) + "  " + outline.headline(words));
    }
}
