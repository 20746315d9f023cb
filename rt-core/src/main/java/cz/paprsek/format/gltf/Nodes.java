package cz.paprsek.format.gltf;

import cz.paprsek.format.model.Convention;
import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Model;
import cz.paprsek.format.model.Notes;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Goes through the nodes of a scene, each of which has one parent at most, and puts what they hold into the world. */
final class Nodes {
    private final Tree document;
    private final Accessors accessors;
    private final Meshes meshes;
    private final Notes notes;
    private final List<Camera> cameras = new ArrayList<>();
    private final List<Light> lights = new ArrayList<>();
    private final Set<String> cameraNames = new HashSet<>();
    private final Set<String> lightNames = new HashSet<>();

    Nodes(Tree document, Accessors accessors, Meshes meshes, Notes notes) {
        this.document = document;
        this.accessors = accessors;
        this.meshes = meshes;
        this.notes = notes;
    }

    private record Step(int node, Affine toWorld) {}

    /** Everything of the scene that is shown at first; of all nodes if there is no scene. */
    void scene(Affine toWorld) throws IOException {
        int count = document.count("nodes");
        int[] roots = roots(count);
        BitSet seen = new BitSet();
        Deque<Step> steps = new ArrayDeque<>();
        List<Step> shown = new ArrayList<>();
        Affine[] worlds = new Affine[count];
        Arrays.fill(worlds, Affine.IDENTITY);
        for (int i = roots.length - 1; i >= 0; i--) {
            steps.push(new Step(roots[i], toWorld));
        }
        while (!steps.isEmpty()) {
            Step step = steps.pop();
            Tree node = document.item("nodes", step.node);
            if (seen.get(step.node)) {
                throw node.fault("this node is within itself, or has two parents");
            }
            seen.set(step.node);
            Optional<Tree> visibility = node.extension("KHR_node_visibility");
            if (visibility.isPresent() && visibility.get().has("visible") && !visibility.get().flag("visible")) {
                continue;
            }
            Affine here = step.toWorld.after(placement(node));
            worlds[step.node] = here;
            shown.add(new Step(step.node, here));
            int[] children = node.indexes("children", count);
            for (int i = children.length - 1; i >= 0; i--) {
                steps.push(new Step(children[i], here));
            }
        }
        // Bones may come after what hangs on them.
        for (Step step : shown) {
            show(document.item("nodes", step.node), step.toWorld, worlds);
        }
    }

    private int[] roots(int count) throws IOException {
        if (document.count("scenes") > 0) {
            return document.item("scenes", document.whole("scene", 0)).indexes("nodes", count);
        }
        BitSet children = new BitSet();
        for (int i = 0; i < count; i++) {
            for (int child : document.item("nodes", i).indexes("children", count)) {
                children.set(child);
            }
        }
        int[] roots = new int[count - children.cardinality()];
        for (int i = 0, at = 0; i < count; i++) {
            if (!children.get(i)) {
                roots[at++] = i;
            }
        }
        return roots;
    }

    private static Affine placement(Tree node) throws FormatFault {
        if (node.has("matrix")) {
            double[] m = node.numbers("matrix", 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
            return new Affine(m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14]);
        }
        double[] t = node.numbers("translation", 0, 0, 0);
        double[] q = node.numbers("rotation", 0, 0, 0, 1);
        double[] s = node.numbers("scale", 1, 1, 1);
        double length = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
        if (!(length > 0 && length < Double.POSITIVE_INFINITY)) {
            throw node.fault("rotation", "a rotation must have a length");
        }
        double k = 2 / length;
        double x = q[0];
        double y = q[1];
        double z = q[2];
        double w = q[3];
        return new Affine(
                (1 - k * (y * y + z * z)) * s[0], k * (x * y - z * w) * s[1], k * (x * z + y * w) * s[2], t[0],
                k * (x * y + z * w) * s[0], (1 - k * (x * x + z * z)) * s[1], k * (y * z - x * w) * s[2], t[1],
                k * (x * z - y * w) * s[0], k * (y * z + x * w) * s[1], (1 - k * (x * x + y * y)) * s[2], t[2]);
    }

    private void show(Tree node, Affine here, Affine[] worlds) throws IOException {
        boolean isShown = node.has("mesh") || node.has("camera") || node.extension("KHR_lights_punctual").isPresent();
        if (!isShown) {
            return;
        }
        boolean isSkinned = node.has("mesh") && node.has("skin");
        if (!here.isSane() && !isSkinned) {
            notes.add(node.path(), "this is flattened by its node, and not shown");
            return;
        }
        String name = node.text("name", "").strip();
        if (node.has("mesh")) {
            Optional<Skin> skin = isSkinned ? Optional.of(Skin.of(document.item("skins", node.needed("skin")), accessors, worlds)) : Optional.empty();
            if (isSkinned) {
                notes.add(node.path(), "a skin is shown as its bones are at first");
            }
            meshes.show(node.needed("mesh"), name, new Meshes.Pose(here, skin), node.anyNumbers("weights"));
        }
        if (node.has("camera")) {
            cameras.add(camera(document.item("cameras", node.needed("camera")), unique(name, cameraNames), here));
        }
        Optional<Tree> light = node.extension("KHR_lights_punctual");
        if (light.isPresent()) {
            Tree all = document.extension("KHR_lights_punctual").orElse(document);
            lights.add(light(all.item("lights", light.get().needed("light")), unique(name, lightNames), here));
        }
    }

    private static String unique(String name, Set<String> taken) {
        String known = name;
        for (int i = 2; !name.isEmpty() && !taken.add(known); i++) {
            known = name + " " + i;
        }
        return known;
    }

    private static Camera camera(Tree tree, String name, Affine here) throws FormatFault {
        Vec3 position = here.point(Vec3.ZERO);
        Camera plain = Camera.looking(position, here.direction(new Vec3(0, 0, -1)).normalized()).withUp(here.direction(Vec3.Y).normalized()).named(name);
        return switch (tree.text("type", "")) {
            case "perspective" -> plain.withFovy(StrictMath.toDegrees(tree.childOrNothing("perspective").share("yfov", 0.785, 1e-6, 3.14159)));
            case "orthographic" -> plain.withLens(new Lens.Orthographic(2 * tree.childOrNothing("orthographic").share("ymag", 1, 1e-30, 1e30)));
            default -> throw tree.fault("type", "this must be perspective or orthographic");
        };
    }

    /** Candela and lux are π times our intensities, which arrive at a distance of 1. */
    private static Light light(Tree tree, String name, Affine here) throws FormatFault {
        double[] rgb = tree.numbers("color", 1, 1, 1);
        for (double channel : rgb) {
            if (!(channel >= 0 && channel <= 1)) {
                throw tree.fault("color", "these must be numbers from 0 to 1");
            }
        }
        Rgb color = Rgb.ofLinear(rgb[0], rgb[1], rgb[2]);
        double intensity = tree.share("intensity", 1, 0, 1e12) / Math.PI;
        Vec3 position = here.point(Vec3.ZERO);
        Vec3 direction = here.direction(new Vec3(0, 0, -1)).normalized();
        return switch (tree.text("type", "")) {
            case "directional" -> new SunLight(name, direction, color, intensity, 0, false);
            case "point" -> new PointLight(name, position, color, intensity, 1);
            case "spot" -> spot(tree.childOrNothing("spot"), name, position, direction, color, intensity);
            default -> throw tree.fault("type", "this must be directional, point or spot");
        };
    }

    private static Light spot(Tree cone, String name, Vec3 position, Vec3 direction, Rgb color, double intensity) throws FormatFault {
        double inner = cone.share("innerConeAngle", 0, 0, Math.PI / 2);
        double outer = cone.share("outerConeAngle", Math.PI / 4, inner, Math.PI / 2);
        return new SpotLight(name, position, new Camera.Direction(direction), color, intensity, 1, Math.min(89, StrictMath.toDegrees(inner)),
                Math.min(89.9, Math.max(1e-3, StrictMath.toDegrees(outer))));
    }

    boolean isEmpty() {
        return meshes.isEmpty();
    }

    Model model(Materials materials, Images images, Convention convention) {
        return new Model(meshes.triangles(), meshes.materialOf(), materials.all(), images.within(), cameras, lights, convention, notes.toList(), notes.missing());
    }
}
