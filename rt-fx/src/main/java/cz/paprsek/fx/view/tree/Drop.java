package cz.paprsek.fx.view.tree;

import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.LightAt;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javafx.css.PseudoClass;

/**
 * Where dragged lines would go.
 *
 * @param row the line under the mouse
 * @param where before it, after it or into it
 */
record Drop(TreeRow row, Where where) {

    /** Where in relation to a line. */
    enum Where {
        BEFORE, AFTER, INTO;

        PseudoClass pseudoClass() {
            return PseudoClass.getPseudoClass("drop-" + name().toLowerCase(Locale.ROOT));
        }
    }

    /**
     * The place that a height within a line means; empty if nothing dragged can go there.
     *
     * @param share from 0 at the top of the line to 1 at its bottom
     */
    static Optional<Drop> at(TreeRow row, double share, Collection<TreeRow> dragged) {
        boolean lights = dragged.stream().allMatch(line -> line.item() instanceof LightAt);
        boolean bodies = dragged.stream().allMatch(line -> line.item() instanceof BodyAt);
        if (row.item() instanceof LightAt ? !(lights && dragged.size() == 1) : !(row.item() instanceof BodyAt && bodies)) {
            return Optional.empty();
        }
        boolean isWithin = row.item() instanceof BodyAt at && dragged.stream().anyMatch(line ->
                line.item() instanceof BodyAt moved && moved.holds(at));
        if (isWithin || List.copyOf(dragged).equals(List.of(row))) {
            return Optional.empty();
        }
        double edge = row.operation() ? 0.3 : 0.5;
        return Optional.of(new Drop(row, share < edge ? Where.BEFORE : share > 1 - edge && !row.expanded() ? Where.AFTER
                : row.operation() ? Where.INTO : Where.AFTER));
    }

    /** The operation that takes in what is dropped; empty for the scene. */
    Optional<BodyAt> parent() {
        BodyAt at = (BodyAt) row.item();
        return where == Where.INTO ? Optional.of(at) : at.depth() > 0 ? Optional.of(at.parent()) : Optional.empty();
    }

    /** Before which of the siblings there. */
    int index(int operands) {
        if (row.item() instanceof LightAt light) {
            return where == Where.BEFORE ? light.index() : light.index() + 1;
        }
        int index = ((BodyAt) row.item()).index();
        return switch (where) {
            case BEFORE -> index;
            case AFTER -> index + 1;
            // Below the heading of an opened operation is where its first operand stands.
            case INTO -> row.expanded() ? 0 : operands;
        };
    }
}
