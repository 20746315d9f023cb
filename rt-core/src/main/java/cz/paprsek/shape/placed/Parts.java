package cz.paprsek.shape.placed;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Affine;
import java.util.function.IntFunction;

/** Numbers the primitives of a scene as they are placed, and remembers which object and operand each came from. */
public interface Parts {
    /** For who places a shape without asking later which part was hit: all have the number 0. */
    Parts UNTOLD = new Parts() {
        @Override
        public <P extends Part> P add(IntFunction<P> maker) {
            return maker.apply(0);
        }

        @Override
        public Parts within(MaterialSource material, Affine toWorld) {
            return this;
        }
    };

    /** Registers the part that {@code maker} makes for its number. */
    <P extends Part> P add(IntFunction<P> maker);

    /** Where the parts of an operand of the given material are to be registered. */
    Parts within(MaterialSource material, Affine toWorld);

    /**
     * Where the parts are to be registered that have a material of their own unless the scene has given one.
     *
     * @param isTinted whether the colour of the material depends on the {@linkplain Part#tint part}, too
     */
    default Parts unlessGiven(Material material, Affine toWorld, boolean isTinted) {
        return this;
    }

    /** How a solid is placed, for one place alone. */
    @FunctionalInterface
    interface Placer {
        Volume place(Affine toWorld, Parts parts);
    }

    /** Places a solid that may stand in many places: as a copy, if it has been placed once for all of them, else for this one alone. */
    default Volume placed(Object solid, Placer alone, Affine toWorld) {
        return alone.place(toWorld, this);
    }

    /** Whether to give up; asked while many operands are placed. */
    default boolean isCancelled() {
        return false;
    }
}
