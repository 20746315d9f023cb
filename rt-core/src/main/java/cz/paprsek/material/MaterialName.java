package cz.paprsek.material;

import cz.paprsek.math.Require;
import java.util.Map;

/** A reference to one of the scene's named materials, or to one that {@linkplain Material#ready every scene} knows. */
public record MaterialName(String name) implements MaterialSource {
    public MaterialName {
        Require.that(!name.isBlank(), "a material's name must not be blank");
    }

    /**
     * What a scene means by it.
     *
     * @param own the scene's own materials
     * @return {@link Material#DEFAULT} if there is none of that name
     */
    public Material in(Map<String, Material> own) {
        Material material = own.get(name);
        return material != null ? material : Material.ready().getOrDefault(name, Material.DEFAULT);
    }
}
