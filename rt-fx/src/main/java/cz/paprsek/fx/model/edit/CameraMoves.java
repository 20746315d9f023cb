package cz.paprsek.fx.model.edit;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Camera.Aim;
import cz.paprsek.scene.Camera.Direction;
import cz.paprsek.scene.Camera.Target;

/** Moves of a camera as a hand makes them: around a point, sideways, nearer. Positions get no more digits than can be seen. */
public final class CameraMoves {
    /** How steeply a hand can make a camera look, degrees. */
    private static final double STEEPEST = 89;
    /** Positions are rounded to this part of the distance that is looked at. */
    private static final double GRAIN = 1e-5;

    private CameraMoves() {}

    /**
     * Turns a camera and its view about a pivot, up staying up. Straight above and straight below are not quite reached.
     *
     * @param right degrees that the camera goes to its right around the axis of its up
     * @param upwards degrees that it climbs
     */
    public static Camera orbited(Camera camera, Vec3 pivot, double right, double upwards) {
        Vec3 up = camera.up().normalized();
        Camera turned = turned(camera, pivot, up, right);
        double height = -Math.toDegrees(Math.asin(Math.max(-1, Math.min(1, camera.forward().dot(up)))));
        double most = Math.max(STEEPEST, Math.abs(height));
        double climb = Math.max(-most, Math.min(most, height + upwards)) - height;
        return rounded(turned(turned, pivot, turned.right(), -climb), camera, pivot);
    }

    /**
     * Moves a camera, and what it looks at, along the edges of its picture.
     *
     * @param right scene units to the right
     * @param upwards scene units up
     */
    public static Camera panned(Camera camera, double right, double upwards) {
        Vec3 by = camera.right().times(right).plus(camera.trueUp().times(upwards));
        Vec3 seen = camera.position().plus(camera.forward().times(Math.max(Math.abs(right), Math.abs(upwards))));
        Camera moved = camera.aim() instanceof Target target
                ? placed(camera, camera.position().plus(by), new Target(target.point().plus(by)))
                : camera.withPosition(camera.position().plus(by));
        return rounded(moved, camera, seen);
    }

    /**
     * Moves a camera along the line to a pivot.
     *
     * @param factor what the distance is multiplied by, above 0
     */
    public static Camera dollied(Camera camera, Vec3 pivot, double factor) {
        return rounded(camera.withPosition(pivot.plus(camera.position().minus(pivot).times(factor))), camera, pivot);
    }

    /** How high the picture is at a distance from the eye, scene units. */
    public static double heightAt(Camera camera, double distance) {
        return camera.lens().heightAt(distance);
    }

    private static Camera turned(Camera camera, Vec3 pivot, Vec3 axis, double degrees) {
        Vec3 position = pivot.plus(rotated(camera.position().minus(pivot), axis, degrees));
        if (camera.aim() instanceof Direction direction) {
            return placed(camera, position, new Direction(rotated(direction.vector(), axis, degrees)));
        }
        Vec3 target = ((Target) camera.aim()).point();
        return placed(camera, position, new Target(pivot.plus(rotated(target.minus(pivot), axis, degrees))));
    }

    private static Camera placed(Camera camera, Vec3 position, Aim aim) {
        return new Camera(camera.name(), position, aim, camera.up(), camera.lens());
    }

    /** @source Rodrigues' rotation formula; counter-clockwise seen from the tip of the axis, which has length 1 */
    private static Vec3 rotated(Vec3 v, Vec3 axis, double degrees) {
        double sine = Angles.sin(degrees);
        double cosine = Angles.cos(degrees);
        return v.times(cosine).plus(axis.cross(v).times(sine)).plus(axis.times(axis.dot(v) * (1 - cosine)));
    }

    /** What has not moved keeps all its digits. */
    private static Camera rounded(Camera moved, Camera before, Vec3 seen) {
        double grain = grain(moved.position().minus(seen).length());
        return placed(moved, rounded(moved.position(), grain), rounded(moved.aim(), before.aim(), grain));
    }

    private static Aim rounded(Aim moved, Aim before, double grain) {
        if (moved.equals(before)) {
            return before;
        }
        return moved instanceof Target target
                ? new Target(rounded(target.point(), grain))
                : new Direction(rounded(((Direction) moved).vector().normalized(), GRAIN));
    }

    /** The power of ten below the part of the distance that still counts. */
    private static double grain(double distance) {
        return distance > 0 ? Math.pow(10, Math.floor(Math.log10(distance * GRAIN))) : 0;
    }

    private static Vec3 rounded(Vec3 v, double grain) {
        return grain > 0 ? new Vec3(rounded(v.x(), grain), rounded(v.y(), grain), rounded(v.z(), grain)) : v;
    }

    /** Division by the reciprocal, which is a whole number for grains below 1, gives the decimal that is nearest. */
    private static double rounded(double value, double grain) {
        double multiple = Math.rint(value / grain);
        return (grain < 1 ? multiple / Math.rint(1 / grain) : multiple * grain) + 0.0;
    }
}
