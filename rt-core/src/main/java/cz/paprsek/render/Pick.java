package cz.paprsek.render;

import cz.paprsek.math.Vec3;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.integrate.PartPaths;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import java.util.Objects;
import java.util.Optional;

/**
 * What is seen at a point of the picture.
 *
 * @param body the object, or within an operation the primitive, whose surface is seen
 * @param point where the surface is, world space
 * @param distance from the eye, scene units
 */
public record Pick(BodyAt body, Vec3 point, double distance) {
    public Pick {
        Objects.requireNonNull(body, "body");
        Objects.requireNonNull(point, "point");
    }

    /**
     * Looks along the ray through a point of the picture.
     *
     * @param settings the picture's size
     * @param x columns from the left edge; the centre of the first pixel is 0.5
     * @param y rows from the top edge
     * @return empty if nothing is hit
     */
    public static Optional<Pick> at(RenderScene scene, RenderSettings settings, double x, double y) {
        Ray ray = new Ray(new Spans());
        if (!Eye.of(scene.scene().camera(), settings.width(), settings.height()).start(ray, x, y)) {
            return Optional.empty();
        }
        scene.world().bodies().nearest(ray, scene.world().bodies().whole(), scene.world().bodies().newFinder());
        if (ray.part < 0) {
            return Optional.empty();
        }
        int object = scene.world().parts().object(ray.part);
        BodyAt body = PartPaths.of(scene.scene(), object).get(ray.part - scene.world().parts().firstOfObject(ray.part));
        Vec3 point = new Vec3(ray.ox + ray.max * ray.dx, ray.oy + ray.max * ray.dy, ray.oz + ray.max * ray.dz);
        return Optional.of(new Pick(body, point, ray.max));
    }
}
