package cz.paprsek.drawing;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import java.util.Optional;

/**
 * The world as a camera sees it, on a picture of a given size: the opposite of the way from a pixel to its ray.
 *
 * @param width of the picture, in any unit, above 0
 * @param height of the picture, in the same unit, above 0
 */
public record Perspective(Camera camera, double width, double height) {
    /** Lines end where they are this much nearer to the eye's plane than the farther of their ends. */
    private static final double NEAR = 1e-4;

    /** The part of a line that is before the eye, as the picture shows it; empty if none is. */
    public Optional<Segment> line(Vec3 from, Vec3 to) {
        double fromDepth = depth(from);
        double toDepth = depth(to);
        double near = NEAR * Math.max(fromDepth, toDepth);
        if (near <= 0) {
            return Optional.empty();
        }
        Vec3 begin = fromDepth < near ? between(from, to, (near - fromDepth) / (toDepth - fromDepth)) : from;
        Vec3 end = toDepth < near ? between(from, to, (near - fromDepth) / (toDepth - fromDepth)) : to;
        return Optional.of(new Segment(x(begin), y(begin), x(end), y(end)));
    }

    private static Vec3 between(Vec3 from, Vec3 to, double share) {
        return from.plus(to.minus(from).times(share));
    }

    private double depth(Vec3 point) {
        return point.minus(camera.position()).dot(camera.forward());
    }

    private double x(Vec3 point) {
        return width / 2 + point.minus(camera.position()).dot(camera.right()) / (depth(point) * unit());
    }

    private double y(Vec3 point) {
        return height / 2 - point.minus(camera.position()).dot(camera.trueUp()) / (depth(point) * unit());
    }

    /** The part of the world that one unit of the picture shows, at the distance 1. */
    private double unit() {
        return 2 * Angles.tan(camera.fovy() / 2) / height;
    }
}
