package cz.paprsek.shape.check;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.check.Problems.Promise;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.shape.placed.Volume;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;

/** A shape in one place, tried with lines that mostly meet it. */
final class Trial {
    private static final int LINES = 2_000;
    /** Relative to the size of the shape: how far rounding may move a crossing, and how far apart places are to be told apart. */
    private static final double ROUNDING = 1e-9;
    private static final double APART = 1e-6;
    /** How far a neighbour is looked for, and how far off the plane of the normal it may be, relative to that. */
    private static final double STEP = 1e-5;
    private static final double BENT = 1e-2;

    private final Random random = new Random(17);
    private final Affine toLocal;
    private final Problems problems;
    private final List<Part> parts = new ArrayList<>();
    private final Surface surface;
    private final Vec3 middle;
    private final Vec3 half;
    private final double size;
    private final boolean isBounded;

    Trial(Shape shape, Affine toWorld, Problems problems) {
        this.toLocal = toWorld.inverse();
        this.problems = problems;
        this.surface = shape.place(toWorld, new Registry());
        this.isBounded = surface.bounds().isFinite();
        Bounds box = isBounded ? surface.bounds() : Bounds.around(Vec3.ZERO, new Vec3(3, 3, 3)).transformed(toWorld);
        this.middle = new Vec3((box.minX() + box.maxX()) / 2, (box.minY() + box.maxY()) / 2, (box.minZ() + box.maxZ()) / 2);
        this.half = new Vec3((box.maxX() - box.minX()) / 2, (box.maxY() - box.minY()) / 2, (box.maxZ() - box.minZ()) / 2);
        this.size = half.length();
    }

    private final class Registry implements Parts {
        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            P part = maker.apply(parts.size());
            parts.add(part);
            return part;
        }

        @Override
        public Parts within(MaterialSource material, Affine toWorld) {
            return this;
        }
    }

    void run() {
        try {
            for (int i = 0; i < LINES; i++) {
                Vec3 through = middle.plus(new Vec3(between() * half.x(), between() * half.y(), between() * half.z()));
                Vec3 d = direction();
                tryLine(through.minus(d.times(2 * size)), d);
            }
        } catch (RuntimeException thrown) {
            problems.threw(thrown);
        }
    }

    private double between() {
        return 2 * random.nextDouble() - 1;
    }

    private Vec3 direction() {
        Vec3 v = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
        return v.length() > 0 ? v.normalized() : Vec3.X;
    }

    private void tryLine(Vec3 o, Vec3 d) {
        Ray ray = ray(o, d);
        Spans all = crossings(ray);
        problems.expect(Promise.MET, all.size() > 0, toLocal.point(o));
        Ray nearest = ray(o, d);
        surface.nearest(nearest);
        boolean agrees = nearest.part < 0 ? first(all) == Double.POSITIVE_INFINITY : nearest.max == first(all);
        problems.expect(Promise.NEAREST, agrees && surface.occludes(ray(o, d)) == nearest.part >= 0, toLocal.point(o));
        sameElsewhere(o, d, all);
        for (int i = 0; i < all.size(); i++) {
            if (Math.abs(all.t(i)) < 1e3 * size) {
                tryCrossing(o, d, all, i);
            }
        }
    }

    private static double first(Spans all) {
        double first = Double.POSITIVE_INFINITY;
        for (int i = 0; i < all.size(); i++) {
            first = all.t(i) > 0 && all.t(i) < first ? all.t(i) : first;
        }
        return first;
    }

    /** Every boundary on the whole line, of a solid in order. */
    private Spans crossings(Ray ray) {
        Spans spans = new Spans();
        ray.min = Double.NEGATIVE_INFINITY;
        if (surface instanceof Volume volume) {
            volume.spans(ray, spans);
        } else {
            surface.crossings(ray, spans);
        }
        return spans;
    }

    private static Ray ray(Vec3 o, Vec3 d) {
        Ray ray = new Ray(new Spans());
        ray.start(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
        return ray;
    }

    private void sameElsewhere(Vec3 o, Vec3 d, Spans all) {
        double shift = 2 * size * (1 + between() / 2);
        Spans onwards = crossings(ray(o.plus(d.times(shift)), d));
        Spans back = crossings(ray(o.plus(d.times(shift)), d.negated()));
        boolean same = onwards.size() == all.size() && back.size() == all.size();
        if (same && surface instanceof Volume) {
            for (int i = 0; i < all.size(); i++) {
                same &= isNear(onwards.t(i), all.t(i) - shift) && isNear(-back.t(all.size() - 1 - i), all.t(i) - shift);
            }
        }
        problems.expect(Promise.LINE, same, toLocal.point(o));
    }

    private boolean isNear(double a, double b) {
        return a == b || Math.abs(a - b) < APART * size;
    }

    private void tryCrossing(Vec3 o, Vec3 d, Spans all, int i) {
        Vec3 p = o.plus(d.times(all.t(i)));
        Vec3 where = toLocal.point(p);
        problems.expect(Promise.BOUNDS, surface.bounds().grown(ROUNDING * (size + middle.length())).contains(p), where);
        Hit hit = new Hit();
        describe(hit, p, all.part(i), all.face(i));
        boolean isDirection = isUnit(hit.nx, hit.ny, hit.nz);
        boolean isMapped = Double.isFinite(hit.u) && Double.isFinite(hit.v) && isUnit(hit.tx, hit.ty, hit.tz);
        problems.expect(Promise.LENGTH, isDirection, where);
        if (!isDirection) {
            return;
        }
        Vec3 n = new Vec3(hit.nx, hit.ny, hit.nz);
        problems.expect(Promise.MAP, isMapped && Math.abs(new Vec3(hit.tx, hit.ty, hit.tz).dot(n)) < APART, where);
        neighbour(p, n, d, all.part(i), all.face(i), where);
        if (surface instanceof Volume volume) {
            problems.expect(Promise.SIDE, i % 2 == 0 ? d.dot(n) < APART : d.dot(n) > -APART, where);
            double end = Math.min(i + 1 < all.size() ? all.t(i + 1) : Double.POSITIVE_INFINITY, all.t(i) + size);
            if (end - all.t(i) > APART * size) {
                Vec3 between = o.plus(d.times((all.t(i) + end) / 2));
                problems.expect(Promise.INSIDE, volume.holdsOrigin(ray(between, direction())) == (i % 2 == 0), toLocal.point(between));
            }
            if (isBounded && Math.abs(d.dot(n)) > APART) {
                leave(p, d, d.dot(n) < 0, all, i, where);
            }
        }
    }

    private static boolean isUnit(double x, double y, double z) {
        return Math.abs(x * x + y * y + z * z - 1) < ROUNDING;
    }

    /** What a ray that starts on the surface crosses: an odd number of boundaries if it goes inwards, else an even one. */
    private void leave(Vec3 p, Vec3 d, boolean inwards, Spans all, int i, Vec3 where) {
        Ray onwards = new Ray(new Spans());
        boolean flipped = all.face(i) < 0;
        onwards.start(p.x(), p.y(), p.z(), d.x(), d.y(), d.z(), size + middle.length(), Double.POSITIVE_INFINITY, all.part(i), inwards != flipped);
        Spans ahead = new Spans();
        surface.crossings(onwards, ahead);
        problems.expect(Promise.LEAVING, ahead.size() % 2 == 1 == inwards, where);
    }

    private void describe(Hit hit, Vec3 p, int part, int face) {
        hit.px = p.x();
        hit.py = p.y();
        hit.pz = p.z();
        parts.get(part).describe(face < 0 ? ~face : face, hit);
        parts.get(part).map(face < 0 ? ~face : face, hit);
        if (face < 0) {
            hit.turn();
        }
    }

    /** A small step aside, in the plane of the normal: the surface must be there again, but for its bend. */
    private void neighbour(Vec3 p, Vec3 n, Vec3 d, int part, int face, Vec3 where) {
        Vec3 aside = n.cross(direction());
        if (aside.length() < 0.1 || Math.abs(d.dot(n)) < 0.1) {
            return;
        }
        double step = STEP * size;
        Vec3 beside = p.plus(aside.normalized().times(step));
        Spans near = crossings(ray(beside.minus(n.times(size)), n));
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < near.size(); i++) {
            if (near.part(i) == part && near.face(i) == face) {
                least = Math.min(least, Math.abs(near.t(i) - size));
            }
        }
        if (least < step) {
            problems.expect(Promise.NORMAL, least < BENT * step + 1e-12 * (size + middle.length()), where);
        } else {
            // Beside an edge there is no neighbour; a normal along the surface finds none anywhere.
            problems.expect(Promise.NORMAL, near.size() == 0 || least == Double.POSITIVE_INFINITY, where);
        }
    }
}
