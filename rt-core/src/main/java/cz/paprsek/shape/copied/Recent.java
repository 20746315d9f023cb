package cz.paprsek.shape.copied;

import cz.paprsek.shape.Csg;
import org.jspecify.annotations.Nullable;

/** Remembers operations for whoever makes many: copies of one that was made not long ago are it, and need no room. To ask costs next to nothing where all differ. */
public final class Recent {
    private static final int ROOM = 1 << 12;

    private final @Nullable Csg[] some = new Csg[ROOM];

    /** One that is equal in all it says, if one is remembered, or else itself. */
    public Csg only(Csg csg) {
        int at = Alike.quick(csg) & ROOM - 1;
        Csg known = some[at];
        if (known != null && known.equals(csg)) {
            return known;
        }
        some[at] = csg;
        return csg;
    }
}
