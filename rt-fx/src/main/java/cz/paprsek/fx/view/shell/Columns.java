package cz.paprsek.fx.view.shell;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.scene.Group;
import javafx.scene.Node;
import javafx.scene.control.SplitPane;

/** What stands beside each other in the window: a lesson if one is held, palette and tree, the views, and sheet or explanation. In a narrow window a lesson takes the place of palette and tree. */
public final class Columns {
    private static final double NARROW = 1200;

    private final SplitPane root = new SplitPane();
    private final Node none = new Group();
    private final Node left;
    private final Node views;
    private final Node sheet;
    private Optional<Node> lesson = Optional.empty();
    private Optional<Node> explanation = Optional.empty();
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
                if (lesson.isPresent()) {
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

    private void arrange() {
        List<Node> items = new ArrayList<>();
        lesson.ifPresent(items::add);
        if (lesson.isEmpty() || !isNarrow) {
            items.add(left);
        }
        items.addAll(List.of(views, last()));
        root.getItems().setAll(items);
        boolean isExplained = explanation.isPresent();
        if (lesson.isEmpty()) {
            root.setDividerPositions(isExplained ? new double[] {0.14, 0.6} : new double[] {0.17, 0.77});
        } else if (isNarrow) {
            root.setDividerPositions(isExplained ? new double[] {0.3, 0.62} : new double[] {0.34, 0.71});
        } else {
            root.setDividerPositions(isExplained ? new double[] {0.24, 0.34, 0.66} : new double[] {0.25, 0.38, 0.79});
        }
    }
}
