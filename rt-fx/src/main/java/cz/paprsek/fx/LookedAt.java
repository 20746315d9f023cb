package cz.paprsek.fx;

import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;

/** What the camera has in the middle of its picture. */
final class LookedAt {
    private static final double AHEAD = 5;
    private static final double FARTHEST = 50;

    private LookedAt() {}

    /** Its target; else where it looks at the ground y = 0, if that is not far off; else a point ahead. To tenths, so that it reads well. */
    static Vec3 point(Scene scene) {
        Camera camera = scene.camera();
        if (camera.aim() instanceof Camera.Target target) {
            return target.point();
        }
        Vec3 forward = camera.forward();
        double toGround = forward.y() == 0 ? Double.POSITIVE_INFINITY : -camera.position().y() / forward.y();
        double distance = toGround > 0 && toGround < FARTHEST ? toGround : AHEAD;
        Vec3 p = camera.position().plus(forward.times(distance));
        return new Vec3(tenths(p.x()), tenths(p.y()), tenths(p.z()));
    }

    private static double tenths(double value) {
        return Math.rint(value * 10) / 10 + 0.0;
    }
}
