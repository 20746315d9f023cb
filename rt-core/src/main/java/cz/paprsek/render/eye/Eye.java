package cz.paprsek.render.eye;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.lanes.Vec3s;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.tree.Bundle;

/**
 * A camera ready for pictures of one size, one class for each lens: makes the rays through points of the picture and, the other way round,
 * finds where on the picture a point of the world is. Immutable.
 */
public abstract class Eye {
    /** The middle of a lens, in both directions. */
    private static final double MIDDLE = 0.5;
    private static final double[] NOTHING = {};

    final Vec3 position;
    final Vec3 forward;
    final Vec3 right;
    final Vec3 up;
    final double aspect;
    /** Shares of the picture's width and height. */
    final double perColumn;
    final double perRow;
    private final Bounds point;

    Eye(Camera camera, double width, double height, int step) {
        this.position = camera.position();
        this.forward = camera.forward();
        this.right = camera.right();
        this.up = camera.trueUp();
        this.aspect = width / height;
        this.perColumn = step / width;
        this.perRow = step / height;
        this.point = Bounds.of(position, position);
    }

    /** The eye of a camera. */
    public static Eye of(Camera camera, double width, double height) {
        return of(camera, width, height, 1);
    }

    /** An eye for a coarse picture, whose pixels are squares of step × step pixels of the one that is width × height in size. */
    public static Eye of(Camera camera, double width, double height, int step) {
        Lens lens = camera.lens();
        if (lens instanceof Lens.Perspective perspective) {
            return perspective.aperture() > 0 ? new ThinLens(camera, perspective, width, height, step)
                    : new Pinhole(camera, perspective, width, height, step);
        } else if (lens instanceof Lens.Orthographic orthographic) {
            return new Parallel(camera, orthographic, width, height, step);
        } else if (lens instanceof Lens.Fisheye fisheye) {
            return new Circle(camera, fisheye, width, height, step);
        }
        return new Globe(camera, width, height, step);
    }

    /**
     * Starts the ray through a point of the picture; the centre of pixel (column j, row i) is (j + ½, i + ½).
     *
     * @param lensU where on the lens, 0–1; without meaning for one of no size
     * @param lensV likewise
     * @return false if the picture shows nothing there: the ray is {@linkplain Ray#isBlind blind}, and what it brings black
     */
    public abstract boolean start(Ray ray, double x, double y, double lensU, double lensV);

    /** Whether all rays start in one place, so that their directions can be told at once by {@link #look(Views, int)}. */
    public boolean looksFromOnePlace() {
        return false;
    }

    /** Finds the directions of the rays through the first so many places: bit by bit those of the rays that are started by themselves. */
    public void look(Views views, int count) {
        throw new UnsupportedOperationException("rays that start in several places");
    }

    /** Starts one of these rays. */
    public final void start(Ray ray, Views views, int i) {
        Vec3s to = views.directions;
        ray.start(position.x(), position.y(), position.z(), to.x[i], to.y[i], to.z[i]);
    }

    /** Makes a bundle of all rays through a block of pixels; false if they cannot be bundled. */
    public abstract boolean bundle(Bundle bundle, int left, int top, int columns, int rows);

    /**
     * Where the picture shows a point of the world that nothing hides, through the middle of the lens. Every other way from the world to the
     * picture goes through this one.
     *
     * @param xy takes the place, in pixels from the top left corner; perhaps beyond the picture
     * @return false if there is no such place
     */
    public abstract boolean project(Vec3 world, double[] xy);

    /** Whether straight lines are straight on the picture. */
    public boolean keepsLines() {
        return true;
    }

    /** Whether it matters where on the lens a ray starts. */
    public boolean hasAperture() {
        return false;
    }

    /** The box around all points where rays start. */
    public Bounds origins() {
        return point;
    }

    /**
     * What there is to say of a ray that this eye has started, in two numbers; none of a pinhole. How far it starts from the eye's position, to
     * the right and upwards; longitude and latitude in degrees; or where on the circle it belongs.
     */
    public double[] tell(Ray ray) {
        return NOTHING;
    }

    /** How far in front of the eye a point lies, along the view. */
    public final double depth(Vec3 world) {
        return world.minus(position).dot(forward);
    }

    /** Starts the ray through a point of the picture and the middle of the lens. */
    public final boolean start(Ray ray, double x, double y) {
        return start(ray, x, y, MIDDLE, MIDDLE);
    }

    /** How far from the eye's position a ray starts. */
    final double[] aside(Ray ray) {
        Vec3 aside = new Vec3(ray.ox, ray.oy, ray.oz).minus(position);
        return new double[] {aside.dot(right), aside.dot(up)};
    }

    /** Starts a ray from the eye's position. */
    final boolean look(Ray ray, double dx, double dy, double dz) {
        double k = 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
        ray.start(position.x(), position.y(), position.z(), dx * k, dy * k, dz * k);
        return true;
    }

    /** Puts down a place that is given as shares of the picture from its middle, to the right and upwards. */
    final boolean at(double acrossShare, double upShare, double[] xy) {
        xy[0] = (0.5 + acrossShare) / perColumn;
        xy[1] = (0.5 - upShare) / perRow;
        return true;
    }
}
