package cz.paprsek.pov;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Material;
import java.util.List;

/** What a scene says that no word is found for: so that an attribute which comes later is not lost without a word. */
final class Untold {
    private Untold() {}

    /** The names of a material's attributes that are not as by default, and that POV-Ray is not told. */
    static List<String> of(Material material) {
        return Described.inline(Material.class).stream()
                .filter(one -> !PovMaterials.TOLD.contains(one.name()) && one.isOf(material) && !one.value(material).equals(one.value(Material.DEFAULT)))
                .map(Described::name).toList();
    }
}
