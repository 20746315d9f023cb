package cz.paprsek.scene;

import cz.paprsek.list.Difference;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.material.Pattern;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.copied.Original;
import cz.paprsek.text.Similar;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/** What must hold between the parts of a scene, beyond what each part checks by itself. */
public final class SceneRules {
    private SceneRules() {}

    /** The longest name, in characters of Java. */
    public static final int LONGEST_NAME = 200;

    /** How deep operations may be nested: as elements in files, and safe for every recursion in the program. */
    private static final int DEEPEST = 250;
    private static final String TOO_DEEP = "the operations of this object are nested deeper than the " + DEEPEST + " levels that they may be";

    /** Refuses a scene with the first rule that is broken. */
    static final Report REFUSE = (culprit, attribute, sentence) -> {
        throw new IllegalArgumentException(sentence);
    };

    /** Is told of every rule that is broken. */
    @FunctionalInterface
    public interface Report {
        /**
         * @param culprit the camera, light, material, object, operand or animation at fault: the very instance that was passed in
         * @param attribute which of its attributes is at fault, by its name in files; empty if none is, or several are
         * @param sentence what is wrong and what to do
         */
        void broken(Object culprit, String attribute, String sentence);
    }

    /** Checks the names of cameras, which are those of no others. */
    public static void checkCameras(List<Camera> cameras, Report report) {
        Objects.requireNonNull(report, "report");
        Set<String> names = new HashSet<>();
        cameras.forEach(camera -> checkName("camera", camera.name(), camera, names, report));
    }

    /** Checks names, references to materials and patterns of a scene's parts, in the order of the lists. */
    public static void check(
            List<Light> lights, Map<String, Material> materials, List<SceneObject> objects, Report report) {
        Objects.requireNonNull(report, "report");
        checkLights(lights, report);
        checkMaterials(materials, report);
        checkObjects(objects, materials, report);
    }

    /** Checks animations of a scene that has none yet: that each is of one thing in it, and of an attribute that can be animated, whose keys it takes. */
    public static void checkAnimations(Scene scene, List<Animation> animations, Report report) {
        Objects.requireNonNull(scene, "scene");
        Animations.check(scene, animations, Objects.requireNonNull(report, "report"));
    }

    static void checkLights(List<Light> lights, Report report) {
        Set<String> names = new HashSet<>();
        lights.forEach(light -> checkName("light", light.name(), light, names, report));
    }

    static void checkMaterials(Map<String, Material> materials, Report report) {
        materials.forEach((name, material) -> {
            if (name.isBlank()) {
                report.broken(material, "name", "a material's name must not be blank");
            }
            checkText("material name", name, material, report);
        });
    }

    static void checkObjects(List<SceneObject> objects, Map<String, Material> materials, Report report) {
        Set<String> names = new HashSet<>();
        Operations operations = new Operations(materials, report);
        for (SceneObject object : objects) {
            checkName("object", object.name(), object, names, report);
            operations.checkMade(object);
        }
    }

    /** As {@link #checkObjects}, where all objects but those that are added stood in another list, which has been checked with these materials. */
    static void checkChanged(List<SceneObject> before, List<SceneObject> objects, Difference difference, Map<String, Material> materials, Report report) {
        Set<String> free = new HashSet<>();
        for (int i : difference.removed()) {
            free.add(before.get(i).name());
        }
        boolean isRenamed = false;
        Operations operations = new Operations(materials, report);
        for (int i : difference.added()) {
            SceneObject object = objects.get(i);
            checkText("object name", object.name(), object, report);
            operations.checkMade(object);
            isRenamed |= !object.name().isEmpty() && !free.remove(object.name());
        }
        Set<String> names = new HashSet<>();
        for (int i = 0; isRenamed && i < objects.size(); i++) {
            checkUnique("object", objects.get(i).name(), objects.get(i), names, report);
        }
    }

    /** Whether what has been checked with some materials may have others. */
    static boolean allow(Map<String, Material> before, Map<String, Material> materials) {
        return materials.keySet().containsAll(before.keySet()) && materials.entrySet().stream().noneMatch(material ->
                hasBoard(material.getValue()) && !material.getValue().equals(before.get(material.getKey())));
    }

    /**
     * Checks a name, which people read in lists and terminals obey.
     *
     * @param what what it names, for the message
     * @throws IllegalArgumentException if the name is empty, too long, or has a control character or one that changes the direction of writing
     */
    public static void checkName(String what, String name) {
        Objects.requireNonNull(what, "what");
        Require.that(!name.isEmpty() && name.length() <= LONGEST_NAME,
                what + " must have 1 to " + LONGEST_NAME + " characters, but has " + name.length());
        for (int i = 0; i < name.length(); i += Character.charCount(name.codePointAt(i))) {
            int c = name.codePointAt(i);
            // Letters, digits and blanks need no look into the tables.
            if ((c < ' ' || c > '~') && isForbidden(c)) {
                throw new IllegalArgumentException(what + " must not have control characters, but has " + String.format("U+%04X", c));
            }
        }
    }

    private static boolean isForbidden(int c) {
        int type = Character.getType(c);
        return type == Character.CONTROL || type == Character.FORMAT || type == Character.SURROGATE || (c & 0xfffe) == 0xfffe;
    }

    private static void checkText(String what, String name, Object owner, Report report) {
        try {
            if (!name.isEmpty()) {
                checkName(what, name);
            }
        } catch (IllegalArgumentException refused) {
            report.broken(owner, "name", String.valueOf(refused.getMessage()));
        }
    }

    private static void checkName(String kind, String name, Object owner, Set<String> seen, Report report) {
        if (!name.isEmpty()) {
            checkText(kind + " name", name, owner, report);
            checkUnique(kind, name, owner, seen, report);
        }
    }

    private static void checkUnique(String kind, String name, Object owner, Set<String> seen, Report report) {
        if (!name.isEmpty() && !seen.add(name)) {
            report.broken(owner, "name", "there is already " + (kind.startsWith("o") ? "an " : "a ") + kind + " named \"" + name
                    + "\" here; give one of them another name");
        }
    }

    private static boolean hasBoard(Material material) {
        return material.pattern() instanceof Pattern.Checkerboard
                || (!material.shares().isEven() && material.patterns().anyMatch(Pattern.Checkerboard.class::isInstance))
                || (material.relief() instanceof Material.Bump bump && bump.pattern() instanceof Pattern.Checkerboard);
    }

    /** All names of materials that there are. */
    private static Set<String> known(Map<String, Material> own) {
        Set<String> names = new LinkedHashSet<>(own.keySet());
        names.addAll(Material.ready().keySet());
        return names;
    }

    private static void checkMaterial(
            MaterialSource source, Shape shape, Object owner, Map<String, Material> materials, Report report) {
        if (source instanceof MaterialName reference && !materials.containsKey(reference.name()) && !Material.ready().containsKey(reference.name())) {
            report.broken(owner, "material", "there is no material named \"" + reference.name() + "\""
                    + Similar.suggestion(reference.name(), known(materials)));
        }
        Material material = source instanceof MaterialName reference
                ? reference.in(materials)
                : source == Inherited.INHERITED ? Material.DEFAULT : (Material) source;
        if (hasBoard(material) && !(shape instanceof Rectangle || shape instanceof Disc)) {
            report.broken(owner, source instanceof MaterialName ? "material" : "", "a checkerboard lies on a rectangle or a disc only; give this shape a checker");
        }
    }

    /** What is made of others. Each operation is looked at once, however often it stands in others. */
    private static final class Operations {
        private final Map<String, Material> materials;
        private final Report report;
        /** Those that have operations within. */
        private final IdentityHashMap<Csg, Reach> known = new IdentityHashMap<>();

        Operations(Map<String, Material> materials, Report report) {
            this.materials = materials;
            this.report = report;
        }

        void checkMade(SceneObject object) {
            checkMaterial(object.material(), object.shape(), object, materials, report);
            if (object.shape() instanceof Csg csg) {
                Reach own = check(csg, 1);
                Reach all = Reach.NONE.with(object.placement(), own);
                if (all.primitives > Original.MOST) {
                    report.broken(object, "", Original.TOO_MANY);
                } else if (own.height > DEEPEST) {
                    report.broken(object, "", TOO_DEEP);
                } else if (!all.isSane()) {
                    checkPlacements(csg, object.placement().toParent());
                }
                if (own.height > DEEPEST) {
                    // What is deepest was not looked at, and may not be too deep elsewhere.
                    known.clear();
                }
            }
        }

        private Reach check(Csg csg, int level) {
            Reach all = known.get(csg);
            if (level > DEEPEST) {
                return Reach.TOO_DEEP;
            } else if (all == null) {
                all = Reach.NONE;
                Set<String> names = new HashSet<>();
                boolean hasOperations = false;
                for (Operand operand : csg.operands()) {
                    checkName("operand", operand.name(), operand, names, report);
                    checkMaterial(operand.material(), operand.solid(), operand, materials, report);
                    hasOperations |= operand.solid() instanceof Csg;
                    all = all.with(operand.placement(), operand.solid() instanceof Csg inner ? check(inner, level + 1) : Reach.ONE);
                }
                if (hasOperations) {
                    known.put(csg, all);
                }
            }
            return all;
        }

        /** @param toWorld the map from the space of the operation to the world */
        private void checkPlacements(Csg csg, Affine toWorld) {
            for (Operand operand : csg.operands()) {
                Affine inner = toWorld.after(operand.placement().toParent());
                if (!inner.isSane()) {
                    report.broken(operand, "", "the placements of this operand and of what it is in must not make it flat, larger than "
                            + Require.LARGEST + " times its size or smaller than " + Require.SMALLEST + " times, all together");
                } else if (operand.solid() instanceof Csg within) {
                    checkPlacements(within, inner);
                }
            }
        }
    }

    /**
     * How far placements within one another may go together: bounds, so that those that need no closer look are known at once.
     *
     * @param height how deep operations are nested, or more than {@link SceneRules#DEEPEST}
     * @param primitives how many primitives there are, or more than {@link Original#MOST}
     * @param least how small anything is made, at most 1
     * @param most how large, at least 1
     * @param bent how much larger one direction than another, at least 1
     * @param away how far anything is moved
     */
    private record Reach(int height, long primitives, double least, double most, double bent, double away) {
        static final Reach NONE = new Reach(0, 0, 1, 1, 1, 0);
        static final Reach ONE = new Reach(0, 1, 1, 1, 1, 0);
        static final Reach TOO_DEEP = new Reach(DEEPEST + 1, 1, 1, 1, 1, 0);
        private static final double EASY = 1e40;
        /** The volume of a block with edges of length 1 is at least 1 over the square. */
        private static final double EASILY_BENT = 1e5;

        /** With something that is placed besides. */
        Reach with(Placement placement, Reach inner) {
            Vec3 scale = placement.scale();
            double x = Math.abs(scale.x());
            double y = Math.abs(scale.y());
            double z = Math.abs(scale.z());
            double small = Math.min(x, Math.min(y, z));
            double large = Math.max(x, Math.max(y, z));
            return new Reach(Math.max(height, 1 + inner.height), Math.min(Integer.MAX_VALUE, primitives + inner.primitives), Math.min(least, small * inner.least), Math.max(most, large * inner.most),
                    Math.max(bent, large / small * inner.bent), Math.max(away, placement.position().length() + large * inner.away));
        }

        /** Whether each of them is, for sure. */
        boolean isSane() {
            return least >= 1 / EASY && most <= EASY && bent <= EASILY_BENT && away <= EASY;
        }
    }
}
