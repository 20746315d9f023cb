package cz.paprsek.cli.describe;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Csg.Operation;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Surface;
import cz.paprsek.shape.Volume;
import cz.paprsek.text.Numbers;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** What is allowed in a scene, but hardly what its author meant. */
public final class SceneWarnings {
    /** Sums of decimals such as 0.1 + 0.7 + 0.2 may come out a little above 1. */
    private static final double SLACK = 1e-9;

    private final Scene scene;
    private final List<SceneWarning> warnings = new ArrayList<>();
    private final List<GlassContacts.Body> transparent = new ArrayList<>();

    private SceneWarnings(Scene scene) {
        this.scene = scene;
    }

    /** All that is suspicious about a scene. */
    public static List<SceneWarning> of(Scene scene) {
        SceneWarnings check = new SceneWarnings(scene);
        List<SceneParts.Part> parts = SceneParts.of(scene);
        check.light();
        check.materials(parts);
        parts.forEach(check::operands);
        for (int i = 0; i < scene.objects().size(); i++) {
            check.object(scene.objects().get(i), SceneParts.of(scene, i));
        }
        check.glass();
        return check.warnings;
    }

    private void add(String kind, String object, String message) {
        warnings.add(new SceneWarning(kind, object, message));
    }

    private void light() {
        boolean isLit = scene.lights().stream().anyMatch(light -> light.intensity() > 0 && !light.color().equals(Rgb.BLACK));
        if (scene.objects().isEmpty()) {
            add("empty", "", "there are no objects; the picture will be the background alone");
        } else if (!isLit && scene.ambient().equals(Rgb.BLACK)) {
            add("dark", "", "there is no light and no ambient light; every surface will be black");
        }
    }

    private void materials(List<SceneParts.Part> parts) {
        Set<String> used = new HashSet<>();
        scene.materials().forEach((name, material) -> energy("material \"" + name + "\"", material));
        for (SceneParts.Part part : parts) {
            if (part.source() instanceof MaterialName reference) {
                used.add(reference.name());
            } else if (part.source() instanceof Material own) {
                energy("material of " + part.label(), own);
            }
        }
        scene.materials().keySet().stream().filter(name -> !used.contains(name))
                .forEach(name -> add("unused", "material \"" + name + "\"", "material \"" + name + "\" is not used"));
    }

    private void energy(String what, Material material) {
        double sum = material.diffusion() + material.reflection() + material.transparency();
        if (sum > 1 + SLACK) {
            add("energy", what, what + ": diffusion, reflection and transparency add up to " + Numbers.text(Math.rint(sum * 1e6) / 1e6)
                    + "; above 1 a surface gives back more light than it gets");
        }
    }

    private void operands(SceneParts.Part part) {
        if (!(part.shape() instanceof Csg csg) || csg.operation() == Operation.UNION) {
            return;
        }
        Bounds left = bounds(csg.operands().get(0));
        for (int i = 1; i < csg.operands().size(); i++) {
            Operand operand = csg.operands().get(i);
            if (left.intersection(bounds(operand)).isEmpty()) {
                String label = operand.solid().kind() + (operand.name().isEmpty() ? " #" + (i + 1) : " \"" + operand.name() + "\"")
                        + " in " + part.label();
                add("operand", label, csg.operation() == Operation.DIFFERENCE
                        ? label + " removes nothing: it does not meet the first operand"
                        : label + " does not meet the operands before it; nothing is left of the intersection");
            }
            left = csg.operation() == Operation.DIFFERENCE ? left : left.intersection(bounds(operand));
        }
    }

    private static Bounds bounds(Operand operand) {
        return Solids.place(operand.solid(), operand.placement()).bounds();
    }

    private void object(SceneObject object, List<SceneParts.Part> parts) {
        String label = parts.get(0).label();
        List<Material> made = parts.stream().filter(part -> !(part.shape() instanceof Csg)).map(SceneParts.Part::material).toList();
        boolean isOpaque = made.stream().allMatch(material -> material.transparency() == 0);
        long indices = made.stream().filter(material -> material.transparency() > 0).mapToDouble(Material::refractiveIndex).distinct().count();
        if (indices > 1) {
            add("indices", label, label + " is transparent, but its operands have different refractive indices; one body has one index");
        }
        Surface placed = Solids.place(object.shape(), object.placement());
        if (!isOpaque && placed instanceof Volume volume) {
            double index = made.stream().filter(material -> material.transparency() > 0).findFirst().orElseThrow().refractiveIndex();
            transparent.add(new GlassContacts.Body(label, volume, index));
        }
        if (Solids.holds(placed, scene.camera().position())) {
            add("camera-inside", label, "the camera is inside " + label + (isOpaque ? ", which is opaque; it will see nothing else" : ""));
        }
        for (int i = 0; i < scene.lights().size(); i++) {
            Light light = scene.lights().get(i);
            if (isOpaque && Solids.holds(placed, light.position())) {
                String lamp = light.name().isEmpty() ? "light #" + (i + 1) : "light \"" + light.name() + "\"";
                add("light-inside", lamp, lamp + " is inside " + label + ", which is opaque; it lights nothing outside");
            }
        }
    }

    private void glass() {
        for (GlassContacts.Contact contact : GlassContacts.among(transparent, scene.camera().position())) {
            GlassContacts.Body first = contact.first();
            GlassContacts.Body second = contact.second();
            add(contact.overlap() ? "glass-overlaps" : "glass-touches", first.label(), first.label() + " and " + second.label()
                    + (contact.overlap() ? " reach into each other" : " touch") + " near " + rounded(contact.point()) + ", with the refractive indices "
                    + Numbers.text(first.index()) + " and " + Numbers.text(second.index())
                    + (contact.overlap() ? "; where both are, that of the one entered last counts" : "; there light goes straight from the one to the other")
                    + " (found by trying " + GlassContacts.RAYS + " rays)");
        }
    }

    private static String rounded(Vec3 p) {
        return Numbers.text(new Vec3(rounded(p.x()), rounded(p.y()), rounded(p.z())));
    }

    private static double rounded(double x) {
        return x == 0 || Math.abs(x) < 1e-9 ? 0 : new BigDecimal(x).round(new MathContext(4)).doubleValue();
    }
}
