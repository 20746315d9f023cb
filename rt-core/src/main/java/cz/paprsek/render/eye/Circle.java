package cz.paprsek.render.eye;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.tree.Bundle;

/**
 * An equidistant fisheye: with p = (2x/W − 1)·W/H and q = 1 − 2y/H, so that the circle p² + q² = 1 is as high as the picture, and ρ² = p² + q²,
 * the angle between the ray and the view is ρ times half of what is seen. Beyond the circle there is nothing.
 */
final class Circle extends Curved {
    private final double angle;

    Circle(Camera camera, Lens.Fisheye lens, double width, double height, int step) {
        // No second derivative of the sphere's map by angles from one pole is above √3.
        super(camera, width, height, step, StrictMath.toRadians(lens.angle()) * width / height, StrictMath.toRadians(lens.angle()), 2);
        angle = lens.angle();
    }

    @Override
    public boolean start(Ray ray, double x, double y, double lensU, double lensV) {
        double p = (2 * x * perColumn - 1) * aspect;
        double q = 1 - 2 * y * perRow;
        double radius = Math.sqrt(p * p + q * q);
        if (radius > 1) {
            ray.startBlind();
            return false;
        }
        double share = share(radius);
        return lookAlong(ray, Angles.cos(radius * angle / 2), share * p, share * q);
    }

    @Override
    void add(Bundle bundle, double x, double y, double slack) {
        double p = (2 * x * perColumn - 1) * aspect;
        double q = 1 - 2 * y * perRow;
        double radius = Math.sqrt(p * p + q * q);
        double share = share(radius);
        add(bundle, Angles.cos(radius * angle / 2), share * p, share * q, slack);
    }

    private double share(double radius) {
        return radius == 0 ? 0 : Angles.sin(radius * angle / 2) / radius;
    }

    @Override
    public boolean project(Vec3 world, double[] xy) {
        Vec3 v = world.minus(position);
        double radius = radius(v);
        // Straight behind is everywhere on the rim.
        boolean isSomewhere = aside(v) > 0 || v.dot(forward) > 0;
        double share = share(v);
        return radius <= 1 && isSomewhere && at(share * v.dot(right) / (2 * aspect), share * v.dot(up) / 2, xy);
    }

    @Override
    public double[] tell(Ray ray) {
        Vec3 d = new Vec3(ray.dx, ray.dy, ray.dz);
        double share = share(d);
        return aside(d) == 0 ? new double[] {radius(d), 0} : new double[] {share * d.dot(right), share * d.dot(up)};
    }

    /** Where on the circle, from its middle, a direction of any length belongs: 1 is its rim. */
    private double radius(Vec3 v) {
        return 2 * StrictMath.toDegrees(StrictMath.atan2(aside(v), v.dot(forward))) / angle;
    }

    /** What makes the parts of a direction aside into its place on the circle. */
    private double share(Vec3 v) {
        return radius(v) / Math.max(aside(v), Double.MIN_NORMAL);
    }

    private double aside(Vec3 v) {
        double across = v.dot(right);
        double upwards = v.dot(up);
        return Math.sqrt(across * across + upwards * upwards);
    }
}
