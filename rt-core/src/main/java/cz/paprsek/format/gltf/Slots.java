package cz.paprsek.format.gltf;

import cz.paprsek.format.model.Notes;
import cz.paprsek.material.Pattern;
import java.io.IOException;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The pictures of a material.
 *
 * @param color of the colour; its opacity counts if the material is to be seen through
 * @param metal blue says how far it conducts, green how rough it is
 * @param normal of bumps
 * @param transmission red says how much is let through
 * @param emission of its own light
 */
record Slots(Optional<Slot> color, Optional<Slot> metal, Optional<Slot> normal, Optional<Slot> transmission, Optional<Slot> emission) {

    static Slots of(Tree material, Tree document, Images images, Notes notes) throws IOException {
        Tree pbr = material.childOrNothing("pbrMetallicRoughness");
        Tree through = material.extension("KHR_materials_transmission").orElse(Tree.NOTHING);
        if (material.has("occlusionTexture")) {
            notes.add(material.path(), "occlusionTexture is not read: what is hidden from light, rays find out");
        }
        return new Slots(Slot.of(pbr, "baseColorTexture", document, images, notes), Slot.of(pbr, "metallicRoughnessTexture", document, images, notes),
                Slot.of(material, "normalTexture", document, images, notes), Slot.of(through, "transmissionTexture", document, images, notes),
                Slot.of(material, "emissiveTexture", document, images, notes));
    }

    /** That of the places that vertices are to have: of the first picture there is, the colour's before all others. */
    Mapping mapping() {
        return Stream.of(color, metal, transmission, normal).flatMap(Optional::stream).findFirst().map(Slot::mapping).orElse(Mapping.PLAIN);
    }

    /** How a picture lies where the vertices have these places. */
    Pattern.Lay lay(Slot slot, Notes notes) {
        Optional<Pattern.Lay> lay = slot.mapping().within(mapping());
        if (lay.isEmpty()) {
            notes.add(slot.texture().path(), "a picture lies as that of the colour does, though it is to be turned against it or to take another set of places");
        }
        return lay.orElse(Pattern.Lay.NONE);
    }

    Pattern.Picture picture(Slot slot, Notes notes) {
        return new Pattern.Picture(slot.file(), slot.filter(), Pattern.Mapping.UV, lay(slot, notes));
    }
}
