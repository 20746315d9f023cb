package cz.paprsek.shape.copied;

import cz.paprsek.material.MaterialSource;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.placed.Parts;
import java.util.IdentityHashMap;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;

/** The originals of a scene, each placed when it is first asked for. */
public final class Originals {
    private final Repeated repeated;
    private final Predicate<MaterialSource> isEverywhereAlike;
    private final BooleanSupplier stop;
    private final IdentityHashMap<Csg, Original> made;
    private final boolean areAllMade;

    /**
     * None has been placed yet.
     *
     * @param repeated the solids that are to have one
     * @param isEverywhereAlike says of a material whether it does not depend on where it is declared
     * @param stop whether to give up
     */
    public Originals(Repeated repeated, Predicate<MaterialSource> isEverywhereAlike, BooleanSupplier stop) {
        this(repeated, isEverywhereAlike, stop, new IdentityHashMap<>(), false);
    }

    private Originals(Repeated repeated, Predicate<MaterialSource> isEverywhereAlike, BooleanSupplier stop, IdentityHashMap<Csg, Original> made, boolean areAllMade) {
        this.repeated = repeated;
        this.isEverywhereAlike = isEverywhereAlike;
        this.stop = stop;
        this.made = made;
        this.areAllMade = areAllMade;
    }

    /** The same ones for a changed scene, in which they are placed as often as that has them; none is made any more. */
    public Originals in(Repeated changed) {
        return new Originals(changed, isEverywhereAlike, stop, made, true);
    }

    /** The original of a solid; empty if it is to be placed by itself wherever it stands. */
    public Optional<Original> of(Object solid, Parts.Placer alone) {
        if (!(solid instanceof Csg csg) || !repeated.has(csg)) {
            return Optional.empty();
        }
        Csg known = repeated.only(csg);
        Original original = made.get(known);
        if (original == null && !areAllMade) {
            original = new Original(alone, this);
            made.put(known, original);
        }
        return Optional.ofNullable(original);
    }

    boolean isEverywhereAlike(MaterialSource material) {
        return isEverywhereAlike.test(material);
    }

    boolean isCancelled() {
        return stop.getAsBoolean();
    }
}
