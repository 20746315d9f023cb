package cz.paprsek.render.eye;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.tree.Bundle;

/** An orthographic eye: the ray through (x, y) goes along the view from P + (x/W − ½)·h·W/H·r + (½ − y/H)·h·u, h the height of what is seen. */
final class Parallel extends Eye {
    /** By how many pixels rays may start beyond the picture: the two that filters reach, and one for a coarse picture's last, which may stick out. */
    private static final int MARGIN = 3;

    private final Vec3 across;
    private final Vec3 upwards;
    private final double high;
    private final Bounds plane;

    Parallel(Camera camera, Lens.Orthographic lens, double width, double height, int step) {
        super(camera, width, height, step);
        high = lens.height();
        across = right.times(high * width / height);
        upwards = up.times(high);
        plane = between(-MARGIN, -MARGIN, 1 / perColumn + MARGIN, 1 / perRow + MARGIN);
    }

    @Override
    public boolean start(Ray ray, double x, double y, double lensU, double lensV) {
        ray.start(startX(x, y), startY(x, y), startZ(x, y), forward.x(), forward.y(), forward.z());
        return true;
    }

    @Override
    public boolean bundle(Bundle bundle, int left, int top, int columns, int rows) {
        Bounds from = between(left, top, left + columns, top + rows);
        bundle.start(from.minX(), from.minY(), from.minZ(), from.maxX(), from.maxY(), from.maxZ());
        bundle.add(forward.x(), forward.y(), forward.z());
        return true;
    }

    @Override
    public boolean project(Vec3 world, double[] xy) {
        Vec3 v = world.minus(position);
        return v.dot(forward) >= 0 && at(v.dot(right) / (high * aspect), v.dot(up) / high, xy);
    }

    @Override
    public double[] tell(Ray ray) {
        return aside(ray);
    }

    @Override
    public Bounds origins() {
        return plane;
    }

    /** The box around where rays start through a rectangle of the picture. */
    private Bounds between(double left, double top, double end, double bottom) {
        Bounds box = Bounds.EMPTY;
        for (int corner = 0; corner < 4; corner++) {
            double x = (corner & 1) == 0 ? left : end;
            double y = (corner >> 1) == 0 ? top : bottom;
            Vec3 start = new Vec3(startX(x, y), startY(x, y), startZ(x, y));
            box = box.union(Bounds.of(start, start));
        }
        return box;
    }

    private double startX(double x, double y) {
        return position.x() + (x * perColumn - 0.5) * across.x() + (0.5 - y * perRow) * upwards.x();
    }

    private double startY(double x, double y) {
        return position.y() + (x * perColumn - 0.5) * across.y() + (0.5 - y * perRow) * upwards.y();
    }

    private double startZ(double x, double y) {
        return position.z() + (x * perColumn - 0.5) * across.z() + (0.5 - y * perRow) * upwards.z();
    }
}
