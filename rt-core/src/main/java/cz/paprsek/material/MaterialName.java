package cz.paprsek.material;

import cz.paprsek.math.Require;

/** A reference to one of the scene's named materials. */
public record MaterialName(String name) implements MaterialSource {
    public MaterialName {
        Require.that(!name.isBlank(), "a material's name must not be blank");
    }
}
