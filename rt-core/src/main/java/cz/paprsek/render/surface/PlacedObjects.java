package cz.paprsek.render.surface;

import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.placed.Nothing;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.tree.TreeBuilder;
import java.util.function.BooleanSupplier;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;

/** What is known of objects that have been placed together. Immutable once they are. */
final class PlacedObjects {
    /** Of what lies in one place the lowest part is met first: other things lie on bodies of glass, never a hair's breadth in them. */
    static final boolean[] MEDIA_LAST = {false, true};

    /** The number of the first of them; the others follow. */
    final int from;
    final Surface[] surfaces;
    /** Of each whether no light gets through it, and whether it has an inside. */
    final boolean[] opaque;
    final boolean[] solid;
    /** What the inside takes of light: nothing in place of null. */
    final @Nullable Absorption[] absorbing;
    /** The number of the first part of each. */
    final int[] firsts;
    boolean absorb;

    PlacedObjects(int from, int count) {
        this.from = from;
        this.surfaces = new Surface[count];
        this.opaque = new boolean[count];
        this.solid = new boolean[count];
        this.absorbing = new Absorption[count];
        this.firsts = new int[count];
    }

    /** The number that the first part of an object gets. */
    @FunctionalInterface
    interface Numbers {
        int first(int object, boolean isMedium);
    }

    void place(Placing placing, IntFunction<SceneObject> objects, Numbers numbers, BooleanSupplier stop) {
        for (boolean media : MEDIA_LAST) {
            for (int i = 0; i < surfaces.length; i++) {
                TreeBuilder.stopIfAsked(i, stop);
                SceneObject object = objects.apply(i);
                if (placing.isMedium(object) == media) {
                    firsts[i] = numbers.first(i, media);
                    int place = placing.size;
                    Surface whole = placing.place(from + i, object, firsts[i]);
                    surfaces[i] = object.hidden() ? Nothing.NOTHING : whole;
                    opaque[i] = placing.isOpaque(place);
                    solid[i] = object.shape().hasInside();
                    absorbing[i] = solid[i] ? placing.absorbing(place) : null;
                    absorb |= absorbing[i] != null;
                }
            }
        }
    }

    boolean isMedium(int i) {
        return !opaque[i] && solid[i];
    }
}
