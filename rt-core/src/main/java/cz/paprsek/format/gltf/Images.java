package cz.paprsek.format.gltf;

import cz.paprsek.format.model.Notes;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** The pictures of a document: files beside it by their names; those within it by the name of the document, a number and an ending. */
final class Images {
    private final Tree document;
    private final Buffers buffers;
    private final String prefix;
    private final Notes notes;
    private final Map<String, byte[]> within = new HashMap<>();

    /** @param prefix of the names of pictures that are within the document */
    Images(Tree document, Buffers buffers, String prefix, Notes notes) {
        this.document = document;
        this.buffers = buffers;
        this.prefix = prefix;
        this.notes = notes;
    }

    /** Pictures within the document, by the names that materials use. */
    Map<String, byte[]> within() {
        return within;
    }

    Optional<String> ofTexture(int index) throws IOException {
        Tree texture = document.item("textures", index);
        if (!texture.has("source")) {
            notes.add(texture.path(), "a picture of an unknown kind is not read");
            return Optional.empty();
        }
        int source = texture.needed("source");
        Tree image = document.item("images", source);
        String uri = image.text("uri", "");
        if (image.has("uri") && !uri.startsWith("data:")) {
            return Optional.of(Buffers.name(image, uri));
        }
        ByteBuffer bytes = image.has("uri") ? buffers.data(image, uri) : buffers.view(image.needed("bufferView"));
        byte[] copy = new byte[bytes.remaining()];
        bytes.duplicate().get(copy);
        String name = prefix + source + (copy.length > 1 && copy[0] == (byte) 0xFF && copy[1] == (byte) 0xD8 ? ".jpg" : ".png");
        within.put(name, copy);
        return Optional.of(name);
    }
}
