package cz.paprsek.scene;

import cz.paprsek.material.Inherited;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.Pattern;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** What must hold between the parts of a scene, beyond what each part checks by itself. */
public final class SceneRules {
    private SceneRules() {}

    /** Is told of every rule that is broken. */
    @FunctionalInterface
    public interface Report {
        /**
         * @param culprit the light, object or operand at fault: the very instance that was passed in
         * @param sentence what is wrong and what to do
         */
        void broken(Object culprit, String sentence);
    }

    /** Checks names, references to materials and patterns of a scene's parts, in the order of the lists. */
    public static void check(
            List<Light> lights, Map<String, Material> materials, List<SceneObject> objects, Report report) {
        Set<String> names = new HashSet<>();
        for (Light light : lights) {
            checkName("light", light.name(), light, names, report);
        }
        names.clear();
        for (SceneObject object : objects) {
            checkName("object", object.name(), object, names, report);
            checkMaterial(object.material(), object.shape(), object, materials, report);
        }
    }

    private static void checkOperands(Csg csg, Map<String, Material> materials, Report report) {
        Set<String> names = new HashSet<>();
        for (Operand operand : csg.operands()) {
            checkName("operand", operand.name(), operand, names, report);
            checkMaterial(operand.material(), operand.solid(), operand, materials, report);
        }
    }

    private static void checkName(String kind, String name, Object owner, Set<String> seen, Report report) {
        if (!name.isEmpty() && !seen.add(name)) {
            report.broken(owner, "there is already " + (kind.startsWith("o") ? "an " : "a ") + kind + " named \"" + name
                    + "\" here; give one of them another name");
        }
    }

    private static void checkMaterial(
            MaterialSource source, Shape shape, Object owner, Map<String, Material> materials, Report report) {
        if (source instanceof MaterialName reference && !materials.containsKey(reference.name())) {
            report.broken(owner, "there is no material named \"" + reference.name() + "\""
                    + Similar.suggestion(reference.name(), materials.keySet()));
        }
        Material material = source instanceof MaterialName reference
                ? materials.getOrDefault(reference.name(), Material.DEFAULT)
                : source == Inherited.INHERITED ? Material.DEFAULT : (Material) source;
        if (material.pattern() instanceof Pattern.Checkerboard && !(shape instanceof Rectangle || shape instanceof Disc)) {
            report.broken(owner, "a checkerboard lies on a rectangle or a disc only; give this shape a checker");
        }
        if (shape instanceof Csg csg) {
            checkOperands(csg, materials, report);
        }
    }
}
