package cz.paprsek.cli.describe;

import cz.paprsek.math.Bounds;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.placed.Parts;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * What is in a scene, counted.
 *
 * @param kinds for each kind of shape in use, how many there are
 * @param meshes the different ones, with their triangles
 * @param bounds around all objects that have bounds, world space; empty if there is none
 * @param unbounded how many objects have none
 */
public record SceneSummary(Scene scene, Map<String, Count> kinds, List<Mesh> meshes, Bounds bounds, int unbounded) {

    /** How many shapes of a kind are objects, and how many are operands of others. */
    record Count(int objects, int operands) {
        static final Count NONE = new Count(0, 0);

        Count plus(boolean operand) {
            return operand ? new Count(objects, operands + 1) : new Count(objects + 1, operands);
        }
    }

    public static SceneSummary of(Scene scene) {
        Map<String, Count> kinds = new TreeMap<>();
        Set<Mesh> meshes = new LinkedHashSet<>();
        for (BodyAt part : ScenePath.bodies(scene).toList()) {
            String kind = part.in(scene).shape().kind();
            if (part.in(scene).shape() instanceof Mesh mesh && mesh.isRead()) {
                meshes.add(mesh);
            }
            kinds.put(kind, kinds.getOrDefault(kind, Count.NONE).plus(part.depth() > 0));
        }
        Bounds bounds = Bounds.EMPTY;
        int unbounded = 0;
        for (SceneObject object : scene.objects()) {
            Bounds own = object.shape().place(object.placement().toParent(), Parts.UNTOLD).bounds();
            unbounded += own.isFinite() ? 0 : 1;
            bounds = own.isFinite() ? bounds.union(own) : bounds;
        }
        return new SceneSummary(scene, kinds, List.copyOf(meshes), bounds, unbounded);
    }

    int operands() {
        return kinds.values().stream().mapToInt(Count::operands).sum();
    }
}
