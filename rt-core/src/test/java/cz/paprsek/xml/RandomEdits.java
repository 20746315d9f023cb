package cz.paprsek.xml;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Random;
import java.util.function.UnaryOperator;

/** What people do to scenes, in any order. */
final class RandomEdits {
    private final Random random;
    private final List<UnaryOperator<Scene>> keeping = List.of(
            scene -> scene.withName(scene.name().isEmpty() ? "It's new" : scene.name() + "'s \"<other>\" 光"),
            scene -> scene.withTags(List.of("new", "it's")), scene -> scene.withTags(List.of()),
            scene -> scene.withDescription("Said\n <anew> & \"so\" ěšč"),
            scene -> scene.withSettings(new RenderSettings(17, 600, 5, 2)),
            scene -> scene.withSettings(scene.settings().withSamples(2, 7).withError(0.02)), scene -> scene.sky() == Sky.NONE ? scene.withBackground(Rgb.grey(77)) : scene,
            scene -> scene.withAmbient(Rgb.grey(3)), scene -> scene.withCamera(scene.camera().withFovy(33)),
            this::anotherLight, this::changedLight, this::anotherMaterial, this::changedMaterial, this::mixedMaterials,
            this::moved, this::moved, this::resized, this::renamed, this::another, this::mixed, this::changedInside, this::rotatedInside, this::otherOperation);
    private final List<UnaryOperator<Scene>> removing = List.of(
            scene -> scene.withDescription(""), scene -> scene.withSettings(RenderSettings.DEFAULT), scene -> scene.withBackground(Rgb.BLACK),
            scene -> scene.withLights(List.of()), scene -> scene.withLights(scene.lights().subList(0, scene.lights().size() / 2)),
            this::without, this::without, this::otherKind, this::repainted, this::repatterned, this::grouped, this::ungrouped, this::lessInside, scene -> scene.withObjects(List.of()));

    RandomEdits(long seed) {
        random = new Random(seed);
    }

    /** Changed, added to, and in another order; nothing is taken away. */
    Scene keeping(Scene scene) {
        return keeping.get(random.nextInt(keeping.size())).apply(scene);
    }

    Scene any(Scene scene) {
        int which = random.nextInt(keeping.size() + removing.size());
        return (which < keeping.size() ? keeping.get(which) : removing.get(which - keeping.size())).apply(scene);
    }

    private Scene anotherLight(Scene scene) {
        List<Light> lights = new ArrayList<>(scene.lights());
        lights.add(random.nextInt(lights.size() + 1), switch (random.nextInt(5)) {
            case 0 -> Light.at(random.nextInt(9), 2, 3);
            case 1 -> SpotLight.from(new Vec3(random.nextInt(9), 2, 3), Vec3.ZERO);
            case 2 -> AreaLight.rectangle(new Vec3(random.nextInt(9), 2, 3), 1, 2);
            case 3 -> SphereLight.of(new Vec3(random.nextInt(9), 2, 3), 0.5);
            default -> SunLight.along(random.nextInt(9), -1, 0);
        });
        return scene.withLights(lights);
    }

    private Scene changedLight(Scene scene) {
        return scene.withLights(scene.lights().stream().map(light -> random.nextBoolean() ? light : light.withIntensity(random.nextInt(5))).toList());
    }

    private Scene anotherMaterial(Scene scene) {
        return scene.plus("fresh " + random.nextInt(1000), Material.color(random.nextInt(255), 1, 2));
    }

    private Scene changedMaterial(Scene scene) {
        Map<String, Material> all = new LinkedHashMap<>(scene.materials());
        all.replaceAll((name, material) -> random.nextInt(3) > 0 ? material : material.withReflection(0.5));
        return scene.withMaterials(all);
    }

    private Scene repatterned(Scene scene) {
        Map<String, Material> all = new LinkedHashMap<>(scene.materials());
        all.replaceAll((name, material) -> random.nextInt(3) > 0 ? material : material.withPattern(new Pattern.Plain(new Rgb(9, 8, 7))));
        return scene.withMaterials(all);
    }

    private Scene mixedMaterials(Scene scene) {
        List<String> names = new ArrayList<>(scene.materials().keySet());
        Collections.shuffle(names, random);
        Map<String, Material> all = new LinkedHashMap<>();
        names.forEach(name -> all.put(name, scene.materials().get(name)));
        return scene.withMaterials(all);
    }

    private Scene each(Scene scene, UnaryOperator<SceneObject> change) {
        return scene.withObjects(scene.objects().stream().map(object -> random.nextInt(4) > 0 ? object : change.apply(object)).toList());
    }

    private Scene moved(Scene scene) {
        return each(scene, object -> object.placed(object.placement().withPosition(random.nextBoolean() ? Vec3.ZERO : new Vec3(1, random.nextInt(9), 0.5))));
    }

    private Scene resized(Scene scene) {
        return each(scene, object -> object.shape() instanceof Sphere ? object.withShape(new Sphere(1 + random.nextInt(5))) : object);
    }

    private Scene repainted(Scene scene) {
        return each(scene, object -> object.madeOf(random.nextBoolean() || scene.materials().isEmpty() ? random.nextBoolean() ? Inherited.INHERITED
                : Material.color(1, 2, random.nextInt(9)) : new MaterialName(scene.materials().keySet().iterator().next())));
    }

    private Scene renamed(Scene scene) {
        List<SceneObject> objects = new ArrayList<>(scene.objects());
        objects.replaceAll(object -> random.nextInt(4) > 0 ? object : object.named(random.nextBoolean() ? "" : "called " + random.nextInt(1 << 30)));
        return scene.withObjects(objects);
    }

    private Scene another(Scene scene) {
        List<SceneObject> objects = new ArrayList<>(scene.objects());
        Csg csg = Csg.union(Operand.of(new Sphere(2)), Operand.of(new Cone(1, 0, 2)).madeOf(Material.color(5, 5, 5)));
        objects.add(random.nextInt(objects.size() + 1), SceneObject.of(random.nextBoolean() ? csg : new Sphere(3)).at(random.nextInt(5), 0, 0));
        return scene.withObjects(objects);
    }

    private Scene mixed(Scene scene) {
        List<SceneObject> objects = new ArrayList<>(scene.objects());
        if (random.nextBoolean()) {
            Collections.shuffle(objects, random);
        } else if (objects.size() > 1) {
            objects.add(random.nextInt(objects.size() - 1), objects.remove(random.nextInt(objects.size())));
        }
        return scene.withObjects(objects);
    }

    private Scene without(Scene scene) {
        return scene.withObjects(scene.objects().stream().filter(object -> random.nextInt(4) > 0).toList());
    }

    private Scene grouped(Scene scene) {
        List<SceneObject> objects = new ArrayList<>(scene.objects());
        List<SceneObject> solids = objects.stream().filter(object -> object.shape() instanceof Solid && !isBoard(scene, object)).limit(2).toList();
        if (solids.size() < 2) {
            return scene;
        }
        objects.removeAll(solids);
        objects.add(SceneObject.of(new Csg(Csg.Operation.UNION, solids.stream()
                .map(object -> new Operand(object.name(), (Solid) object.shape(), object.placement(), object.material())).toList())));
        return scene.withObjects(objects);
    }

    private static boolean isBoard(Scene scene, SceneObject object) {
        return object.material() instanceof MaterialName name && Objects.requireNonNull(scene.materials().get(name.name())).pattern() instanceof Pattern.Checkerboard;
    }

    private Scene ungrouped(Scene scene) {
        List<SceneObject> objects = new ArrayList<>();
        scene.objects().forEach(object -> {
            if (object.shape() instanceof Csg csg) {
                csg.operands().forEach(operand -> objects.add(new SceneObject("", operand.solid(), operand.placement(), operand.material())));
            } else {
                objects.add(object);
            }
        });
        return scene.withObjects(objects);
    }

    private Scene changedInside(Scene scene) {
        return each(scene, object -> object.shape() instanceof Csg csg ? object.withShape((Csg) inside(csg)) : object);
    }

    private Solid inside(Solid solid) {
        if (!(solid instanceof Csg csg)) {
            return solid instanceof Sphere ? new Sphere(1 + random.nextInt(7)) : solid;
        }
        List<Operand> operands = new ArrayList<>(csg.operands());
        if (random.nextBoolean()) {
            operands.add(random.nextInt(operands.size() + 1), Operand.of(new Sphere(0.5)).at(random.nextInt(4), 1, 1));
        }
        operands.replaceAll(operand -> new Operand(operand.name(), inside(operand.solid()), operand.placement(), operand.material()));
        return new Csg(csg.operation(), operands);
    }

    private Scene rotatedInside(Scene scene) {
        return each(scene, object -> {
            if (!(object.shape() instanceof Csg csg)) {
                return object;
            }
            List<Operand> operands = new ArrayList<>(csg.operands());
            Collections.rotate(operands, 1);
            return object.withShape(new Csg(csg.operation(), operands));
        });
    }

    private Scene otherOperation(Scene scene) {
        return each(scene, object -> object.shape() instanceof Csg csg ? object.withShape(new Csg(Csg.Operation.DIFFERENCE, csg.operands())) : object);
    }

    private Scene otherKind(Scene scene) {
        return each(scene, object -> object.shape() instanceof Solid && !(object.shape() instanceof Csg) ? object.withShape(new Cone(1, 0.5, 3)) : object);
    }

    private Scene lessInside(Scene scene) {
        return each(scene, object -> object.shape() instanceof Csg csg
                ? object.withShape(new Csg(csg.operation(), csg.operands().subList(0, (csg.operands().size() + 1) / 2))) : object);
    }
}
