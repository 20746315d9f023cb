package cz.paprsek.shape.copied;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.math.Affine;
import cz.paprsek.shape.placed.Part;
import cz.paprsek.shape.placed.Parts;
import cz.paprsek.shape.placed.Volume;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;

/**
 * A solid that is placed once, in its own space, for all the places in which it stands. What its parts are made of may depend on the place: so they
 * have scopes, which each place has to give a meaning. Immutable.
 */
public final class Original {
    /** Numbers of neighbouring parts differ by 2 to this power. */
    public static final int BITS = 4;
    /** How many parts there may be; behind them come the lights that are seen. */
    public static final int MOST = (1 << (31 - BITS)) - 1024;
    /** What is said of a scene with more of them. */
    public static final String TOO_MANY = "the scene has more than " + MOST + " primitives in all places together";

    private final Originals others;
    private final Volume whole;
    /** By slot: the parts, and their scopes, in the end as places among those that are used. */
    private Part[] parts = new Part[16];
    private int[] partScopes = new int[16];
    private int slots;
    private int count;
    private final Runs runs = new Runs();
    private final List<Given> scopes = new ArrayList<>();
    /** The scopes that parts have, in the order of the first of these. */
    private final int[] used;

    Original(Parts.Placer alone, Originals others) {
        this.others = others;
        Scope around = new Scope(0);
        scopes.add(new Given(0, Inherited.INHERITED, Affine.IDENTITY, false, false));
        whole = alone.place(Affine.IDENTITY, around);
        parts = Arrays.copyOf(parts, slots);
        used = Arrays.stream(partScopes, 0, slots).distinct().toArray();
        int[] places = new int[scopes.size()];
        for (int i = 0; i < used.length; i++) {
            places[used[i]] = i;
        }
        partScopes = Arrays.stream(partScopes, 0, slots).map(scope -> places[scope]).toArray();
    }

    /**
     * What a scope is within another.
     *
     * @param onlyIfNone whether it counts where the scene has not given a material
     */
    private record Given(int around, MaterialSource material, Affine at, boolean onlyIfNone, boolean isTinted) {
        Parts in(Parts here, Affine toWorld) {
            return onlyIfNone ? here.unlessGiven((Material) material, toWorld.after(at), isTinted) : here.within(material, toWorld.after(at));
        }
    }

    /**
     * How many parts there are with some more.
     *
     * @throws IllegalArgumentException if that is more than {@value #MOST}
     */
    public static int sum(int parts, long more) {
        if (more > MOST - parts) {
            throw new IllegalArgumentException(TOO_MANY);
        }
        return (int) (parts + more);
    }

    Volume whole() {
        return whole;
    }

    /** How many parts it has. */
    public int count() {
        return count;
    }

    /** How many scopes its parts have. */
    public int scopes() {
        return used.length;
    }

    /** The scope of a part, by its place: a place among those that {@link #scopesIn} tells. */
    int scope(int place) {
        return partScopes[runs.slot(place)];
    }

    Part part(int place, CopiedPart scratch) {
        return runs.part(place, parts, scratch);
    }

    boolean hasCopies() {
        return runs.size() > 0;
    }

    int lastNumber() {
        return (count - 1) << BITS;
    }

    /** How many things it keeps: for tests, which count what is placed. */
    int kept() {
        return slots;
    }

    /** Makes a copy, whose parts have numbers from {@code first} on. */
    public Copy copy(Affine toWorld, int first) {
        return new Copy(this, toWorld, first);
    }

    /** What the scopes of a copy's parts mean, in the order of the first part of each. */
    public List<Parts> scopesIn(Parts around, Affine toWorld) {
        List<Parts> meant = new ArrayList<>(scopes.size());
        meant.add(around);
        for (Given scope : scopes.subList(1, scopes.size())) {
            meant.add(scope.in(meant.get(scope.around), toWorld));
        }
        return Arrays.stream(used).mapToObj(meant::get).toList();
    }

    private void keep(int scope) {
        if (slots == parts.length) {
            parts = Arrays.copyOf(parts, 2 * slots);
            partScopes = Arrays.copyOf(partScopes, 2 * slots);
        }
        partScopes[slots++] = scope;
    }

    /** Where parts are registered while it is placed. */
    private final class Scope implements Parts {
        private final int number;
        /** Of materials that are the same wherever they are declared. */
        private final Map<MaterialSource, Scope> anywhere = new HashMap<>();
        private final Map<MaterialSource, Scope> anywhereIfNone = new HashMap<>();

        Scope(int number) {
            this.number = number;
        }

        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            P part = maker.apply(count << BITS);
            count = sum(count, 1);
            keep(number);
            parts[slots - 1] = part;
            return part;
        }

        @Override
        public Parts within(MaterialSource material, Affine toWorld) {
            return material == Inherited.INHERITED ? this : others.isEverywhereAlike(material)
                    ? anywhere.computeIfAbsent(material, one -> scope(new Given(number, one, Affine.IDENTITY, false, false)))
                    : scope(new Given(number, material, toWorld, false, false));
        }

        @Override
        public Parts unlessGiven(Material material, Affine toWorld, boolean isTinted) {
            return !isTinted && others.isEverywhereAlike(material)
                    ? anywhereIfNone.computeIfAbsent(material, one -> scope(new Given(number, one, Affine.IDENTITY, true, false)))
                    : scope(new Given(number, material, toWorld, true, isTinted));
        }

        private Scope scope(Given given) {
            scopes.add(given);
            return new Scope(scopes.size() - 1);
        }

        @Override
        public Volume placed(Object solid, Placer alone, Affine toWorld) {
            return others.of(solid, alone).<Volume>map(original -> {
                Copy copy = original.copy(toWorld, count << BITS);
                runs.add(count, slots, copy);
                original.scopesIn(this, toWorld).forEach(scope -> keep(((Scope) scope).number));
                count = sum(count, original.count());
                return copy;
            }).orElseGet(() -> alone.place(toWorld, this));
        }

        @Override
        public boolean isCancelled() {
            return others.isCancelled();
        }
    }
}
