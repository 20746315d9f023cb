package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.edit.Cameras;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;

/** Turns a camera by the point it looks at. */
final class AimDrag implements Drag {
    private final Gesture gesture;
    private final int index;
    private final Axes axes;
    private final Viewport view;
    private final Vec3 aim;
    private final boolean snaps;
    private final double startX;
    private final double startY;

    /**
     * @param index of the camera
     * @param aim the point it looks at now
     */
    AimDrag(Gesture gesture, int index, Axes axes, Viewport view, Vec3 aim, boolean snaps, double startX, double startY) {
        this.gesture = gesture;
        this.index = index;
        this.axes = axes;
        this.view = view;
        this.aim = aim;
        this.snaps = snaps;
        this.startX = startX;
        this.startY = startY;
    }

    @Override
    public void to(double x, double y, Keys keys) {
        double u = axes.u(aim) + (x - startX) / view.scale();
        double v = axes.v(aim) + (startY - y) / view.scale();
        double step = Grid.step(view.scale());
        boolean snap = snaps && !keys.free();
        Vec3 by = axes.vector((snap ? Snapping.toGrid(u, step) : u) - axes.u(aim), (snap ? Snapping.toGrid(v, step) : v) - axes.v(aim));
        Vec3 point = aim.plus(by);
        Camera camera = gesture.start().scene().cameras().get(index);
        Vec3 direction = point.minus(camera.position());
        // Looking along an up of its own, or at itself, a camera has no view, which is refused: the last one stays until the mouse has moved on.
        gesture.preview(scene -> Cameras.changed(scene, index, old -> old.withAim(
                camera.aim() instanceof Camera.Target ? new Camera.Target(point) : new Camera.Direction(direction))));
    }

    @Override
    public void end() {
        gesture.commit();
    }

    @Override
    public void cancel() {
        gesture.cancel();
    }
}
