package cz.paprsek.render;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Part;
import cz.paprsek.shape.Parts;
import cz.paprsek.shape.Ray;
import cz.paprsek.shape.Spans;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;

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
        new Eye(scene.scene().camera(), settings.width(), settings.height()).start(ray, x, y);
        scene.bvh().nearest(ray, scene.bvh().whole(), scene.bvh().newStack());
        if (ray.part < 0) {
            return Optional.empty();
        }
        int object = scene.parts().object(ray.part);
        int first = ray.part;
        while (first > 0 && scene.parts().object(first - 1) == object) {
            first--;
        }
        Vec3 point = new Vec3(ray.ox + ray.max * ray.dx, ray.oy + ray.max * ray.dy, ray.oz + ray.max * ray.dz);
        return Optional.of(new Pick(object, operands(scene.scene().objects().get(object), ray.part - first), point, ray.max));
    }

    /** Which operands a part of an object is of: found by placing the object once more, so that renders need not keep it. */
    private static List<Integer> operands(SceneObject object, int part) {
        List<List<Integer>> paths = new ArrayList<>();
        object.shape().place(object.placement().toParent(), new Paths(List.of(), paths));
        return paths.get(part);
    }

    /** Notes the path of every part. */
    private static final class Paths implements Parts {
        private final List<Integer> path;
        private final List<List<Integer>> found;
        private int operands;

        Paths(List<Integer> path, List<List<Integer>> found) {
            this.path = path;
            this.found = found;
        }

        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            found.add(path);
            return maker.apply(found.size() - 1);
        }

        @Override
        public Parts within(Operand operand, Affine toWorld) {
            List<Integer> longer = new ArrayList<>(path);
            longer.add(operands++);
            return new Paths(List.copyOf(longer), found);
        }
    }
}
