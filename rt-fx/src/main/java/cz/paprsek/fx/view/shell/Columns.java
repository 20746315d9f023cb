package cz.paprsek.fx.view.shell;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.scene.Group;
import javafx.scene.Node;
import javafx.scene.control.SplitPane;

/**
 * What stands beside each other in the window: a lesson if one is held, palette and tree, the views, the text of the scene if
 * that is shown, and sheet or explanation. In a narrow window lesson and text take the place of palette and tree.
 */
public final class Columns {
    private static final double NARROW = 1200;
    /** What palette and tree need for six buttons in a row and names that can be read. */
    private static final double TREE_PIXELS = 218;
    private static final double SHEET_PIXELS = 294;
    private static final double TREE_EXPLAINED = 0.14;
    private static final double TREE_EXPLAINED_PIXELS = 170;
    /** Narrower ones, as one that has no width yet, are divided by shares alone. */
    private static final double LEAST_WIDTH = 900;
    private static final double TREE = 0.17;
    private static final double VIEWS = 0.77;

    private final SplitPane root = new SplitPane();
    private final Node none = new Group();
    private final Node left;
    private final Node views;
    private final Node sheet;
    private Optional<Node> lesson = Optional.empty();
    private Optional<Node> explanation = Optional.empty();
    private Optional<Node> text = Optional.empty();
    private boolean isNarrow;

    /**
     * Without a lesson, and with the sheet.
     *
     * @param left palette and tree
     */
    public Columns(Node left, Node views, Node sheet) {
        this.left = left;
        this.views = views;
        this.sheet = sheet;
        root.setId("columns");
        root.widthProperty().addListener((property, old, now) -> {
            boolean is = now.doubleValue() < NARROW;
            if (is != isNarrow) {
                isNarrow = is;
                if (lesson.isPresent() || text.isPresent()) {
                    arrange();
                }
            }
        });
        arrange();
    }

    public Node root() {
        return root;
    }

    /** The last column: sheet or explanation. */
    public Node last() {
        return explanation.orElse(sheet);
    }

    /** The lesson; something that holds nothing if there is none. */
    public Node lesson() {
        return lesson.orElse(none);
    }

    /** The scene as text; something that holds nothing if that is not shown. */
    public Node text() {
        return text.orElse(none);
    }

    /** Shows the scene as text beside the views, or not any more. */
    public void write(Optional<Node> shown) {
        text = shown;
        arrange();
    }

    /** Shows an explanation in the place of the sheet, or the sheet again. */
    public void explain(Optional<Node> shown) {
        explanation = shown;
        arrange();
    }

    /** Shows a lesson, or none any more. */
    public void teach(Optional<Node> shown) {
        lesson = shown;
        arrange();
    }

    /** Where columns end if the text is one of them. */
    private double[] beside(boolean hasLeft) {
        List<Double> widths = new ArrayList<>();
        lesson.ifPresent(shown -> widths.add(0.25));
        if (hasLeft) {
            widths.add(0.12);
        }
        widths.addAll(List.of(0.32, 0.3, 0.26));
        double all = widths.stream().mapToDouble(Double::doubleValue).sum();
        double at = 0;
        double[] ends = new double[widths.size() - 1];
        for (int i = 0; i < ends.length; i++) {
            at += widths.get(i) / all;
            ends[i] = at;
        }
        return ends;
    }

    /** Where palette and tree, and then the views, end beside the sheet: on a small screen both have the pixels that they need. */
    private double[] besideSheet() {
        double width = root.getWidth();
        if (width < LEAST_WIDTH) {
            return new double[] {TREE, VIEWS};
        }
        return new double[] {Math.max(TREE, TREE_PIXELS / width), Math.min(VIEWS, 1 - SHEET_PIXELS / width)};
    }

    /** As {@link #besideSheet}, beside an explanation: the names in the tree can still be told apart. */
    private double[] besideExplanation() {
        double width = root.getWidth();
        return new double[] {width < LEAST_WIDTH ? TREE_EXPLAINED : Math.max(TREE_EXPLAINED, TREE_EXPLAINED_PIXELS / width), 0.6};
    }

    private void arrange() {
        List<Node> items = new ArrayList<>();
        lesson.ifPresent(items::add);
        boolean hasLeft = !isNarrow || (lesson.isEmpty() && text.isEmpty());
        if (hasLeft) {
            items.add(left);
        }
        items.add(views);
        text.ifPresent(items::add);
        items.add(last());
        root.getItems().setAll(items);
        if (text.isPresent()) {
            root.setDividerPositions(beside(hasLeft));
            return;
        }
        boolean isExplained = explanation.isPresent();
        if (lesson.isEmpty()) {
            root.setDividerPositions(isExplained ? besideExplanation() : besideSheet());
        } else if (isNarrow) {
            root.setDividerPositions(isExplained ? new double[] {0.3, 0.62} : new double[] {0.34, 0.71});
        } else {
            root.setDividerPositions(isExplained ? new double[] {0.24, 0.34, 0.66} : new double[] {0.25, 0.38, 0.79});
        }
    }
}
