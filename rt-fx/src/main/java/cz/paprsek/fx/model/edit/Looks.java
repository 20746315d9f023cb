package cz.paprsek.fx.model.edit;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Camera.Target;
import cz.paprsek.scene.Lens;

/** Places to look from: along the axes, and so that a box fills the picture. */
public final class Looks {
    /** Straight from above or below, up could be anywhere: so near to it that nobody sees the difference. */
    private static final double NEARLY = 1e-3;
    /** How much more than a box is seen. */
    private static final double AIR = 1.25;

    private Looks() {}

    /** From where. */
    public enum Side {
        FRONT(0, 0, 1), BACK(0, 0, -1), RIGHT(1, 0, 0), LEFT(-1, 0, 0), TOP(0, 1, NEARLY), BOTTOM(0, -1, NEARLY);

        private final double x;
        private final double y;
        private final double z;

        Side(double x, double y, double z) {
            this.x = x;
            this.y = y;
            this.z = z;
        }
    }

    /** As far away as before from what is looked at, but from another side. */
    public static Camera from(Side side, Camera camera, Vec3 pivot) {
        double distance = Math.max(1e-6, camera.position().minus(pivot).length());
        Vec3 way = new Vec3(side.x, side.y, side.z).normalized();
        return new Camera(camera.name(), pivot.plus(way.times(distance)), aim(camera, pivot, way), Vec3.Y, camera.lens());
    }

    /** In the direction as before, so near or far that the box fills the picture; an empty or endless one changes nothing. */
    public static Camera at(Bounds box, Camera camera) {
        if (box.isEmpty() || !box.isFinite()) {
            return camera;
        }
        Vec3 middle = box.middle();
        double radius = Math.max(1e-3, new Vec3(box.maxX(), box.maxY(), box.maxZ()).minus(middle).length());
        double height = 2 * AIR * radius;
        Vec3 way = camera.forward().negated();
        Lens lens = camera.lens() instanceof Lens.Orthographic ? new Lens.Orthographic(height) : camera.lens();
        double distance = Math.max(height / 2, camera.lens() instanceof Lens.Orthographic ? camera.position().minus(middle).length() : height / camera.lens().heightAt(1));
        return new Camera(camera.name(), middle.plus(way.times(distance)), aim(camera, middle, way), camera.up(), lens);
    }

    private static Camera.Aim aim(Camera camera, Vec3 pivot, Vec3 way) {
        return camera.aim() instanceof Target ? new Target(pivot) : new Camera.Direction(way.negated());
    }
}
