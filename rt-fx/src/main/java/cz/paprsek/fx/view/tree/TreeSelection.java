package cz.paprsek.fx.view.tree;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.CameraAt;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Selects in the editor's model by lines of the tree. The line last gone to is where keys go on from; ranges begin at the anchor. */
final class TreeSelection {
    private final EditorModel model;
    private ScenePath anchor = ScenePath.camera();
    private ScenePath lead = ScenePath.camera();

    TreeSelection(EditorModel model) {
        this.model = model;
    }

    boolean contains(TreeRow row) {
        return model.selection().contains(row.item());
    }

    /** Selects one line alone. */
    void only(TreeRow row) {
        anchor = row.item();
        lead = row.item();
        model.select(row.item());
    }

    /** Adds a line, or takes it away. */
    void toggle(TreeRow row) {
        Set<ScenePath> items = new LinkedHashSet<>(model.selection());
        if (!items.remove(row.item())) {
            items.add(row.item());
        }
        anchor = row.item();
        lead = row.item();
        model.select(items);
    }

    /** Selects all lines from the anchor to this one. */
    void extend(List<TreeRow> rows, TreeRow row) {
        int from = Math.max(0, index(rows, anchor));
        int to = Math.max(0, index(rows, row.item()));
        Set<ScenePath> items = new LinkedHashSet<>();
        int step = from <= to ? 1 : -1;
        for (int i = from; i != to + step; i += step) {
            items.add(rows.get(i).item());
        }
        lead = row.item();
        model.select(items);
    }

    void all(List<TreeRow> rows) {
        Set<ScenePath> items = new LinkedHashSet<>();
        rows.stream().filter(row -> !(row.item() instanceof CameraAt)).forEach(row -> items.add(row.item()));
        model.select(items);
    }

    /** The line that keys go on from: the last one gone to if it is still selected, else the last selected; −1 for none. */
    int lead(List<TreeRow> rows) {
        ScenePath item = lead;
        if (!model.selection().contains(item)) {
            for (ScenePath selected : model.selection()) {
                item = selected;
            }
            anchor = item;
            lead = item;
        }
        return model.selection().isEmpty() ? -1 : index(rows, item);
    }

    private static int index(List<TreeRow> rows, ScenePath item) {
        for (int i = 0; i < rows.size(); i++) {
            if (rows.get(i).item().equals(item)) {
                return i;
            }
        }
        return -1;
    }
}
