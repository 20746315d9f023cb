package cz.paprsek.drawing;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.text.Outline;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;

/**
 * What a drawing of a tree shows of the world: a cube around all points that the rays hit, and the objects they hit.
 *
 * @param objects their numbers in the scene
 * @param middle of the cube, world space
 * @param size length of its edges, above 0
 */
public record DrawingFrame(Scene scene, Set<Integer> objects, Vec3 middle, double size) {
    private static final int STEPS = 96;
    private static final double MARGIN = 1.25;

    public DrawingFrame {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(middle, "middle");
        objects = Set.copyOf(objects);
    }

    /** The frame of a tree that has been cut to what is to be drawn. */
    public static DrawingFrame of(Scene scene, Outline outline) {
        Set<Integer> objects = new TreeSet<>();
        Bounds box = collect(outline, objects);
        if (outline.ray().encounter().isPresent()) {
            BodyAt first = outline.ray().encounter().get().place().surface().part().object();
            Bounds around = first.in(scene).shape().bounds().transformed(first.toWorld(scene));
            box = around.isFinite() ? box.union(around) : box;
        }
        if (box.isEmpty()) {
            return new DrawingFrame(scene, objects, outline.ray().origin(), 1);
        }
        Vec3 middle = new Vec3((box.minX() + box.maxX()) / 2, (box.minY() + box.maxY()) / 2, (box.minZ() + box.maxZ()) / 2);
        double size = Math.max(box.maxX() - box.minX(), Math.max(box.maxY() - box.minY(), box.maxZ() - box.minZ()));
        double distance = outline.ray().encounter().orElseThrow().place().distance();
        return new DrawingFrame(scene, objects, middle, MARGIN * (size > 0 ? size : distance / 2));
    }

    /** All points that a ray and those it gives rise to hit, and the numbers of the objects. */
    private static Bounds collect(Outline outline, Set<Integer> objects) {
        Bounds box = Bounds.EMPTY;
        if (outline.ray().encounter().isPresent()) {
            Encounter.Place place = outline.ray().encounter().get().place();
            objects.add(place.surface().part().object().index());
            box = Bounds.of(place.point(), place.point());
        }
        for (Outline child : outline.children()) {
            box = box.union(collect(child, objects));
        }
        return box;
    }

    /** The lines that draw the objects, world space. */
    public List<List<Vec3>> outlines(Projection projection) {
        Objects.requireNonNull(projection, "projection");
        List<List<Vec3>> curves = new ArrayList<>();
        for (int number : objects) {
            SceneObject object = scene.objects().get(number);
            add(object.shape(), object.placement().toParent(), projection, curves);
        }
        return curves;
    }

    private static void add(Shape shape, Affine toWorld, Projection projection, List<List<Vec3>> curves) {
        Affine toLocal = toWorld.inverse();
        Vec3 along = projection.along();
        Vec3 local = new Vec3(toLocal.directionX(along.x(), along.y(), along.z()), toLocal.directionY(along.x(), along.y(), along.z()),
                toLocal.directionZ(along.x(), along.y(), along.z()));
        shape.outline(local, STEPS).forEach(curve -> curves.add(curve.points().stream().map(toWorld::point).toList()));
        if (shape instanceof Csg csg) {
            for (Operand operand : csg.operands()) {
                add(operand.solid(), toWorld.after(operand.placement().toParent()), projection, curves);
            }
        }
    }
}
