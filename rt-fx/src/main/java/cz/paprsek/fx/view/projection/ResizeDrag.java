package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.ScenePath;
import java.util.Locale;
import java.util.Set;

/** Stretches items from the side or corner opposite to the handle. */
final class ResizeDrag extends Drag.Changing {
    /** As small as a thing can be made in one go. */
    private static final double SMALLEST = 1e-3;

    private final Set<ScenePath> items;
    private final Box box;
    private final Vec3 depth;
    private final Handle handle;
    private final boolean proportional;
    private double width;
    private double height;

    /**
     * @param depth what stays where it is along the axis that points at the viewer
     * @param proportional whether corners keep the proportions; Shift then does the other
     */
    ResizeDrag(Gesture gesture, Set<ScenePath> items, Axes axes, Viewport view, Box box, Vec3 depth, Handle handle, boolean snaps,
            boolean proportional, double startX, double startY) {
        super(gesture, axes, view, snaps, startX, startY);
        this.items = items;
        this.box = box;
        this.depth = depth;
        this.handle = handle;
        this.proportional = proportional;
    }

    @Override
    public void to(double x, double y, Keys keys) {
        boolean snap = snaps(keys);
        double alongU = factor(handle.alongU(), box.minU(), box.maxU(), byU(x), snap);
        double alongV = factor(handle.alongV(), box.minV(), box.maxV(), byV(y), snap);
        boolean corner = handle.alongU() != 0 && handle.alongV() != 0;
        boolean even = corner && keys.straight() != proportional;
        double evenly = Math.abs(alongU - 1) > Math.abs(alongV - 1) ? alongU : alongV;
        width = (box.maxU() - box.minU()) * (even ? evenly : alongU);
        height = (box.maxV() - box.minV()) * (even ? evenly : alongV);
        Vec3 factors = even ? new Vec3(evenly, evenly, evenly) : axes.factors(alongU, alongV);
        double pivotU = pivot(handle.alongU(), box.minU(), box.maxU());
        double pivotV = pivot(handle.alongV(), box.minV(), box.maxV());
        gesture.preview(scene -> Moves.scaled(scene, items, axes.vector(pivotU, pivotV).plus(depth), factors));
    }

    @Override
    public String figures(Locale locale) {
        return view.text(width, locale) + " × " + view.text(height, locale);
    }

    private double factor(int side, double min, double max, double by, boolean snap) {
        if (side == 0 || max - min <= 0) {
            return 1;
        }
        double old = side > 0 ? max : min;
        double fresh = snap ? Snapping.toGrid(old + by, Grid.step(view.scale())) : old + by;
        return Math.max(SMALLEST, side > 0 ? (fresh - min) / (max - min) : (max - fresh) / (max - min));
    }

    private static double pivot(int side, double min, double max) {
        return side == 0 ? (min + max) / 2 : side > 0 ? min : max;
    }
}
