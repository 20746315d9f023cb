package cz.paprsek.cli;

import cz.paprsek.material.Inherited;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Numbers;
import cz.paprsek.render.RenderScene;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Csg.Operation;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;

/** What is allowed in a scene but hardly meant, a sentence each. */
final class SceneWarnings {
    private final Scene scene;
    private final List<String> warnings = new ArrayList<>();
    private final Set<String> used = new HashSet<>();

    private SceneWarnings(Scene scene) {
        this.scene = scene;
    }

    static List<String> of(Scene scene) {
        SceneWarnings found = new SceneWarnings(scene);
        scene.materials().forEach((name, material) -> found.checkEnergy("material \"" + name + "\"", material));
        for (int i = 0; i < scene.objects().size(); i++) {
            SceneObject object = scene.objects().get(i);
            found.visit(found.title(i), object.shape(), object.material());
        }
        scene.materials().keySet().stream().filter(name -> !found.used.contains(name))
                .forEach(name -> found.warnings.add("material \"" + name + "\" is not used by any object"));
        found.checkPlaces();
        if (scene.lights().isEmpty() && scene.ambient().equals(Rgb.BLACK)) {
            found.warnings.add("there is no light and no ambient light: everything but the background will be black");
        }
        return found.warnings;
    }

    private void visit(String title, Shape shape, MaterialSource material) {
        if (material instanceof MaterialName name) {
            used.add(name.name());
        } else if (material instanceof Material own) {
            checkEnergy(title, own);
        }
        if (shape instanceof Csg csg) {
            checkOperands(title, csg);
            checkIndices(title, csg, material);
            for (int i = 0; i < csg.operands().size(); i++) {
                Operand operand = csg.operands().get(i);
                visit(operandTitle(title, operand, i), operand.solid(), operand.material());
            }
        }
    }

    private void checkEnergy(String title, Material material) {
        double sum = material.diffusion() + material.reflection() + material.transparency();
        if (sum > 1 + 1e-9) {
            warnings.add(title + ": diffusion + reflection + transparency is " + Numbers.text(Math.round(sum * 1e6) / 1e6)
                    + ", more than the light that falls on it");
        }
    }

    private void checkOperands(String title, Csg csg) {
        Bounds first = bounds(csg.operands().get(0));
        for (int i = 1; i < csg.operands().size(); i++) {
            boolean apart = first.intersection(bounds(csg.operands().get(i))).isEmpty();
            if (apart && csg.operation() == Operation.DIFFERENCE) {
                warnings.add(operandTitle(title, csg.operands().get(i), i) + " removes nothing: it does not reach the first operand");
            } else if (apart && csg.operation() == Operation.INTERSECTION) {
                warnings.add(title + " is empty: " + operandTitle("", csg.operands().get(i), i).trim() + " does not reach the first operand");
            }
        }
    }

    /** One body is one medium: light that enters by one surface and leaves by another meets only one of two indices. */
    private void checkIndices(String title, Csg csg, MaterialSource own) {
        Set<Double> indices = new TreeSet<>();
        collectIndices(csg, resolve(own, Material.DEFAULT), indices);
        if (indices.size() > 1) {
            warnings.add(title + ": its transparent surfaces have different refractive indices; a body takes that of the surface where light enters");
        }
    }

    private void collectIndices(Csg csg, Material inherited, Set<Double> indices) {
        for (Operand operand : csg.operands()) {
            Material material = resolve(operand.material(), inherited);
            if (operand.solid() instanceof Csg nested) {
                collectIndices(nested, material, indices);
            } else if (material.transparency() > 0) {
                indices.add(material.refractiveIndex());
            }
        }
    }

    private void checkPlaces() {
        RenderScene ready = RenderScene.of(scene);
        for (int object : ready.objectsAround(scene.camera().position())) {
            warnings.add("the camera is inside " + title(object));
        }
        for (Light light : scene.lights()) {
            for (int object : ready.objectsAround(light.position())) {
                if (resolve(scene.objects().get(object).material(), Material.DEFAULT).transparency() == 0) {
                    String name = light.name().isEmpty() ? "the light at " + Numbers.text(light.position()) : "light \"" + light.name() + "\"";
                    warnings.add(name + " is inside " + title(object) + ", which is opaque: no light gets out");
                }
            }
        }
    }

    private Material resolve(MaterialSource source, Material inherited) {
        return source == Inherited.INHERITED ? inherited
                : source instanceof MaterialName name ? scene.materials().getOrDefault(name.name(), inherited) : (Material) source;
    }

    private String title(int object) {
        return title(scene.objects().get(object).name(), scene.objects().get(object).shape(), object);
    }

    private static String operandTitle(String parent, Operand operand, int number) {
        return parent + " / " + title(operand.name(), operand.solid(), number);
    }

    private static String title(String name, Shape shape, int number) {
        String kind = (shape instanceof Csg csg ? csg.operation().name() : shape.getClass().getSimpleName()).toLowerCase(Locale.ROOT);
        return name.isEmpty() ? kind + " number " + (number + 1) : kind + " \"" + name + "\"";
    }

    private static Bounds bounds(Operand operand) {
        return operand.solid().bounds().transformed(operand.placement().toParent());
    }
}
