package cz.paprsek.render;

import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.LightTerm.Obstacle;
import cz.paprsek.render.explain.SurfacePath;
import cz.paprsek.shape.Ray;
import cz.paprsek.shape.Spans;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.IntFunction;

/** Finds what stands between a point and a light, in order. */
final class ShadowWalk {
    private final PartTable parts;
    private final Bodies bodies;
    private final Bodies.Finder finder;
    private final Spans spans = new Spans();
    private final Ray ray = new Ray(spans);
    private final IntFunction<SurfacePath> path;

    ShadowWalk(RenderScene scene, IntFunction<SurfacePath> path) {
        this.parts = scene.parts();
        this.bodies = scene.bodies();
        this.finder = bodies.newFinder();
        this.path = path;
    }

    /** The surfaces in the way, the nearest first, up to the first that lets no light through. */
    List<Obstacle> obstacles(Vec3 point, Vec3 direction, double distance, double size) {
        double end = distance - Ray.OFFSET * size;
        ray.start(point.x(), point.y(), point.z(), direction.x(), direction.y(), direction.z(), size, end);
        spans.release(0);
        return bodies.occluder(ray, bodies.whole(), finder, spans) == null ? transparent() : untilOpaque(end);
    }

    private List<Obstacle> transparent() {
        List<Obstacle> found = new ArrayList<>();
        for (int i = 0; i < spans.size(); i++) {
            found.add(obstacle(spans.part(i), spans.t(i)));
        }
        found.sort(Comparator.comparingDouble(Obstacle::distance));
        return found;
    }

    private List<Obstacle> untilOpaque(double end) {
        List<Obstacle> found = new ArrayList<>();
        boolean isOpaque = false;
        spans.release(0);
        while (!isOpaque) {
            ray.part = -1;
            ray.max = end;
            bodies.nearest(ray, bodies.whole(), finder);
            if (ray.part < 0) {
                break;
            }
            found.add(obstacle(ray.part, ray.max));
            isOpaque = parts.finish(ray.part).transparency == 0;
            ray.min = ray.max;
        }
        return found;
    }

    private Obstacle obstacle(int part, double distance) {
        return new Obstacle(path.apply(part), distance, parts.finish(part).transparency);
    }
}
