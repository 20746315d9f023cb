package cz.paprsek.render.eye;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.tree.Bundle;

/** All around: with the longitude λ = (x/W − ½)·360° and the latitude φ = (½ − y/H)·180°, the ray goes along cos φ·(cos λ·d + sin λ·r) + sin φ·u. */
final class Globe extends Curved {
    Globe(Camera camera, double width, double height, int step) {
        super(camera, width, height, step, 2 * Math.PI, Math.PI, 1);
    }

    @Override
    public boolean start(Ray ray, double x, double y, double lensU, double lensV) {
        double longitude = (x * perColumn - 0.5) * 360;
        double latitude = (0.5 - y * perRow) * 180;
        double level = Angles.cos(latitude);
        return lookAlong(ray, level * Angles.cos(longitude), level * Angles.sin(longitude), Angles.sin(latitude));
    }

    @Override
    void add(Bundle bundle, double x, double y, double slack) {
        double longitude = (x * perColumn - 0.5) * 360;
        double latitude = (0.5 - y * perRow) * 180;
        double level = Angles.cos(latitude);
        add(bundle, level * Angles.cos(longitude), level * Angles.sin(longitude), Angles.sin(latitude), slack);
    }

    @Override
    public boolean project(Vec3 world, double[] xy) {
        Vec3 v = world.minus(position);
        return !v.equals(Vec3.ZERO) && at(longitude(v) / (2 * Math.PI), latitude(v) / Math.PI, xy);
    }

    @Override
    public double[] tell(Ray ray) {
        Vec3 d = new Vec3(ray.dx, ray.dy, ray.dz);
        return new double[] {StrictMath.toDegrees(longitude(d)), StrictMath.toDegrees(latitude(d))};
    }

    private double longitude(Vec3 v) {
        return StrictMath.atan2(v.dot(right), v.dot(forward));
    }

    private double latitude(Vec3 v) {
        double ahead = v.dot(forward);
        double across = v.dot(right);
        return StrictMath.atan2(v.dot(up), Math.sqrt(ahead * ahead + across * across));
    }
}
