package cz.paprsek.shape.placed;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.ray.Line;
import cz.paprsek.tree.Search;
import org.jspecify.annotations.Nullable;

/**
 * A ray in world space and what it has hit so far. Scratch: the one mutable object of the hot path, owned by one worker.
 * A hit counts if min &lt; t &lt; max; each accepted hit lowers max.
 *
 * <p>A ray that starts on a surface knows which: it does not meet it again where it starts, however rounding moves that point, and misses
 * nothing else, however near. What lies within {@link #contact} of its start is there by rounding, in front of it or behind.
 */
public final class Ray {
    /**
     * Surfaces nearer to one another than this, relative to the numbers they come from, lie in one place: some ten thousand times what
     * rounding does to them.
     */
    public static final double TOUCH = 1e-11;

    public double ox;
    public double oy;
    public double oz;
    /** Direction, of length 1. */
    public double dx;
    public double dy;
    public double dz;
    /**
     * Reciprocal direction, always finite: 0 · infinity is NaN, and in Java a NaN wins every min and max. Known only after
     * {@link #needReciprocals}: many a ray meets no box, and three divisions are slow.
     */
    public double rx;
    public double ry;
    public double rz;
    private boolean hasReciprocals;
    /** The size of the numbers that led to the origin: what its rounding errors are relative to. */
    public double scale;
    public double min;
    public double max;
    /** The part whose surface the ray starts from, or −1; and whether it starts into the inside of that part. */
    public int left;
    public boolean inwards;
    /** What lies less far from the start than this touches the surface that the ray starts from. */
    public double contact;
    /** Up to where a hit lies in one place with the one at max. */
    public double reach;
    /** The {@linkplain Parts part} hit, or −1. */
    public int part;
    /** Which face of the part was hit, the part's own numbering; the complement {@code ~face} if an odd number of CSG operations flipped it. */
    public int face;

    /** What whoever was met last has left for itself, for {@link cz.paprsek.ray.Hit#hint}. */
    public int hint;

    /** The stretch of the ray that a convex body was last found to cover, and the faces at its ends. */
    public double enter;
    public double leave;
    public int enterFace;
    public int leaveFace;

    private final Line local = new Line();
    /** The operands, of all operations being evaluated, that the ray meets. */
    public final IntStack met = new IntStack();
    Operands.@Nullable Finder finder;
    /** Scratch of a surface that looks through a tree of its own. */
    public @Nullable Search<Ray> search;
    public final double[] breaks = new double[3];
    private double[] room = {};
    private @Nullable Ray within;
    public final Spans spans;

    public Ray(Spans spans) {
        this.spans = spans;
    }

    /** Starts a ray from the eye: nothing hit yet, and nothing too near or too far. */
    public void start(double x, double y, double z, double directionX, double directionY, double directionZ) {
        start(x, y, z, directionX, directionY, directionZ, Math.abs(x) + Math.abs(y) + Math.abs(z), Double.POSITIVE_INFINITY);
        left = -1;
        contact = 0;
        min = 0;
    }

    /** Starts a ray that is none: where the picture shows nothing. It hits nothing. */
    public void startBlind() {
        start(0, 0, 0, 0, 0, 1, 0, 0);
        left = -1;
        contact = 0;
        min = 0;
    }

    /** Whether nothing is seen because there is no ray, rather than because it hits nothing. */
    public boolean isBlind() {
        return max == 0;
    }

    /**
     * Starts a ray from a surface: nothing hit yet. What touches the surface counts as hit from {@code -contact} on.
     *
     * @param size the numbers that led to the origin, coordinates and distance travelled, added up
     * @param end where the ray ends; exclusive
     * @param surface the part whose surface it is
     * @param intoIt whether the ray starts into the inside of that part
     */
    public void start(double x, double y, double z, double directionX, double directionY, double directionZ, double size, double end,
            int surface, boolean intoIt) {
        start(x, y, z, directionX, directionY, directionZ, size, end);
        left = surface;
        inwards = intoIt;
        contact = TOUCH * size;
        min = -contact;
    }

    private void start(double x, double y, double z, double directionX, double directionY, double directionZ, double size, double end) {
        ox = x;
        oy = y;
        oz = z;
        dx = directionX;
        dy = directionY;
        dz = directionZ;
        hasReciprocals = false;
        scale = size;
        max = end;
        reach = end;
        part = -1;
    }

    /** Starts the same ray anew, with nothing hit, to look at a stretch of it only. */
    public void within(Ray other, double from, double to) {
        start(other.ox, other.oy, other.oz, other.dx, other.dy, other.dz, other.scale, to);
        left = other.left;
        inwards = other.inwards;
        contact = other.contact;
        min = from;
    }

    /** Scratch for the same ray in the space of something that it meets. */
    public Ray within() {
        Ray known = within;
        if (known == null) {
            known = new Ray(spans);
            within = known;
        }
        return known;
    }

    /**
     * Becomes another ray in the space that a map leads to, with nothing hit.
     *
     * @param growth how often as fast t grows there, so that the direction is of length 1 again
     * @param surface the part, by its number there, that the ray starts from; −1 for none
     */
    public void become(Ray other, Affine map, double growth, int surface) {
        double x = map.pointX(other.ox, other.oy, other.oz);
        double y = map.pointY(other.ox, other.oy, other.oz);
        double z = map.pointZ(other.ox, other.oy, other.oz);
        double before = growth * other.scale;
        double here = Math.abs(x) + Math.abs(y) + Math.abs(z);
        start(x, y, z, map.directionX(other.dx, other.dy, other.dz) / growth, map.directionY(other.dx, other.dy, other.dz) / growth,
                map.directionZ(other.dx, other.dy, other.dz) / growth, Math.max(before, here), growth * other.max);
        // Larger numbers have larger errors: more of what lies near touches the start.
        double wider = before > 0 && here > before ? here / before : 1;
        left = surface;
        inwards = other.inwards;
        contact = growth * other.contact * wider;
        min = growth * other.min * (other.min < 0 ? wider : 1);
        reach = growth * other.reach;
    }

    /** The ray in the space that the map leads to. Its direction keeps the length that the map gives it, so t keeps its meaning. */
    public Line in(Affine map) {
        Line line = local;
        line.ox = map.pointX(ox, oy, oz);
        line.oy = map.pointY(ox, oy, oz);
        line.oz = map.pointZ(ox, oy, oz);
        line.dx = map.directionX(dx, dy, dz);
        line.dy = map.directionY(dx, dy, dz);
        line.dz = map.directionZ(dx, dy, dz);
        return line;
    }

    /** Scratch of at least so many numbers, for a surface while it is met. */
    public double[] room(int numbers) {
        if (room.length < numbers) {
            room = new double[numbers];
        }
        return room;
    }

    /** How far from a hit at t others lie in one place with it. */
    public double touch(double t) {
        return TOUCH * (scale + Math.abs(t));
    }

    /** Works the reciprocal direction out, once. */
    public void needReciprocals() {
        if (!hasReciprocals) {
            rx = reciprocal(dx);
            ry = reciprocal(dy);
            rz = reciprocal(dz);
            hasReciprocals = true;
        }
    }

    /** Takes a hit that is known to lie between min and reach. Of hits in one place the lowest part's counts, whichever was found first. */
    public void accept(double t, int hitPart, int hitFace) {
        if (part < 0 || hitPart < part || t < max - (reach - max)) {
            max = t;
            reach = t + touch(t);
            part = hitPart;
            face = hitFace;
        }
    }

    /** Makes something else the hit, that was found to be met first. */
    public void settle(double t, int hitPart, int hitFace) {
        max = t;
        part = hitPart;
        face = hitFace;
    }

    /** Whether the part of the ray between min and max meets the box. */
    public boolean meets(Bounds box) {
        return meets(box, min, max);
    }

    /** Whether the part of the ray between two values of t meets the box. */
    boolean meets(Bounds box, double from, double to) {
        needReciprocals();
        boolean forwardX = rx > 0;
        double near = ((forwardX ? box.minX() : box.maxX()) - ox) * rx;
        double far = ((forwardX ? box.maxX() : box.minX()) - ox) * rx;
        if (far < from || near > to) {
            return false;
        }
        boolean forwardY = ry > 0;
        double nearY = ((forwardY ? box.minY() : box.maxY()) - oy) * ry;
        double farY = ((forwardY ? box.maxY() : box.minY()) - oy) * ry;
        if (farY < from || nearY > to || nearY > far || near > farY) {
            return false;
        }
        near = nearY > near ? nearY : near;
        far = farY < far ? farY : far;
        boolean forwardZ = rz > 0;
        double nearZ = ((forwardZ ? box.minZ() : box.maxZ()) - oz) * rz;
        double farZ = ((forwardZ ? box.maxZ() : box.minZ()) - oz) * rz;
        return farZ >= from && nearZ <= to && nearZ <= far && near <= farZ;
    }

    private static double reciprocal(double d) {
        double r = 1 / d;
        return Math.abs(r) <= Double.MAX_VALUE ? r : Math.copySign(Double.MAX_VALUE, d);
    }
}
