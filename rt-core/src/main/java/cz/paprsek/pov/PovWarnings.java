package cz.paprsek.pov;

import static cz.paprsek.text.Numbers.text;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.material.Share;
import cz.paprsek.math.Bounds;
import cz.paprsek.render.light.FixedPoints;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PlacedLight;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Extrude;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Text;
import cz.paprsek.shape.height.HeightField;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;

/** What POV-Ray will not show exactly as we do, in sentences. */
final class PovWarnings {
    /** Scenes that POV-Ray's absolute tolerances of 1e-3 and 1e-4 suit, scene units. */
    private static final double SMALLEST = 0.5;
    private static final double LARGEST = 1e5;
    /** Of more objects, the same is said once. */
    private static final int MOST_NAMED = 8;

    private final Scene scene;
    private final boolean moves;
    private final Set<String> sentences = new LinkedHashSet<>();

    private PovWarnings(Scene scene, boolean moves) {
        this.scene = scene;
        this.moves = moves;
    }

    /** @param moves whether the scene is one in which something moves, though not in what is told */
    static List<String> of(Scene scene, boolean moves) {
        PovWarnings warnings = new PovWarnings(scene, moves);
        warnings.check();
        return List.copyOf(warnings.sentences);
    }

    /** The different materials of an object, in the order of its parts. */
    static List<Material> materials(Scene scene, SceneObject object) {
        Set<Material> found = new LinkedHashSet<>();
        each(scene, object, (shape, material) -> found.add(material));
        return List.copyOf(found);
    }

    /** All materials that anything in a scene is made of. */
    static Set<Material> materials(Scene scene) {
        Set<Material> found = new LinkedHashSet<>(scene.materials().values());
        scene.objects().forEach(object -> each(scene, object, (shape, material) -> found.add(material)));
        return found;
    }

    /** Those that light shines through. */
    private static List<Material> transparent(Scene scene, SceneObject object) {
        return materials(scene, object).stream().filter(material -> material.transparency() > 0).toList();
    }

    /** Visits what an object's parts are made of, with the shape for which that is written. */
    private static void each(Scene scene, SceneObject object, BiConsumer<Shape, Material> visitor) {
        each(scene, object.shape(), object.shape(), object.material(), visitor);
    }

    /**
     * The same of an operand.
     *
     * @param whole what is given the material: itself, or what it is part of
     */
    private static void each(Scene scene, Shape shape, Shape whole, MaterialSource given, BiConsumer<Shape, Material> visitor) {
        if (shape instanceof Csg csg) {
            for (Operand operand : csg.operands()) {
                boolean inherits = operand.material() == Inherited.INHERITED;
                each(scene, operand.solid(), inherits ? whole : operand.solid(), inherits ? given : operand.material(), visitor);
            }
        } else if (given == Inherited.INHERITED && shape instanceof Mesh mesh && mesh.isRead()) {
            mesh.triangles().parts().forEach(part -> visitor.accept(mesh, mesh.materialOf(part).orElse(Material.DEFAULT)));
        } else {
            visitor.accept(whole, given == Inherited.INHERITED ? Material.DEFAULT : given instanceof MaterialName reference ? reference.in(scene.materials()) : (Material) given);
        }
    }

    private void check() {
        checkRays(scene.settings());
        checkShown(scene.settings());
        if (moves) {
            sentences.add("for POV-Ray nothing moves, and all is as the scene is written; convert --frame N gives it one of the pictures of a film");
        }
        checkLights();
        if (scene.camera().lens() instanceof Lens.Perspective lens && lens.aperture() > 0) {
            sentences.add("POV-Ray is told neither aperture nor focus: it has other points of a lens than we, is given the middle of it, and all is sharp");
        }
        checkSize();
        checkOverlap();
        checkObjects();
    }

    /** What is to be said of many objects is said of the first of them. */
    private void checkObjects() {
        Map<String, List<String>> alike = new LinkedHashMap<>();
        for (int i = 0; i < scene.objects().size(); i++) {
            SceneObject object = scene.objects().get(i);
            String name = object.name().isEmpty() ? "object #" + (i + 1) : "\"" + object.name() + "\"";
            PovWarnings one = new PovWarnings(scene, moves);
            one.check("", object);
            one.sentences.forEach(said -> alike.computeIfAbsent(said, first -> new ArrayList<>()).add(name));
        }
        alike.forEach((said, names) -> {
            if (names.size() > MOST_NAMED) {
                sentences.add(names.get(0) + " (and " + (names.size() - 1) + " more)" + said);
            } else {
                names.forEach(name -> sentences.add(name + said));
            }
        });
    }

    private void checkRays(RenderSettings settings) {
        String filter = settings.filter() == PixelFilter.BOX ? "" : ", nor weighs their rays by the filter " + settings.filter();
        if (settings.isPath()) {
            sentences.add("POV-Ray does not follow paths of light; its picture is that of --integrator whitted, without the light that surfaces send each other"
                    + filter + ", with one ray through the centre of each pixel");
        } else if (settings.isAdaptive() || (settings.samples() > 1 && !filter.isEmpty())) {
            sentences.add("POV-Ray does not sample pixels " + (settings.isAdaptive() ? "at random, by error and confidence" : "on a grid") + filter
                    + "; it is given one ray through the centre of each");
        } else if (settings.samples() > 1) {
            sentences.add("POV-Ray does not sample pixels on a grid; for the same picture render it " + settings.samples()
                    + " times as wide and high, and average");
        }
    }

    private void checkShown(RenderSettings settings) {
        if (settings.shutter() > 0) {
            sentences.add("what moves is sharp for POV-Ray, as it is when the shutter opens");
        }
        if (settings.exposure() != 0 || settings.tone() != Tone.NONE) {
            sentences.add("POV-Ray knows neither exposure nor tone; its picture has the light as it is");
        }
    }

    private void checkLights() {
        boolean isSampled = false;
        for (int i = 0; i < scene.lights().size(); i++) {
            Light light = scene.lights().get(i);
            String name = light.name().isEmpty() ? "light #" + (i + 1) : "\"" + light.name() + "\"";
            if (light instanceof SphereLight) {
                sentences.add(name + " is a ball; POV-Ray is given a point in its middle instead of samples of its radius: shadows are sharp, and what is seen of it casts none");
            }
            isSampled |= !FixedPoints.of(light, i).isEmpty();
        }
        if (isSampled) {
            sentences.add("lights with a size are as many small ones for POV-Ray as they have samples; render with --sampler fixed for the same picture");
        }
    }

    private void checkSize() {
        Bounds all = Bounds.of(scene.camera().position(), scene.camera().position());
        for (Light light : scene.lights()) {
            all = light instanceof PlacedLight placed ? all.union(Bounds.of(placed.position(), placed.position())) : all;
        }
        for (SceneObject object : scene.objects()) {
            Bounds bounds = bounds(object);
            all = bounds.isFinite() ? all.union(bounds) : all;
        }
        double size = Math.max(all.maxX() - all.minX(), Math.max(all.maxY() - all.minY(), all.maxZ() - all.minZ()));
        if (!scene.objects().isEmpty() && (size < SMALLEST || size > LARGEST)) {
            sentences.add("the scene is " + rounded(size) + " units large; POV-Ray loses what is nearer than 0.001 and what is too far:"
                    + " scale it to about 1 to 100");
        }
    }

    /** Looks for glass within glass along one axis: as far as each body reaches, and no farther. */
    private void checkOverlap() {
        List<Bounds> glass = new ArrayList<>();
        for (SceneObject object : scene.objects()) {
            if (object.shape().hasInside() && !transparent(scene, object).isEmpty()) {
                glass.add(bounds(object));
            }
        }
        glass.sort(Comparator.comparingDouble(Bounds::minX));
        for (int i = 0; i < glass.size(); i++) {
            for (int j = i + 1; j < glass.size() && glass.get(j).minX() <= glass.get(i).maxX(); j++) {
                if (!glass.get(i).intersection(glass.get(j)).isEmpty()) {
                    sentences.add("where bodies of glass reach into each other POV-Ray does not count the way out of one, still within the other,"
                            + " as a level of max-depth");
                    return;
                }
            }
        }
    }

    private static Bounds bounds(SceneObject object) {
        return object.shape().bounds().transformed(object.placement().toParent());
    }

    /** Of meshes whose materials are those of their files, of relief, and of letters. */
    private void checkFiles(String name, Shape shape, MaterialSource given) {
        if (shape instanceof Csg csg) {
            csg.operands().forEach(operand -> checkFiles(name, operand.solid(), operand.material() == Inherited.INHERITED ? given : operand.material()));
        } else if (shape instanceof Text text && text.isRead() && PovOutlines.areOver(text)) {
            sentences.add(name + " has letters, or parts of them, that lie over each other; POV-Ray has holes there");
        } else if (shape instanceof Extrude extrude && extrude.twist() != 0) {
            sentences.add(name + " is twisted, as nothing is that POV-Ray sweeps; it is told a mesh instead, off by up to about " + error(extrude));
        } else if (shape instanceof HeightField field) {
            PovPictures.lost(field).forEach(lost -> sentences.add(name + ": " + lost));
        } else if (given == Inherited.INHERITED && shape instanceof Mesh mesh && mesh.isRead() && !PovMesh.isTold(mesh)) {
            sentences.add(name + ": POV-Ray is told the colours of corners only over one colour, and up to white");
        }
    }

    private static String error(Extrude twisted) {
        double error = PovTwisted.error(twisted);
        return error > 0.5 ? "its radius, since it has so many turns" : "1/" + Math.round(1 / error) + " of its radius";
    }

    private void checkMaterials(String name, SceneObject object) {
        checkFiles(name, object.shape(), object.material());
        each(scene, object, (shape, material) -> {
            if (material.pattern() instanceof Pattern.Picture picture) {
                PovPictures.lost(picture, shape).forEach(lost -> sentences.add(name + ": " + lost));
            }
            PovBumps.lost(material, shape).forEach(lost -> sentences.add(name + ": " + lost));
        });
        for (Material material : materials(scene, object)) {
            if (material.fresnel() == Fresnel.METAL && material.reflection() > 0 && !(material.pattern() instanceof Pattern.Plain)) {
                sentences.add(name + " is a metal of several colours; POV-Ray lets it mirror in one");
            }
            if (!PovMaterials.emits(material)) {
                sentences.add(name + ": POV-Ray multiplies the emission by the colour, and does not show it where that is black or there are several");
            }
            checkShares(name, material);
            if (material.roughness() > 0 && (material.reflection() > 0 || material.transparency() > 0)) {
                sentences.add(name + ": POV-Ray is not told the roughness of its material, and shows it smooth");
            }
            if (material.thin() && material.transparency() > 0) {
                sentences.add(name + " is thin and bends nothing; POV-Ray is told a refractive index of 1, and mirrors on one side");
            }
            Untold.of(material).forEach(attribute -> sentences.add(name + ": POV-Ray is not told the " + attribute + " of its material"));
        }
    }

    private void checkShares(String name, Material material) {
        Described.values(material.shares()).forEach((share, value) -> {
            if (value instanceof Share.ByPattern by && !PovPatterns.isTold(by.pattern())) {
                sentences.add(name + ": POV-Ray is not told the " + share + " of its material point by point, as a picture has it, and takes the greatest");
            }
        });
    }

    private void check(String name, SceneObject object) {
        checkMaterials(name, object);
        List<Material> materials = transparent(scene, object);
        List<Double> indices = new ArrayList<>(materials.stream().map(Material::refractiveIndex).distinct().toList());
        boolean solid = object.shape().hasInside();
        if (solid && indices.size() > 1) {
            sentences.add(name + " has surfaces of several refractive indices; POV-Ray knows one inside only and is told "
                    + text(indices.get(0)));
        }
        for (Material material : materials) {
            boolean isGlass = material.fresnel() == Fresnel.TRUE;
            double both = material.reflection() + material.transparency() * (isGlass ? 1 - material.reflection() : 1);
            if (solid && material.refractiveIndex() != 1 && Math.abs(both - 1) > 1e-9) {
                sentences.add(name + ": where light is totally reflected POV-Ray gives back all of it, we give back "
                        + (isGlass ? "reflection + transparency · (1 − reflection) = " : "reflection + transparency = ") + rounded(both));
            }
            if (!solid && isGlass) {
                sentences.add(name + " mirrors on both sides as a pane of glass does; POV-Ray does not know that of a figure without an inside");
            }
            if (!solid || material.refractiveIndex() == 1) {
                sentences.add(name + ": POV-Ray does not count rays that go straight through as a level of max-depth");
            }
        }
    }

    /** For people: without the digits that come of adding. */
    private static String rounded(double value) {
        return text(Math.rint(value * 1e6) / 1e6);
    }
}
