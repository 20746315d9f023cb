package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * A scene without what is hidden in the editor. Where the first operand of a difference is hidden, what it is made without is seen as bodies.
 *
 * @param scene what is to be seen, by the camera looked through, which comes first; the very scene if that is its first and nothing is hidden
 * @param places where in the scene itself stands what is at a place here; what is not in it stands at the same place
 */
public record Visible(Scene scene, Map<ScenePath, ScenePath> places) {

    public static Visible of(EditorState state) {
        return of(state, Set.of());
    }

    /** @param away what is not there either; of a difference without its first, from which the others are taken, nothing is left then */
    public static Visible of(EditorState state, Set<ScenePath> away) {
        Scene whole = state.seen();
        if (state.hidden().isEmpty() && away.isEmpty()) {
            return new Visible(whole, Map.of());
        }
        Map<ScenePath, ScenePath> places = new HashMap<>();
        List<SceneObject> objects = new ArrayList<>();
        for (int i = 0; i < whole.objects().size(); i++) {
            SceneObject object = whole.objects().get(i);
            Body body = Body.of(object);
            visible(state, away, body, ScenePath.body(i), ScenePath.body(objects.size()), places)
                    .ifPresent(left -> objects.add(left.equals(body) ? object : left.toObject()));
        }
        List<Light> lights = new ArrayList<>();
        for (int i = 0; i < whole.lights().size(); i++) {
            if (!state.hidden().contains(ScenePath.light(i)) && !away.contains(ScenePath.light(i))) {
                places.put(ScenePath.light(lights.size()), ScenePath.light(i));
                lights.add(whole.lights().get(i));
            }
        }
        // Nothing moves in what is looked at; what is hidden might be what an animation is of.
        return new Visible(whole.withAnimations(List.of()).withObjects(objects).withLights(lights), places);
    }

    /** Where in the scene itself stands what is seen here. */
    public ScenePath original(ScenePath seen) {
        return places.getOrDefault(seen, seen);
    }

    private static Optional<Body> visible(EditorState state, Set<ScenePath> away, Body body, BodyAt at, BodyAt seenAt, Map<ScenePath, ScenePath> places) {
        if (state.hidden().contains(at) || away.contains(at)) {
            return Optional.empty();
        }
        places.put(seenAt, at);
        if (!(body.shape() instanceof Csg csg)) {
            return Optional.of(body);
        }
        Csg.Operation operation = csg.operation();
        List<Operand> operands = new ArrayList<>();
        for (int i = 0; i < csg.operands().size(); i++) {
            Operand operand = csg.operands().get(i);
            Body old = Body.of(operand);
            Optional<Body> left = visible(state, away, old, at.child(i), seenAt.child(operands.size()), places);
            if (left.isEmpty() && i == 0 && operation == Csg.Operation.DIFFERENCE) {
                if (!state.hidden().contains(at.child(i)) || away.contains(at.child(i))) {
                    return Optional.empty();
                }
                operation = Csg.Operation.UNION;
            }
            left.ifPresent(fresh -> operands.add(fresh.equals(old) ? operand : fresh.toOperand()));
        }
        return operands.isEmpty() ? Optional.empty()
                : Optional.of(operands.equals(csg.operands()) ? body : body.withShape(new Csg(operation, operands)));
    }
}
