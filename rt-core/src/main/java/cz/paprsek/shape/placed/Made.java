package cz.paprsek.shape.placed;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.ray.Line;
import cz.paprsek.text.Numbers;
import java.util.Objects;

/** A shape that was made in code, somewhere in the world: what it is asked, in its own space, and whether its answers can be. */
public final class Made implements Part {
    private final int part;
    private final Bounds bounds;
    private final double cost;
    private final ByHand shape;
    private final Affine toLocal;

    /** @throws IllegalArgumentException unless the shape says its bounds and cost in numbers */
    public Made(int part, Affine toWorld, ByHand shape) {
        this.part = part;
        this.shape = shape;
        toLocal = toWorld.inverse();
        Bounds box = Objects.requireNonNull(shape.bounds(), () -> "a " + shape.kind() + " has no bounds");
        boolean isBox = !Double.isNaN(box.minX() + box.minY() + box.minZ()) && !Double.isNaN(box.maxX() + box.maxY() + box.maxZ());
        Require.that(isBox, "the bounds of a " + shape.kind() + " must be of numbers, but are " + box);
        bounds = box.transformed(toWorld);
        cost = Require.positive("cost of a " + shape.kind(), shape.cost());
    }

    /** Where a ray crosses it. */
    private Line crossed(Ray ray) {
        Line line = ray.in(toLocal);
        line.clear();
        shape.cross(line);
        for (int i = 0; i < line.crossings(); i++) {
            if (Double.isNaN(line.t(i))) {
                throw new IllegalStateException("a " + shape.kind() + " says that a line crosses it at " + line.t(i));
            }
        }
        return line;
    }

    /** Describes a hit in its own space, and takes the answer to the world. */
    @Override
    public void describe(int face, Hit hit) {
        double x = hit.px;
        double y = hit.py;
        double z = hit.pz;
        toLocal(hit, toLocal);
        shape.normal(face, hit);
        place(hit, x, y, z);
        hit.normal(toLocal, hit.nx, hit.ny, hit.nz);
        double square = hit.nx * hit.nx + hit.ny * hit.ny + hit.nz * hit.nz;
        // Not <: false for what is not a number.
        if (!(square > 0)) {
            throw new IllegalStateException("a " + shape.kind() + " has a normal that is no direction, of its face " + face + " at "
                    + Numbers.text(new Vec3(x, y, z)) + " in the world");
        }
    }

    /** Maps a hit in its own space, and takes the answer to the world. */
    @Override
    public void map(int face, Hit hit) {
        double x = hit.px;
        double y = hit.py;
        double z = hit.pz;
        toLocal(hit, toLocal);
        shape.map(face, hit);
        place(hit, x, y, z);
        hit.tangentFrom(toLocal);
        if (!(Math.abs(hit.u) <= Double.MAX_VALUE && Math.abs(hit.v) <= Double.MAX_VALUE)) {
            throw new IllegalStateException("a " + shape.kind() + " has a u of " + hit.u + " and a v of " + hit.v + ", which are no numbers, on its face " + face + " at "
                    + Numbers.text(new Vec3(x, y, z)) + " in the world");
        }
    }

    /**
     * Maps a hit as on a globe about the middle of the shape's bounds. Along the surface, u grows and v does not where its direction e from the
     * middle changes as on the globe, by e′: towards e′ + a·e with the a for which that is at right angles to the normal.
     */
    public static void mapGlobe(ByHand shape, int face, Hit hit) {
        Bounds box = shape.bounds();
        double x = box.isFinite() ? hit.px - (box.minX() + box.maxX()) / 2 : hit.px;
        double y = box.isFinite() ? hit.py - (box.minY() + box.maxY()) / 2 : hit.py;
        double z = box.isFinite() ? hit.pz - (box.minZ() + box.maxZ()) / 2 : hit.pz;
        hit.mapGlobe(x, y, z);
        double nx = hit.nx;
        double ny = hit.ny;
        double nz = hit.nz;
        double sx = hit.sx;
        double sy = hit.sy;
        double sz = hit.sz;
        shape.normal(face, hit);
        double along = hit.tx * hit.nx + hit.ty * hit.ny + hit.tz * hit.nz;
        double outwards = x * hit.nx + y * hit.ny + z * hit.nz;
        hit.unitNormal(nx, ny, nz);
        hit.sx = sx;
        hit.sy = sy;
        hit.sz = sz;
        double a = -along / outwards;
        if (Math.abs(a) < Double.MAX_VALUE) {
            hit.map(hit.u, hit.v, hit.tx + a * x, hit.ty + a * y, hit.tz + a * z);
        }
    }

    private static void toLocal(Hit hit, Affine map) {
        place(hit, map.pointX(hit.px, hit.py, hit.pz), map.pointY(hit.px, hit.py, hit.pz), map.pointZ(hit.px, hit.py, hit.pz));
    }

    private static void place(Hit hit, double x, double y, double z) {
        hit.px = x;
        hit.py = y;
        hit.pz = z;
    }

    /** A figure made in code, in the world. */
    public static final class Figure extends Surface {
        private final Made made;

        public Figure(Made made) {
            this.made = made;
        }

        @Override
        public Bounds bounds() {
            return made.bounds;
        }

        @Override
        public double cost() {
            return made.cost;
        }

        @Override
        public void nearest(Ray ray) {
            Line line = made.crossed(ray);
            int start = start(line, ray);
            for (int i = 0; i < line.crossings(); i++) {
                if (i != start && isWithin(line.t(i), ray.min, ray.reach)) {
                    ray.accept(line.t(i), made.part, line.face(i));
                }
            }
        }

        @Override
        public boolean occludes(Ray ray) {
            Line line = made.crossed(ray);
            int start = start(line, ray);
            for (int i = 0; i < line.crossings(); i++) {
                if (i != start && isWithin(line.t(i), ray.contact, ray.max)) {
                    return true;
                }
            }
            return false;
        }

        @Override
        public void crossings(Ray ray, Spans out) {
            Line line = made.crossed(ray);
            int start = start(line, ray);
            for (int i = 0; i < line.crossings(); i++) {
                if (i != start && isWithin(line.t(i), ray.min, ray.max)) {
                    out.add(line.t(i), made.part, line.face(i));
                }
            }
        }

        private static boolean isWithin(double t, double from, double to) {
            return t > from && t < to;
        }

        /** Which crossing is where the ray starts, if it starts from this figure: the one nearest to that place; −1 for none. */
        private int start(Line line, Ray ray) {
            if (made.part != ray.left) {
                return -1;
            }
            int nearest = line.crossings() - 1;
            for (int i = nearest - 1; i >= 0; i--) {
                // <=: of several in one place the first.
                nearest = Math.abs(line.t(i)) <= Math.abs(line.t(nearest)) ? i : nearest;
            }
            return nearest;
        }
    }

    /** A solid made in code, in the world. */
    public static final class Body extends Volume {
        private final Made made;

        public Body(Made made) {
            this.made = made;
        }

        @Override
        public Bounds bounds() {
            return made.bounds;
        }

        @Override
        public double cost() {
            return made.cost;
        }

        @Override
        public void spans(Ray ray, Spans out) {
            Line line = made.crossed(ray);
            int count = line.crossings();
            int mark = out.size();
            for (int i = 0; i < count; i++) {
                if (i > 0 && !(line.t(i) >= line.t(i - 1))) {
                    throw new IllegalStateException("a " + made.shape.kind() + " says that a line crosses it at " + line.t(i) + " after " + line.t(i - 1)
                            + "; it must be in rising order");
                }
                out.add(line.t(i), made.part, line.face(i));
            }
            if (count % 2 != 0) {
                throw new IllegalStateException("a " + made.shape.kind() + " says that a line crosses it " + count + " times; it must be left as often as it is entered");
            }
            if (made.part == ray.left) {
                out.leaveFrom(mark, ray.inwards);
            }
        }
    }
}
