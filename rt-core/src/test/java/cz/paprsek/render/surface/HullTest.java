package cz.paprsek.render.surface;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.tree.Bundle;
import cz.paprsek.tree.Entries;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/** Of the walls of a room only those are met that a ray may hit: as if all were met, to the last bit. */
class HullTest {
    /** In every build few; the proof, which takes longer, is to be had by {@code -Dpaprsek.proof}. */
    private static final int ROOMS = System.getProperty("paprsek.proof") == null ? 400 : 5_000;

    /** Numbers parts as they come, with gaps. */
    private static final class Numbers implements Parts {
        private final int step;
        private int next;

        Numbers(int step) {
            this.step = step;
        }

        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            next += step;
            return maker.apply(next);
        }

        @Override
        public Parts within(MaterialSource material, Affine toWorld) {
            return this;
        }
    }

    /** What a room of a random kind is made of: up to six walls, some turned over, stretched, leaning or smaller than their side, and things in it. Some are of glass. */
    private static final class Room {
        final Random random;
        final double scale;
        final Vec3 low;
        final Vec3 high;
        final List<Surface> surfaces = new ArrayList<>();
        final List<Boolean> opaque = new ArrayList<>();
        private final boolean hasGlass;

        Room(long seed) {
            random = new Random(seed);
            hasGlass = random.nextBoolean();
            scale = Math.pow(10, random.nextInt(13) - 6);
            low = vec(scale * (random.nextInt(3) - 1) * random.nextDouble()).times(random.nextInt(4) == 0 ? 1000 : 1);
            high = low.plus(new Vec3(scale * (0.5 + random.nextDouble()), scale * (0.5 + random.nextDouble()), scale * (0.5 + random.nextDouble())));
            Numbers parts = new Numbers(1 + random.nextInt(40));
            Vec3 size = high.minus(low);
            int missing = (random.nextBoolean() ? 0 : 1 << random.nextInt(6)) | (random.nextInt(3) == 0 ? 1 << random.nextInt(6) : 0);
            for (int side = 0; side < 6; side++) {
                if (((missing >> side) & 1) == 0) {
                    wall(side, size, parts);
                }
            }
            for (int i = random.nextInt(3) == 0 ? 5 + random.nextInt(5) : random.nextInt(4); i > 0; i--) {
                place(random.nextBoolean() ? new Sphere(0.2 * scale) : random.nextBoolean() ? new Disc(0.2 * scale) : new Rectangle(-0.1 * scale, -0.2 * scale, 0.2 * scale, 0.1 * scale),
                        Affine.translation(inside()).after(Affine.rotation(new Vec3(90 * random.nextInt(4), random.nextInt(360), 0))), parts);
            }
        }

        private void wall(int side, Vec3 size, Parts parts) {
            Vec3 at = side % 2 == 0 ? low : high;
            int axis = side / 2;
            double left = random.nextInt(5) == 0 ? 0.1 : 0;
            boolean isOver = random.nextBoolean();
            double u = axis == 0 ? size.z() : size.x();
            double v = axis == 1 ? size.z() : size.y();
            Affine turn = Affine.rotation(axis == 0 ? new Vec3(0, -90, 0) : axis == 1 ? new Vec3(90, 0, 0) : Vec3.ZERO);
            Affine over = isOver ? new Affine(0, 1, 0, 0, 1, 0, 0, 0, 0, 0, -1, 0) : Affine.IDENTITY;
            Vec3 corner = new Vec3(axis == 0 ? at.x() : low.x(), axis == 1 ? at.y() : low.y(), axis == 2 ? at.z() : low.z());
            double across = isOver ? v : u;
            double along = isOver ? u : v;
            Vec3 stretch = stretch();
            Affine shape = Affine.translation(corner).after(turn).after(over).after(lean()).after(Affine.scaling(stretch));
            place(new Rectangle(left * across / stretch.x(), left * along / stretch.y(), across / stretch.x(), along / stretch.y()), shape, parts);
        }

        /** Some walls are a little out of true, so that they are none, or hardly. */
        private Affine lean() {
            double lean = random.nextInt(8) == 0 ? (random.nextBoolean() ? 1 : -1) * Math.toDegrees(Math.pow(10, -2 - 11 * random.nextDouble())) : 0;
            return Affine.rotation(random.nextBoolean() ? new Vec3(lean, 0, 0) : new Vec3(0, lean, 0));
        }

        /** Some are made by stretching others, along one axis. */
        private Vec3 stretch() {
            double by = random.nextInt(4) == 0 ? Math.pow(10, (scale < 1 ? -6 : 6) * random.nextDouble()) : 1;
            int axis = random.nextInt(3);
            return new Vec3(axis == 0 ? by : 1, axis == 1 ? by : 1, axis == 2 ? by : 1);
        }

        private void place(Shape shape, Affine toWorld, Parts parts) {
            surfaces.add(shape.place(toWorld, parts));
            opaque.add(!hasGlass || random.nextInt(3) > 0);
        }

        Bodies bodies() {
            boolean[] each = new boolean[opaque.size()];
            for (int i = 0; i < each.length; i++) {
                each[i] = opaque.get(i);
            }
            return Bodies.of(surfaces.toArray(Surface[]::new), each, () -> false);
        }

        private Vec3 vec(double x) {
            return new Vec3(x * random.nextDouble(), x * random.nextDouble(), x * random.nextDouble());
        }

        Vec3 inside() {
            return new Vec3(between(low.x(), high.x()), between(low.y(), high.y()), between(low.z(), high.z()));
        }

        /** Often at one of both, or a little beside. */
        private double between(double from, double to) {
            double little = random.nextInt(3) == 0 ? 0 : (random.nextInt(3) - 1) * Math.pow(10, -random.nextInt(17)) * scale;
            return switch (random.nextInt(6)) {
                case 0 -> from + little;
                case 1 -> to + little;
                case 2 -> from + (3 * random.nextDouble() - 1) * (to - from);
                default -> from + random.nextDouble() * (to - from);
            };
        }

        private double along() {
            return switch (random.nextInt(8)) {
                case 0 -> random.nextBoolean() ? 0 : -0.0;
                case 1 -> (random.nextInt(3) - 1) * Math.pow(10, -random.nextInt(18));
                default -> random.nextGaussian();
            };
        }

        /** From anywhere, often from a surface, often to a corner, an edge or along a wall. */
        void start(Ray ray, Ray same) {
            Vec3 from = inside();
            Vec3 to = inside();
            Vec3 way = random.nextInt(3) == 0 ? to.minus(from) : new Vec3(along(), along(), along());
            Vec3 d = way.length() > 0 ? way.times(1 / way.length()) : Vec3.Z;
            ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
            if (random.nextInt(3) > 0) {
                for (int bounces = 1 + random.nextInt(2); bounces > 0; bounces--) {
                    meetAll(ray);
                    if (ray.part >= 0) {
                        Vec3 out = new Vec3(along(), along(), along());
                        Vec3 then = random.nextInt(5) == 0 ? inside().minus(new Vec3(ray.ox + ray.max * ray.dx, ray.oy + ray.max * ray.dy, ray.oz + ray.max * ray.dz)) : out;
                        Vec3 on = then.length() > 0 ? then.times(1 / then.length()) : Vec3.Z;
                        double x = ray.ox + ray.max * ray.dx;
                        double y = ray.oy + ray.max * ray.dy;
                        double z = ray.oz + ray.max * ray.dz;
                        double end = random.nextInt(4) == 0 && then.length() > 0 ? then.length() * (1 - 1e-9 * random.nextInt(2)) : random.nextInt(4) == 0 ? scale * random.nextDouble() : Double.POSITIVE_INFINITY;
                        ray.start(x, y, z, on.x(), on.y(), on.z(), ray.max + Math.abs(x) + Math.abs(y) + Math.abs(z), end, ray.part, false);
                    }
                }
            }
            ray.min = random.nextInt(6) == 0 ? ray.contact : ray.min;
            same.within(ray, ray.min, ray.max);
        }

        void meetAll(Ray ray) {
            surfaces.forEach(surface -> surface.nearest(ray));
        }

        /** Whether what was met is of a few that lie in one place each with the next, but not all with each other: which of them counts depends on the order. */
        boolean isChain(Ray met) {
            Ray alone = new Ray(new Spans());
            double[] places = surfaces.stream().mapToDouble(surface -> {
                alone.within(met, met.min, Double.POSITIVE_INFINITY);
                surface.nearest(alone);
                return alone.max;
            }).sorted().toArray();
            int last = 0;
            while (last + 1 < places.length && places[last + 1] - places[last] <= met.touch(places[last])) {
                last++;
            }
            return places[last] - places[0] > met.touch(places[0]) && met.max <= places[last];
        }

        /** Whether one that is opaque is met. If not, the boundaries of the others are pushed. */
        boolean stops(Ray ray, Spans through) {
            for (int i = 0; i < surfaces.size(); i++) {
                if (opaque.get(i) && surfaces.get(i).occludes(ray)) {
                    return true;
                }
            }
            for (int i = 0; i < surfaces.size(); i++) {
                if (!opaque.get(i)) {
                    surfaces.get(i).crossings(ray, through);
                }
            }
            return false;
        }

        /** Makes a bundle of a ray and some beside it. */
        void surround(Ray ray, Bundle bundle) {
            double width = Math.pow(10, -5 * random.nextDouble());
            bundle.start(ray.ox, ray.oy, ray.oz);
            bundle.add(ray.dx, ray.dy, ray.dz);
            for (int more = random.nextInt(3); more > 0; more--) {
                bundle.add(ray.dx + width * random.nextGaussian(), ray.dy + width * random.nextGaussian(), ray.dz + width * random.nextGaussian());
            }
        }
    }

    @Test
    void whatIsMetIsTheSameAsOfAll() {
        int hulls = 0;
        for (int seed = 0; seed < ROOMS; seed++) {
            Room room = new Room(seed);
            Bodies bodies = room.bodies();
            hulls += bodies.haveHull() ? 1 : 0;
            assertSame(room, bodies, seed);
        }
        assertThat(hulls).isGreaterThan(ROOMS / 4);
    }

    @Test
    void soItIsAfterWallsHaveBeenExchanged() {
        for (int seed = 0; seed < ROOMS; seed++) {
            Room room = new Room(seed);
            Bodies bodies = room.bodies();
            int which = room.random.nextInt(room.surfaces.size());
            Numbers parts = new Numbers(10_000);
            room.place(new Sphere(0.3 * room.scale), Affine.translation(room.inside()), parts);
            Surface fresh = room.surfaces.remove(room.surfaces.size() - 1);
            room.surfaces.set(which, fresh);
            boolean isOpaque = room.opaque.remove(room.opaque.size() - 1);
            room.opaque.set(which, isOpaque);
            assertSame(room, bodies.with(new int[] {which}, new Surface[] {fresh}, new boolean[] {isOpaque}, () -> false), seed);
        }
    }

    private static void assertSame(Room room, Bodies bodies, int seed) {
        Spans spans = new Spans();
        Bodies.Finder finder = bodies.newFinder();
        Bodies.Finder gatherer = bodies.newGatherer(spans);
        Ray ray = new Ray(new Spans());
        Ray same = new Ray(new Spans());
        Bundle bundle = new Bundle();
        Entries entered = new Entries(24);
        for (int i = 0; i < 200; i++) {
            room.start(ray, same);
            Supplier<String> what = () -> "room " + seed + ", from " + same.ox + " " + same.oy + " " + same.oz + " along " + same.dx + " " + same.dy + " " + same.dz;
            Entries among = bodies.whole();
            if (ray.min >= 0 && room.random.nextBoolean()) {
                room.surround(ray, bundle);
                bodies.enter(bundle, entered);
                among = entered;
            }
            boolean isStopped = bodies.occluder(same, among, finder, spans) != null;
            List<String> passed = told(spans);
            assertThat(isStopped).as(what).isEqualTo(room.stops(ray, spans));
            List<String> toPass = told(spans);
            assertThat(isStopped ? toPass : passed).as(what).isEqualTo(toPass);
            assertThat(bodies.isClear(among) && (isStopped || !passed.isEmpty())).as(what).isFalse();
            bodies.crossings(same, gatherer);
            List<String> met = told(spans);
            room.surfaces.forEach(surface -> surface.crossings(ray, spans));
            assertThat(met).as(what).isEqualTo(told(spans));
            ray.within(ray, ray.min, Double.POSITIVE_INFINITY);
            same.within(ray, ray.min, Double.POSITIVE_INFINITY);
            room.meetAll(ray);
            bodies.nearest(same, among, finder);
            if (same.part != ray.part && room.isChain(ray) && room.isChain(same)) {
                continue;
            }
            assertThat(same.part).as(what).isEqualTo(ray.part);
            assertThat(same.max).as(what).isEqualTo(ray.max);
        }
    }

    private static List<String> told(Spans spans) {
        if (spans.size() == 0) {
            return List.of();
        }
        List<String> all = new ArrayList<>();
        for (int i = 0; i < spans.size(); i++) {
            all.add(spans.part(i) + " " + spans.t(i) + " " + spans.face(i));
        }
        spans.release(0);
        all.sort(null);
        return all;
    }
}
