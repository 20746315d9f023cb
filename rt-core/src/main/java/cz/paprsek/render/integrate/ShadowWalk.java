package cz.paprsek.render.integrate;

import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.LightTerm.ShadowRay.Obstacle;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.TracedRay.Absorption;
import cz.paprsek.render.glow.Glows;
import cz.paprsek.render.surface.Bodies;
import cz.paprsek.render.surface.Contacts;
import cz.paprsek.render.surface.Media;
import cz.paprsek.render.surface.PartTable;
import cz.paprsek.render.surface.World;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/** Finds what stands between a point and a light, in order. */
public final class ShadowWalk {
    private final World scene;
    private final PartTable parts;
    private final Bodies bodies;
    private final Bodies.Finder gatherer;
    private final Contacts contacts;
    private final Spans spans = new Spans();
    private final Ray ray = new Ray(spans);
    private final Veils veils;
    private final IntFunction<InScene<BodyAt>> path;
    private final Dimming dimming;

    /**
     * Where a shadow ray starts.
     *
     * @param size what its rounding errors are relative to
     * @param part whose surface it is
     * @param inwards whether rays to the side it is seen from start into the inside of that part
     * @param around the media there
     * @param atOnce whether what touches the surface may stand in the way
     * @param beyond whether they start beyond the surface
     */
    public record Start(Vec3 point, double size, int part, boolean inwards, Media around, boolean atOnce, boolean beyond) {}

    public ShadowWalk(World scene, IntFunction<InScene<BodyAt>> path) {
        this.scene = scene;
        this.parts = scene.parts();
        this.bodies = scene.bodies();
        this.gatherer = bodies.newGatherer(spans);
        this.veils = new Veils(parts, spans);
        this.contacts = new Contacts(scene, bodies.newFinder(), spans);
        this.path = path;
        this.dimming = new Dimming(scene);
    }

    /** The surfaces in the way to a light, the nearest first, up to the first that lets no light through. */
    public List<Obstacle> obstacles(Start start, Vec3 direction, double distance, int lamp) {
        aim(start, direction, distance);
        int blocking = scene.glows().nearestOccluder(ray, lamp);
        double reach = blocking == Glows.NONE ? Double.POSITIVE_INFINITY : scene.glows().distance(ray, blocking);
        int[] inOrder = IntStream.range(0, spans.size())
                .filter(i -> isMet(start, i))
                .boxed().sorted(Comparator.<Integer>comparingDouble(spans::t).thenComparingInt(spans::part))
                .mapToInt(Integer::intValue).toArray();
        List<Obstacle> found = new ArrayList<>();
        for (int i : inOrder) {
            if (spans.t(i) > reach) {
                break;
            }
            found.add(new Obstacle(path.apply(spans.part(i)), Math.max(0, spans.t(i)), veils.transparency(ray, spans, i)));
            if (isOpaque(i)) {
                return found;
            }
        }
        if (blocking != Glows.NONE) {
            found.add(new Obstacle(new InScene<>(scene.scene(), ScenePath.light(blocking)), reach, 0));
        }
        return found;
    }

    private void aim(Start start, Vec3 direction, double distance) {
        Vec3 point = start.point();
        ray.start(point.x(), point.y(), point.z(), direction.x(), direction.y(), direction.z(), start.size(),
                distance - Ray.TOUCH * start.size(), start.part(), start.inwards());
        spans.release(0);
        bodies.crossings(ray, gatherer);
    }

    /** What substances take of light that comes all the way, the nearest first. */
    public List<Absorption> absorptions(Start start, Vec3 direction, double distance) {
        aim(start, direction, distance);
        List<Absorption> found = new ArrayList<>();
        dimming.along(spans, 0, i -> isMet(start, i), start.around(), distance, (object, length) -> found.add(alone(object, length)));
        return found;
    }

    /** What is left after a way through an object, worked out by itself. */
    private Absorption alone(int object, double length) {
        Dimming stretch = new Dimming(scene);
        stretch.go(object, length);
        stretch.finish();
        return absorption(object, length, new LinearRgb(stretch.red, stretch.green, stretch.blue));
    }

    /** What is left after a way through an object that takes something. */
    public Absorption absorption(int object, double length, LinearRgb left) {
        return new Absorption(new InScene<>(scene.scene(), ScenePath.body(scene.index(object))), Objects.requireNonNull(scene.absorption(object)).material, length, left);
    }

    private boolean isMet(Start start, int i) {
        return spans.t(i) > ray.contact || isMetAtOnce(start, i);
    }

    private boolean isMetAtOnce(Start start, int i) {
        return (start.atOnce() || start.beyond()) && !scene.isOpaque(parts.object(spans.part(i))) && contacts.counts(ray, start.around(), true, start.beyond(), i);
    }

    private boolean isOpaque(int i) {
        return veils.transparency(ray, spans, i) == 0;
    }
}
