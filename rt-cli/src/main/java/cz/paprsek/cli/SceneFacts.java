package cz.paprsek.cli;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Numbers;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** The facts that {@code info} tells of a scene, in the order it tells them. */
final class SceneFacts {
    private SceneFacts() {}

    static Map<String, Object> of(Path file, Scene scene) {
        Map<String, Object> facts = new LinkedHashMap<>();
        facts.put("file", file);
        facts.put("name", scene.name());
        facts.put("description", scene.description());
        facts.put("tags", String.join(" ", scene.tags()));
        facts.put("objects", scene.objects().size());
        Map<String, Object> kinds = new TreeMap<>();
        scene.objects().forEach(object -> count(object.shape(), kinds));
        facts.put("kinds", kinds);
        facts.put("bounds", bounds(scene));
        facts.put("lights", scene.lights().size());
        facts.put("materials", scene.materials().size());
        Camera camera = scene.camera();
        facts.put("camera", "at " + Numbers.text(camera.position()) + " looking " + rounded(camera.forward()) + ", fovy " + Numbers.text(camera.fovy()));
        facts.put("picture", scene.settings().width() + "x" + scene.settings().height() + ", max-depth " + scene.settings().maxDepth()
                + ", samples " + scene.settings().samples());
        return facts;
    }

    /** A fact as text. */
    static String text(Object value) {
        return value instanceof Map<?, ?> map
                ? map.entrySet().stream().map(e -> e.getValue() + " " + e.getKey()).collect(Collectors.joining(", "))
                : value.toString();
    }

    private static void count(Shape shape, Map<String, Object> kinds) {
        String kind = (shape instanceof Csg csg ? csg.operation().name() : shape.getClass().getSimpleName()).toLowerCase(Locale.ROOT);
        kinds.merge(kind, 1, (a, b) -> (Integer) a + (Integer) b);
        if (shape instanceof Csg csg) {
            csg.operands().stream().map(Operand::solid).forEach(solid -> count(solid, kinds));
        }
    }

    private static String bounds(Scene scene) {
        Bounds all = Bounds.EMPTY;
        for (SceneObject object : scene.objects()) {
            all = all.union(object.shape().bounds().transformed(object.placement().toParent()));
        }
        return all.isEmpty() ? "empty" : !all.isFinite() ? "unbounded"
                : rounded(new Vec3(all.minX(), all.minY(), all.minZ())) + " to " + rounded(new Vec3(all.maxX(), all.maxY(), all.maxZ()));
    }

    private static String rounded(Vec3 v) {
        return String.format(Locale.ROOT, "%.4g %.4g %.4g", v.x(), v.y(), v.z());
    }
}
