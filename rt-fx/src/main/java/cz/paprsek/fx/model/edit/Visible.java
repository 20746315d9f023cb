package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.item.Item.BodyAt;
import cz.paprsek.fx.model.item.Item.LightAt;
import cz.paprsek.fx.model.item.Item;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A scene without what is hidden in the editor. Of a difference without its first operand, from which the others are taken, nothing is left.
 *
 * @param scene what is to be seen, by the camera looked through, which comes first; the very scene if that is its first and nothing is hidden
 * @param places where in the scene itself stands what is at a place here; what is not in it stands at the same place
 * @param lights where in the scene itself stand the lights of this one; empty if all are where they were
 */
public record Visible(Scene scene, Map<BodyAt, BodyAt> places, List<LightAt> lights) {

    public static Visible of(EditorState state) {
        Scene whole = state.seen();
        if (state.hidden().isEmpty()) {
            return new Visible(whole, Map.of(), List.of());
        }
        Map<BodyAt, BodyAt> places = new HashMap<>();
        List<SceneObject> objects = new ArrayList<>();
        for (int i = 0; i < whole.objects().size(); i++) {
            SceneObject object = whole.objects().get(i);
            Body body = Body.of(object);
            visible(state, body, Item.body(i), Item.body(objects.size()), places)
                    .ifPresent(left -> objects.add(left.equals(body) ? object : left.toObject()));
        }
        List<LightAt> lights = IntStream.range(0, whole.lights().size()).mapToObj(Item::light).filter(light -> !state.hidden().contains(light)).toList();
        return new Visible(whole.withObjects(objects).withLights(lights.stream().map(light -> whole.lights().get(light.index())).toList()), places, lights);
    }

    /** Where in the scene itself stands a light that is seen here. */
    public LightAt original(LightAt seen) {
        return seen.index() < lights.size() ? lights.get(seen.index()) : seen;
    }

    /** Where in the scene itself stands what is seen here. */
    public BodyAt original(BodyAt seen) {
        return places.getOrDefault(seen, seen);
    }

    private static Optional<Body> visible(EditorState state, Body body, BodyAt at, BodyAt seenAt, Map<BodyAt, BodyAt> places) {
        if (state.hidden().contains(at)) {
            return Optional.empty();
        }
        places.put(seenAt, at);
        if (!(body.shape() instanceof Csg csg)) {
            return Optional.of(body);
        }
        List<Operand> operands = new ArrayList<>();
        for (int i = 0; i < csg.operands().size(); i++) {
            Operand operand = csg.operands().get(i);
            Body old = Body.of(operand);
            Optional<Body> left = visible(state, old, at.child(i), seenAt.child(operands.size()), places);
            if (left.isEmpty() && i == 0 && csg.operation() == Csg.Operation.DIFFERENCE) {
                return Optional.empty();
            }
            left.ifPresent(fresh -> operands.add(fresh.equals(old) ? operand : fresh.toOperand()));
        }
        return operands.isEmpty() ? Optional.empty()
                : Optional.of(operands.equals(csg.operands()) ? body : body.withShape(new Csg(csg.operation(), operands)));
    }
}
