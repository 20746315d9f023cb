package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.fx.model.edit.Rounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.ScenePath;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/** Stretches items from the side or corner opposite to the handle, or from a pivot that has been put somewhere. */
final class ResizeDrag extends Drag.Placing {
    /** As small as a thing can be made in one go. */
    private static final double SMALLEST = 1e-3;

    private final Box box;
    private final Vec3 depth;
    private final Handle handle;
    private final boolean proportional;
    private final Optional<Vec3> pivot;
    private double width;
    private double height;

    /**
     * @param depth what stays where it is along the axis that points at the viewer
     * @param pivot what stays where it is, in place of the other side
     * @param proportional whether corners keep the proportions; Shift then does the other
     */
    ResizeDrag(Gesture gesture, Set<ScenePath> items, Axes axes, Viewport view, Box box, Vec3 depth, Optional<Vec3> pivot, Handle handle, boolean snaps,
            boolean proportional, double startX, double startY) {
        super(gesture, items, axes, view, snaps, startX, startY);
        this.box = box;
        this.depth = depth;
        this.handle = handle;
        this.proportional = proportional;
        this.pivot = pivot;
    }

    @Override
    public void to(double x, double y, Keys keys) {
        boolean snap = snaps(keys);
        double pivotU = pivot.map(axes::u).orElseGet(() -> opposite(handle.alongU(), box.minU(), box.maxU()));
        double pivotV = pivot.map(axes::v).orElseGet(() -> opposite(handle.alongV(), box.minV(), box.maxV()));
        double alongU = factor(handle.alongU(), box.minU(), box.maxU(), pivotU, byU(x), snap);
        double alongV = factor(handle.alongV(), box.minV(), box.maxV(), pivotV, byV(y), snap);
        boolean corner = handle.alongU() != 0 && handle.alongV() != 0;
        boolean even = corner && keys.straight() != proportional;
        double evenly = Math.abs(alongU - 1) > Math.abs(alongV - 1) ? alongU : alongV;
        width = (box.maxU() - box.minU()) * (even ? evenly : alongU);
        height = (box.maxV() - box.minV()) * (even ? evenly : alongV);
        Vec3 factors = even ? new Vec3(evenly, evenly, evenly) : axes.factors(alongU, alongV);
        Vec3 still = axes.vector(pivotU, pivotV).plus(pivot.map(axes::inDepth).orElse(depth));
        preview((scene, placed) -> Moves.scaled(scene, placed, still, factors));
    }

    @Override
    public String figures(Locale locale) {
        return view.text(width, locale) + " × " + view.text(height, locale);
    }

    private double factor(int side, double min, double max, double still, double by, boolean snap) {
        double old = side > 0 ? max : min;
        // A pivot at the very side that is pulled has nothing to stretch.
        if (side == 0 || max - min <= 0 || (old - still) * side <= SMALLEST * (max - min)) {
            return 1;
        }
        double fresh = snap ? Rounds.toGrid(old + by, Rounds.step(view.scale())) : old + by;
        return Math.max(SMALLEST, (fresh - still) / (old - still));
    }

    private static double opposite(int side, double min, double max) {
        return side == 0 ? (min + max) / 2 : side > 0 ? min : max;
    }
}
