package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Camera.Target;
import cz.paprsek.scene.Scene;
import java.util.function.Predicate;

/**
 * Where a user looks: where new things are put.
 *
 * @param point the middle of the view, world space
 * @param size what is large enough to be seen well there, scene units
 */
public record Sight(Vec3 point, double size) {
    /** The share of the picture's height that a new thing takes. */
    private static final double SHARE = 0.25;
    /** A grid has so many steps to a size; and what keeps to none so many to a step. */
    private static final double COARSE = 4;
    private static final double FINE = 250;
    /** From 5 the nearest round size is then 2, from 2 it is 1, from 1 it is 0.5. */
    private static final double STEP = 2.2;

    /** What the camera looks at through which the user does: its target, or else the point of its view nearest to the middle of all there is. */
    public static Sight of(EditorState state) {
        Camera camera = state.camera();
        Vec3 aim = camera.aim() instanceof Target target ? target.point() : middle(bounds(state.scene()));
        double ahead = aim.minus(camera.position()).dot(camera.forward());
        double distance = ahead > 0 ? ahead : camera.position().length() + 1;
        double height = camera.lens().heightAt(distance);
        return at(camera.position().plus(camera.forward().times(distance)), height);
    }

    /**
     * A view of a given point.
     *
     * @param height what of the world the view shows from top to bottom there, scene units
     */
    public static Sight at(Vec3 point, double height) {
        return chosen(point, Vec3.ZERO, height, true);
    }

    /**
     * A view of a point that a hand has chosen.
     *
     * @param side the normal of the surface that the point is to stay on, of length 1; 0 if there is none
     * @param height what of the world the view shows from top to bottom there, scene units
     * @param snaps whether it keeps to a grid, else it is only rounded
     */
    public static Sight chosen(Vec3 point, Vec3 side, double height, boolean snaps) {
        double size = round(height * SHARE);
        double grid = size / (snaps ? COARSE : COARSE * FINE);
        Vec3 near = new Vec3(snap(point.x(), grid), snap(point.y(), grid), snap(point.z(), grid));
        return new Sight(near.plus(side.times(point.minus(near).dot(side))), size);
    }

    /**
     * As large at a point that a hand has chosen; on a grid if it snaps, else only rounded.
     *
     * @param step of the grid that is seen there, scene units; it counts where it is finer than one for that size
     */
    public Sight moved(Vec3 to, boolean snaps, double step) {
        double grid = Math.min(size / COARSE, step) / (snaps ? 1 : FINE);
        return new Sight(new Vec3(snap(to.x(), grid), snap(to.y(), grid), snap(to.z(), grid)), size);
    }

    /** One with the next smaller round size. */
    public Sight smaller() {
        return new Sight(point, round(size / STEP));
    }

    /** The box around all bounded objects; empty if there are none. */
    static Bounds bounds(Scene scene) {
        return scene.objects().stream()
                .map(object -> object.shape().bounds().transformed(object.placement().toParent()))
                .filter(Bounds::isFinite).filter(Predicate.not(Bounds::isEmpty))
                .reduce(Bounds.EMPTY, Bounds::union);
    }

    private static Vec3 middle(Bounds box) {
        return box.isEmpty() ? Vec3.ZERO
                : new Vec3((box.minX() + box.maxX()) / 2, (box.minY() + box.maxY()) / 2, (box.minZ() + box.maxZ()) / 2);
    }

    /** The nearest of 1, 2, 5, 10 … and 0.5, 0.2, 0.1 …. */
    private static double round(double value) {
        int exponent = (int) Math.floor(Math.log10(value));
        double digits = value / Math.pow(10, exponent);
        String leading = digits < 1.5 ? "1" : digits < 3.5 ? "2" : digits < 7.5 ? "5" : "10";
        return Double.parseDouble(leading + "e" + exponent);
    }

    private static double snap(double value, double grid) {
        // Divided by the inverse, multiples of 0.25 and the like come out without noise; 0 is added to make −0 into 0.
        return Math.rint(value / grid) / (1 / grid) + 0.0;
    }
}
