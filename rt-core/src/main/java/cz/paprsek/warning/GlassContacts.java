package cz.paprsek.warning;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Volume;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;

/**
 * Where transparent bodies of different refractive indices touch, or reach into each other with a part only: found by trying, with rays
 * through the places where their boxes meet. One that lies wholly within another is none.
 */
final class GlassContacts {
    /** How many rays are tried for all pairs together, and how many at least for each; pairs that get none are not looked at. */
    static final int RAYS = 10_000;
    private static final int LEAST = 20;
    /** Of bodies without end, only what lies so near to the camera is looked at, scene units. */
    private static final double NEAR = 100;

    /** A body that light gets through. */
    record Body(BodyAt place, String label, Volume volume, double index) {}

    /** @param point the first place found, world space */
    record Contact(Body first, Body second, boolean overlap, Vec3 point) {}

    private record Pair(Body first, Body second, Bounds common) {}

    private final Random random = new Random(1);
    private final Spans spans = new Spans();
    private final Ray ray = new Ray(spans);

    private GlassContacts() {}

    static List<Contact> among(List<Body> bodies, Vec3 camera) {
        List<Pair> pairs = pairs(bodies, Bounds.around(camera, Vec3.ONE.times(NEAR)));
        GlassContacts search = new GlassContacts();
        return pairs.stream().flatMap(pair -> search.contact(pair, RAYS / pairs.size()).stream()).toList();
    }

    private static List<Pair> pairs(List<Body> bodies, Bounds near) {
        List<Body> sorted = bodies.stream().sorted(Comparator.comparingDouble(body -> body.volume().bounds().minX())).toList();
        List<Pair> pairs = new ArrayList<>();
        for (int i = 0; i < sorted.size(); i++) {
            Bounds box = sorted.get(i).volume().bounds().padded();
            for (int j = i + 1; j < sorted.size() && pairs.size() < RAYS / LEAST; j++) {
                Bounds other = sorted.get(j).volume().bounds().padded();
                if (other.minX() > box.maxX()) {
                    break;
                }
                Bounds common = box.intersection(other);
                Bounds seen = common.isFinite() ? common : common.intersection(near);
                if (!seen.isEmpty() && sorted.get(i).index() != sorted.get(j).index()) {
                    pairs.add(new Pair(sorted.get(i), sorted.get(j), seen));
                }
            }
        }
        return pairs;
    }

    private List<Contact> contact(Pair pair, int rays) {
        Vec3 touching = null;
        Vec3 overlapping = null;
        boolean firstAlone = false;
        boolean secondAlone = false;
        for (int i = 0; i < rays; i++) {
            aim(pair.common());
            spans.release(0);
            pair.first().volume().spans(ray, spans);
            int end = spans.size();
            pair.second().volume().spans(ray, spans);
            for (int a = 0; a < end; a += 2) {
                for (int b = end; b < spans.size(); b += 2) {
                    double from = Math.max(spans.t(a), spans.t(b));
                    double to = Math.min(spans.t(a + 1), spans.t(b + 1));
                    double touch = ray.touch(from);
                    if (to - from > touch) {
                        overlapping = overlapping == null ? at((from + to) / 2) : overlapping;
                        firstAlone |= spans.t(a) < from - touch || spans.t(a + 1) > to + touch;
                        secondAlone |= spans.t(b) < from - touch || spans.t(b + 1) > to + touch;
                    } else if (to - from >= -touch) {
                        touching = touching == null ? at(from) : touching;
                    }
                }
            }
        }
        if (overlapping != null && firstAlone && secondAlone) {
            return List.of(new Contact(pair.first(), pair.second(), true, overlapping));
        }
        return touching == null || overlapping != null ? List.of() : List.of(new Contact(pair.first(), pair.second(), false, touching));
    }

    private void aim(Bounds box) {
        Vec3 target = new Vec3(between(box.minX(), box.maxX()), between(box.minY(), box.maxY()), between(box.minZ(), box.maxZ()));
        Vec3 direction = new Vec3(between(-1, 1), between(-1, 1), between(-1, 1));
        Vec3 d = (direction.length() > 0 ? direction : Vec3.X).normalized();
        Vec3 size = new Vec3(box.maxX() - box.minX(), box.maxY() - box.minY(), box.maxZ() - box.minZ());
        Vec3 from = target.minus(d.times(2 * size.length()));
        ray.start(from.x(), from.y(), from.z(), d.x(), d.y(), d.z());
    }

    private double between(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    private Vec3 at(double t) {
        return new Vec3(ray.ox + t * ray.dx, ray.oy + t * ray.dy, ray.oz + t * ray.dz);
    }
}
