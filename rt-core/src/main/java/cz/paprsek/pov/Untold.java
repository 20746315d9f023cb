package cz.paprsek.pov;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Material;
import java.util.List;
import java.util.Set;

/** What a scene says that no word is found for: so that an attribute which comes later is not lost without a word. */
final class Untold {
    /** Of a material, what {@link PovMaterials} finds words for. */
    private static final Set<String> OF_MATERIALS = Set.of("color", "diffusion", "specular", "shininess", "reflection", "transparency", "refractive-index");

    private Untold() {}

    /** The names of a material's attributes that are not as by default, and that POV-Ray is not told. */
    static List<String> of(Material material) {
        return Described.inline(Material.class).stream()
                .filter(one -> !OF_MATERIALS.contains(one.name()) && one.isOf(material) && !one.value(material).equals(one.value(Material.DEFAULT)))
                .map(Described::name).toList();
    }
}
