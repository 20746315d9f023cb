package cz.paprsek.render.surface;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.math.Affine;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.copied.Copy;
import cz.paprsek.shape.copied.Original;
import cz.paprsek.shape.copied.Originals;
import cz.paprsek.shape.copied.Repeated;
import cz.paprsek.shape.copied.Runs;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.shape.placed.Volume;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;

/** Objects on their way into the world, one after the other: each of their primitives gets a number, a finish and a place in the table of parts. */
final class Placing {
    /** So many materials without a name are told by which they are: Java takes a sixteenth of a second until it can compare two. */
    private static final int FEW = 64;
    /** So many are looked for among those that come: where each body has its own, to keep all takes longer than to make them. */
    private static final int MANY = 4096;

    private final Map<String, Material> materials;
    private final Textures textures;
    private final BooleanSupplier stop;
    private final Map<String, Finish> named = new HashMap<>();
    /** Of the first materials without a name. */
    private final IdentityHashMap<Material, Finish> first = new IdentityHashMap<>();
    /** Of those behind them. */
    private final Map<Material, Finish> shared = new HashMap<>();
    private final Finish standard;
    private Material lastMaterial = Material.DEFAULT;
    private Finish lastFinish;
    Part[] parts;
    Finish[] finishes;
    int[] objects;
    /** Unless numbers follow from places: those of what has been placed, a part or a copy, and their places. */
    int[] numbers = {};
    int[] starts = {};
    int count;
    int size;
    /** How many places parts have taken, of which those of a copy share what is kept. */
    int places;
    final Runs runs = new Runs();
    final Originals originals;
    /** The number of the last part. */
    int last;
    /** Whether a part is rough. */
    boolean isRough;
    /** Whether a part has a picture, or is not even. */
    boolean hasPictures;
    private final boolean areLater;
    /** The number of the next part. */
    private int next;
    /** What numbers must stay below, by object from the first of these on; empty for whatever comes. */
    private int[] limits = {};
    private int limited;
    /** Whether they do. */
    boolean isInRoom = true;

    /**
     * @param expected about how many parts there will be
     * @param repeated the solids that are placed once
     */
    Placing(Scene scene, Textures textures, int expected, Repeated repeated, BooleanSupplier stop) {
        this(scene, textures, expected, false, stop, materials -> new Originals(repeated, source -> !Finish.isPlaced(material(source, materials)), stop));
    }

    /**
     * For what comes between others.
     *
     * @param made what has been placed once with those
     */
    static Placing later(Scene scene, Textures textures, int expected, Originals made, BooleanSupplier stop) {
        return new Placing(scene, textures, expected, true, stop, materials -> made);
    }

    private Placing(Scene scene, Textures textures, int expected, boolean areLater, BooleanSupplier stop, Function<Map<String, Material>, Originals> originals) {
        this.textures = textures;
        this.stop = stop;
        materials = scene.materials();
        standard = anywhere(Material.DEFAULT);
        lastFinish = standard;
        parts = new Part[expected];
        finishes = new Finish[expected];
        objects = new int[expected];
        this.areLater = areLater;
        this.originals = originals.apply(materials);
    }

    /** Looks whether numbers stay below those given, of objects from {@code first} on. */
    void keepBelow(int[] most, int first) {
        limits = most;
        limited = first;
    }

    /** Leaves places for which there are no parts. */
    void leaveRoom(int count) {
        reserve(size + count);
        Arrays.fill(objects, size, size + count, -1);
        size += count;
        takePlaces(count);
    }

    private void takePlaces(int count) {
        places = Original.sum(places, count);
    }

    /**
     * Places an object and registers its parts.
     *
     * @param first the number of its first part
     */
    Surface place(int number, SceneObject object, int first) {
        next = first;
        Affine toWorld = object.placement().toParent();
        return object.shape().place(toWorld, new Scope(number, own(object.material(), toWorld, standard), object.material() != Inherited.INHERITED));
    }

    /** Whether no light gets through any part from the {@code from}-th that was registered on. */
    boolean isOpaque(int from) {
        for (int i = from; i < size; i++) {
            if (finishes[i].transparency > 0) {
                return false;
            }
        }
        return true;
    }

    /** Whether light gets through a solid, or through a part of it. */
    boolean isMedium(SceneObject object) {
        return object.shape().hasInside() && letsLightThrough(object.material(), object.shape());
    }

    private boolean letsLightThrough(MaterialSource material, Shape shape) {
        if (shape instanceof Csg csg) {
            for (Operand operand : csg.operands()) {
                if (letsLightThrough(operand.material() == Inherited.INHERITED ? material : operand.material(), operand.solid())) {
                    return true;
                }
            }
            return false;
        }
        if (material == Inherited.INHERITED) {
            return shape instanceof Mesh mesh && mesh.materials().stream().anyMatch(own -> own.transparency() > 0);
        }
        return material(material).transparency() > 0;
    }

    /** What the inside takes of the parts from the {@code from}-th that was registered on: one body has one, that of its first part which light gets through. */
    @Nullable Absorption absorbing(int from) {
        for (int i = from; i < size; i++) {
            if (finishes[i].transparency > 0 && !finishes[i].isThin) {
                Absorption inside = new Absorption(finishes[i].material);
                return inside.isAny() ? inside : null;
            }
        }
        return null;
    }

    private Material material(MaterialSource source) {
        return material(source, materials);
    }

    private static Material material(MaterialSource source, Map<String, Material> materials) {
        return source instanceof MaterialName reference ? reference.in(materials) : (Material) source;
    }

    private Finish own(MaterialSource source, Affine toWorld, Finish inherited) {
        if (source == Inherited.INHERITED) {
            return inherited;
        }
        Material material = material(source);
        if (Finish.isPlaced(material)) {
            return placed(material, toWorld);
        }
        return source instanceof MaterialName reference ? named.computeIfAbsent(reference.name(), name -> anywhere(material)) : shared(material);
    }

    private Finish anywhere(Material material) {
        return new Finish(material, Affine.IDENTITY, textures);
    }

    /** A pattern in space depends on where it is declared; all other finishes are shared. */
    private Finish placed(Material material, Affine toWorld) {
        return new Finish(material, toWorld.inverse(), textures);
    }

    private Finish tinted(Material material, Affine toWorld) {
        return new Finish(material, toWorld.inverse(), textures, true);
    }

    /** Neighbours are mostly of one material: that saves looking for it. */
    @SuppressWarnings("ReferenceEquality")
    private Finish shared(Material material) {
        if (material != lastMaterial) {
            Finish known = first.get(material);
            lastFinish = known != null ? known : first.size() < FEW ? first.computeIfAbsent(material, this::anywhere) : equal(material);
            lastMaterial = material;
        }
        return lastFinish;
    }

    private Finish equal(Material material) {
        if (shared.size() < MANY) {
            return shared.computeIfAbsent(material, this::anywhere);
        }
        Finish known = shared.get(material);
        return known == null ? anywhere(material) : known;
    }

    private int add(int object, Finish finish) {
        reserve(size + 1);
        isRough |= finish.alpha > 0;
        objects[size] = object;
        finishes[size] = finish;
        hasPictures |= finish.asksForPlace();
        return size++;
    }

    private void reserve(int places) {
        if (places > parts.length) {
            int length = Math.max(places, 2 * parts.length);
            parts = Arrays.copyOf(parts, length);
            finishes = Arrays.copyOf(finishes, length);
            objects = Arrays.copyOf(objects, length);
        }
    }

    /** Notes the number of what takes the next place, with its last part's, and says which comes after that. */
    private int numbered(int object, int number, int lastOfIt, int placesThen) {
        last = lastOfIt;
        if (!areLater) {
            return PartTable.number(placesThen);
        }
        if (count == numbers.length) {
            numbers = Arrays.copyOf(numbers, Math.max(16, 2 * count));
            starts = Arrays.copyOf(starts, numbers.length);
        }
        numbers[count] = number;
        starts[count++] = places;
        isInRoom &= last >= number && (limits.length == 0 || last < limits[object - limited]);
        return PartTable.after(last);
    }

    /** What parts registered here belong to, and what they are made of. */
    private final class Scope implements Parts {
        private final int object;
        private final Finish finish;
        private final boolean given;

        Scope(int object, Finish finish, boolean given) {
            this.object = object;
            this.finish = finish;
            this.given = given;
        }

        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            int slot = Placing.this.add(object, finish);
            P part = maker.apply(next);
            parts[slot] = part;
            next = numbered(object, next, next, places + 1);
            takePlaces(1);
            return part;
        }

        @Override
        public Volume placed(Object solid, Placer alone, Affine toWorld) {
            return originals.of(solid, alone).<Volume>map(original -> {
                Copy copy = original.copy(toWorld, next);
                runs.add(places, size, copy);
                original.scopesIn(this, toWorld).forEach(scope -> Placing.this.add(object, ((Scope) scope).finish));
                int then = Original.sum(places, original.count());
                next = numbered(object, next, next + PartTable.number(original.count() - 1), then);
                places = then;
                return copy;
            }).orElseGet(() -> alone.place(toWorld, this));
        }

        @Override
        public Parts within(MaterialSource material, Affine toWorld) {
            return new Scope(object, own(material, toWorld, finish), given || material != Inherited.INHERITED);
        }

        @Override
        public Parts unlessGiven(Material material, Affine toWorld, boolean isTinted) {
            return given ? this : new Scope(object, isTinted ? tinted(material, toWorld) : own(material, toWorld, finish), true);
        }

        @Override
        public boolean isCancelled() {
            return stop.getAsBoolean();
        }
    }
}
