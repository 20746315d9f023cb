package cz.paprsek.render;

import cz.paprsek.math.Vec3;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.integrate.PartNames;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.shape.Ray;
import cz.paprsek.shape.Spans;
import java.util.List;
import java.util.Optional;

/**
 * What is seen at a point of the picture.
 *
 * @param object number of the object in the scene's list
 * @param operands numbers that lead from the object through nested CSG operations to the primitive whose surface is seen; empty if the object
 *         is no CSG
 * @param point where the surface is, world space
 * @param distance from the eye, scene units
 */
public record Pick(int object, List<Integer> operands, Vec3 point, double distance) {
    public Pick {
        operands = List.copyOf(operands);
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
        Eye.of(scene.scene().camera(), settings.width(), settings.height()).start(ray, x, y);
        scene.world().bodies().nearest(ray, scene.world().bodies().whole(), scene.world().bodies().newFinder());
        if (ray.part < 0) {
            return Optional.empty();
        }
        int object = scene.world().parts().object(ray.part);
        List<Integer> path = new PartNames(object, scene.scene().objects().get(object)).names()
                .get(ray.part - scene.world().parts().firstOfObject(ray.part)).path().numbers();
        Vec3 point = new Vec3(ray.ox + ray.max * ray.dx, ray.oy + ray.max * ray.dy, ray.oz + ray.max * ray.dz);
        return Optional.of(new Pick(object, path.subList(1, path.size()), point, ray.max));
    }
}
