package cz.paprsek.shape.placed;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.tree.Row;
import java.util.Arrays;
import java.util.Optional;

/**
 * Balls side by side, to find out which of a row of surfaces a ray passes by: asking those by themselves takes a call and a walk through
 * memory each. Where most are convex, others than balls have a ball around them, and so have bodies put together of which it is known; what has none may always be met.
 */
public final class Balls {
    /** By so much a ball around a body is larger than that, of its radius and of where it is: more than rounding does to both. */
    private static final double LARGER = 1e-6;
    private static final double ROUNDING = 1e-11;
    /** The ball of a body that is put together is asked if it hides less than so much of what its box does. */
    private static final double CLEARLY = 0.9;

    /** For each surface x, y, z and the square of the radius, which is infinite if it has no ball; empty if none has. */
    private final double[] values;
    /** Whether at least two of three surfaces are convex and have an end. */
    public final boolean areMost;

    /** Looks through surfaces, which keep their numbers. */
    public Balls(Surface[] surfaces) {
        long convex = Arrays.stream(surfaces).filter(Balls::isRound).count();
        areMost = convex > 0 && 3 * convex >= 2L * surfaces.length;
        double[] found = new double[4 * surfaces.length];
        boolean any = false;
        for (int i = 0; i < surfaces.length; i++) {
            if (surfaces[i] instanceof Ball ball) {
                ball.put(found, 4 * i);
                any = true;
            } else if (areMost && isRound(surfaces[i])) {
                put(surfaces[i].bounds(), found, 4 * i);
                any = true;
            } else if (surfaces[i] instanceof Volume body && !(body instanceof Convex) && isWithinBall(body, found, 4 * i)) {
                any = true;
            } else {
                found[4 * i + 3] = Double.POSITIVE_INFINITY;
            }
        }
        values = any ? found : new double[0];
    }

    private static boolean isRound(Surface surface) {
        return surface instanceof Ball || (surface instanceof Convex && surface.bounds().isFinite());
    }

    private static void put(Bounds box, double[] into, int at) {
        Vec3 middle = box.middle();
        double radius = (1 + LARGER) * new Vec3(box.maxX(), box.maxY(), box.maxZ()).minus(middle).length() + ROUNDING * box.magnitude();
        into[at] = middle.x();
        into[at + 1] = middle.y();
        into[at + 2] = middle.z();
        into[at + 3] = radius * radius;
    }

    /** Whether a ball around a body put together is met by clearly fewer rays than its box, which has been met already: then the ball is written. */
    private static boolean isWithinBall(Volume body, double[] into, int at) {
        Bounds box = body.bounds();
        into[at + 3] = Double.POSITIVE_INFINITY;
        body.carved().ifPresent(carved -> carved.putAround(into, at));
        // Of a convex body a quarter of the surface, from all sides.
        double x = box.maxX() - box.minX();
        double y = box.maxY() - box.minY();
        double z = box.maxZ() - box.minZ();
        return Math.PI * into[at + 3] < CLEARLY * 0.5 * (x * y + y * z + z * x);
    }

    /** Whether there is a ball around any of the surfaces. */
    public boolean areAny() {
        return values.length > 0;
    }

    /** Writes middle and squared radius of the ball around a surface; false if there is none. */
    public boolean putAround(int surface, double[] into) {
        boolean is = areAny() && values[4 * surface + 3] < Double.POSITIVE_INFINITY;
        if (is) {
            System.arraycopy(values, 4 * surface, into, 0, 4);
        }
        return is;
    }

    /** All of them in a row, if that is asked sooner than one by one. */
    public Optional<Row> row() {
        return Row.of(values);
    }

    /** Whether there is a ball around each of a row. */
    boolean haveAll(int first, int end) {
        for (int i = first; i < end; i++) {
            if (values[4 * i + 3] == Double.POSITIVE_INFINITY) {
                return false;
            }
        }
        return true;
    }

    /** Meets a surface with those rays of a sheaf that may meet it. */
    void nearest(Surface surface, int number, Sheaf sheaf) {
        int at = 4 * number;
        sheaf.nearest(surface, values[at], values[at + 1], values[at + 2], values[at + 3]);
    }

    /** Whether the line of the ray may meet a surface; for a ball by the very arithmetic by which it is met. */
    public boolean mayBeMet(int surface, Ray ray) {
        return values.length == 0
                || Ball.half(ray, values[4 * surface], values[4 * surface + 1], values[4 * surface + 2], values[4 * surface + 3]) > 0;
    }
}
