package cz.paprsek.render.surface;

import cz.paprsek.material.Inherited;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Affine;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Surface;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.IntFunction;

/** The primitives of a scene, numbered as they are placed: for each its geometry, its finish and the object it belongs to. */
public final class PartTable {
    private final Map<String, Material> materials;
    private final BooleanSupplier stop;
    private final Map<String, Finish> named = new HashMap<>();
    /** Of materials without a name. */
    private final Map<Material, Finish> shared = new HashMap<>();
    private final Finish standard = anywhere(Material.DEFAULT);
    private Material lastMaterial = Material.DEFAULT;
    private Finish lastFinish = standard;
    private Part[] parts;
    private Finish[] finishes;
    private int[] objects;
    private int size;

    public PartTable(Scene scene, BooleanSupplier stop) {
        this.stop = stop;
        int expected = Math.max(16, scene.objects().size());
        materials = scene.materials();
        parts = new Part[expected];
        finishes = new Finish[expected];
        objects = new int[expected];
    }

    public int size() {
        return size;
    }

    public Part part(int i) {
        return parts[i];
    }

    public Finish finish(int i) {
        return finishes[i];
    }

    /** The number of the scene's object that the part belongs to. */
    public int object(int i) {
        return objects[i];
    }

    /** The first part of the object that the part belongs to. */
    public int firstOfObject(int i) {
        int first = i;
        while (first > 0 && objects[first - 1] == objects[i]) {
            first--;
        }
        return first;
    }

    /** Places an object and registers its parts. */
    public Surface place(int number, SceneObject object) {
        Affine toWorld = object.placement().toParent();
        return object.shape().place(toWorld, new Scope(number, own(object.material(), toWorld, standard)));
    }

    /** Whether light gets through a shape of some material, or through a part of it. */
    boolean letsLightThrough(MaterialSource material, Shape shape) {
        if (shape instanceof Csg csg) {
            for (Operand operand : csg.operands()) {
                if (letsLightThrough(operand.material() == Inherited.INHERITED ? material : operand.material(), operand.solid())) {
                    return true;
                }
            }
            return false;
        }
        return material != Inherited.INHERITED && material(material).transparency() > 0;
    }

    private Material material(MaterialSource source) {
        return source instanceof MaterialName reference ? materials.getOrDefault(reference.name(), Material.DEFAULT) : (Material) source;
    }

    private Finish own(MaterialSource source, Affine toWorld, Finish inherited) {
        if (source == Inherited.INHERITED) {
            return inherited;
        }
        Material material = material(source);
        if (Paint.isPlaced(material.pattern())) {
            return placed(material, toWorld);
        }
        return source instanceof MaterialName reference ? named.computeIfAbsent(reference.name(), name -> anywhere(material)) : shared(material);
    }

    private static Finish anywhere(Material material) {
        return new Finish(material, Paint.of(material.pattern(), Affine.IDENTITY));
    }

    /** A pattern in space depends on where it is declared; all other finishes are shared. */
    private static Finish placed(Material material, Affine toWorld) {
        return new Finish(material, Paint.of(material.pattern(), toWorld.inverse()));
    }

    /** Neighbours are mostly of one material: that saves hashing it. */
    private Finish shared(Material material) {
        if (!material.equals(lastMaterial)) {
            lastFinish = shared.computeIfAbsent(material, PartTable::anywhere);
            lastMaterial = material;
        }
        return lastFinish;
    }

    private int add(int object, Finish finish) {
        if (size == parts.length) {
            parts = Arrays.copyOf(parts, 2 * size);
            finishes = Arrays.copyOf(finishes, 2 * size);
            objects = Arrays.copyOf(objects, 2 * size);
        }
        objects[size] = object;
        finishes[size] = finish;
        return size++;
    }

    /** What parts registered here belong to, and what they are made of. */
    private final class Scope implements Parts {
        private final int object;
        private final Finish finish;

        Scope(int object, Finish finish) {
            this.object = object;
            this.finish = finish;
        }

        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            int number = PartTable.this.add(object, finish);
            P part = maker.apply(number);
            parts[number] = part;
            return part;
        }

        @Override
        public Parts within(MaterialSource material, Affine toWorld) {
            return new Scope(object, own(material, toWorld, finish));
        }

        @Override
        public boolean isCancelled() {
            return stop.getAsBoolean();
        }
    }
}
