package cz.paprsek.format.gltf;

import cz.paprsek.format.model.Notes;
import cz.paprsek.material.Pattern;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/**
 * A picture in one of the places that a material has for them.
 *
 * @param texture what the document says of it
 * @param file its name, as materials are to have it
 * @param mapping where places in it come from
 */
record Slot(Tree texture, String file, Pattern.Filter filter, Mapping mapping) {
    private static final int NEAREST = 9728;
    private static final int REPEAT = 10497;
    private static final List<String> WRAPS = List.of("wrapS", "wrapT");

    /**
     * What is in a place; nothing if it is empty, or holds a picture of an unknown kind.
     *
     * @param name of the place, as in {@code baseColorTexture}
     */
    static Optional<Slot> of(Tree owner, String name, Tree document, Images images, Notes notes) throws IOException {
        Optional<Tree> info = owner.child(name);
        if (info.isEmpty()) {
            return Optional.empty();
        }
        Tree texture = document.item("textures", info.get().needed("index"));
        Optional<Tree> sampler = texture.has("sampler") ? Optional.of(document.item("samplers", texture.needed("sampler"))) : Optional.empty();
        for (String wrap : WRAPS) {
            if (sampler.isPresent() && sampler.get().whole(wrap, REPEAT) != REPEAT) {
                notes.add(sampler.get().path(), "pictures repeat beyond their edges, whatever is wanted");
            }
        }
        boolean isNearest = sampler.isPresent() && sampler.get().whole("magFilter", 0) == NEAREST;
        Optional<String> file = images.ofTexture(texture);
        return file.isEmpty() ? Optional.empty() : Optional.of(new Slot(texture, file.get(), isNearest ? Pattern.Filter.NEAREST : Pattern.Filter.SMOOTH, Mapping.of(info.get())));
    }

    /** With another picture, made of this one. */
    Slot with(String made) {
        return new Slot(texture, made, filter, mapping);
    }
}
