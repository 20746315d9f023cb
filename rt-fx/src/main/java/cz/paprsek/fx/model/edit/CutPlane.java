package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Solid;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

/**
 * A plane across an axis of the world that all solids with an end are cut by, to look into them. What lies farther along the axis is not seen; the scene stays as it is.
 *
 * @param share where it is, from 0 at the least end of what it cuts to 1 at the other
 */
public record CutPlane(Axis axis, double share) {
    public CutPlane {
        share = Math.max(0, Math.min(1, share));
    }

    /** The box around an object that is cut; empty if it is not. */
    private static Bounds box(Scene scene, int i) {
        SceneObject object = scene.objects().get(i);
        Bounds box = object.shape() instanceof Solid && !object.hidden() ? ScenePath.body(i).placed(scene).bounds() : Bounds.EMPTY;
        return box.isFinite() ? box : Bounds.EMPTY;
    }

    private static Bounds all(Scene scene) {
        return IntStream.range(0, scene.objects().size()).mapToObj(i -> box(scene, i)).reduce(Bounds.EMPTY, Bounds::union);
    }

    /** The same, elsewhere along its axis, but not outside of what it cuts. */
    public CutPlane at(Scene scene, double place) {
        Bounds all = all(scene);
        return all.isEmpty() ? this : new CutPlane(axis, (place - axis.least(all)) / Math.max(Double.MIN_NORMAL, axis.most(all) - axis.least(all)));
    }

    /** Where it is along its axis; empty if there is nothing that is cut. */
    public OptionalDouble place(Scene scene) {
        Bounds all = all(scene);
        return all.isEmpty() ? OptionalDouble.empty() : OptionalDouble.of(axis.least(all) + share * (axis.most(all) - axis.least(all)));
    }

    /** What is seen of a scene. */
    public Visible of(Visible whole) {
        Scene scene = whole.scene();
        List<Bounds> boxes = IntStream.range(0, scene.objects().size()).mapToObj(i -> box(scene, i)).toList();
        Bounds all = boxes.stream().reduce(Bounds.EMPTY, Bounds::union);
        if (all.isEmpty()) {
            return whole;
        }
        double place = place(scene).orElseThrow();
        Bounds air = all.grown(1 + all.magnitude());
        Vec3 least = new Vec3(air.minX(), air.minY(), air.minZ());
        Vec3 from = least.plus(axis.times(place - axis.of(least)));
        Block away = new Block(from, new Vec3(air.maxX(), air.maxY(), air.maxZ()));
        List<SceneObject> objects = new ArrayList<>();
        Map<ScenePath, ScenePath> places = new HashMap<>(whole.places());
        for (int i = 0; i < scene.objects().size(); i++) {
            SceneObject object = scene.objects().get(i);
            if (boxes.get(i).isEmpty()) {
                objects.add(object);
                continue;
            }
            Operand own = Body.of(object).toOperand();
            objects.add(new SceneObject(object.name(), Csg.difference(own.named(""), Operand.of(away).madeOf(object.material())), Placement.NONE, object.material()));
            ScenePath.body(i).withOperands(scene).forEach(at -> places.put(inside(at), whole.original(at)));
            places.put(ScenePath.body(i), whole.original(ScenePath.body(i)));
            places.put(ScenePath.body(i).child(1), whole.original(ScenePath.body(i)));
        }
        return new Visible(scene.withAnimations(List.of()).withObjects(objects), places);
    }

    private static BodyAt inside(BodyAt at) {
        BodyAt result = ScenePath.body(at.numbers().get(0)).child(0);
        for (int number : at.numbers().subList(1, at.numbers().size())) {
            result = result.child(number);
        }
        return result;
    }
}
