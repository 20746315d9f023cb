package cz.paprsek.cli.describe;

import cz.paprsek.material.Inherited;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** The objects of a scene with their operands, at any depth, each with a name for people and what it is made of. */
final class SceneParts {
    private final Map<String, Material> materials;
    private final List<Part> parts = new ArrayList<>();

    /**
     * An object or an operand.
     *
     * @param label its kind, and its name or place
     * @param source where its material comes from
     * @param material what it is made of
     * @param isOperand whether it is part of another
     */
    record Part(String label, Shape shape, MaterialSource source, Material material, boolean isOperand) {}

    private SceneParts(Map<String, Material> materials) {
        this.materials = materials;
    }

    /** All parts of a scene, in the order of the file. */
    static List<Part> of(Scene scene) {
        SceneParts all = new SceneParts(scene.materials());
        for (int i = 0; i < scene.objects().size(); i++) {
            all.add(scene, i);
        }
        return all.parts;
    }

    /** An object, by its number in the scene, and its operands. */
    static List<Part> of(Scene scene, int object) {
        SceneParts one = new SceneParts(scene.materials());
        one.add(scene, object);
        return one.parts;
    }

    private void add(Scene scene, int number) {
        SceneObject object = scene.objects().get(number);
        add(label(object.shape(), object.name(), number), object.shape(), object.material(), Material.DEFAULT, false);
    }

    private void add(String label, Shape shape, MaterialSource source, Material inherited, boolean isOperand) {
        Material material = material(source, inherited);
        parts.add(new Part(label, shape, source, material, isOperand));
        if (shape instanceof Csg csg) {
            for (int i = 0; i < csg.operands().size(); i++) {
                Operand operand = csg.operands().get(i);
                add(label(operand.solid(), operand.name(), i) + " in " + label, operand.solid(), operand.material(), material, true);
            }
        }
    }

    private Material material(MaterialSource source, Material inherited) {
        if (source == Inherited.INHERITED) {
            return inherited;
        }
        return source instanceof MaterialName reference ? materials.getOrDefault(reference.name(), Material.DEFAULT) : (Material) source;
    }

    private static String label(Shape shape, String name, int number) {
        return shape.kind() + (name.isEmpty() ? " #" + (number + 1) : " \"" + name + "\"");
    }
}
