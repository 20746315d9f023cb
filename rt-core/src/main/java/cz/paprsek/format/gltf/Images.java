package cz.paprsek.format.gltf;

import cz.paprsek.format.model.Notes;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.io.Failures;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * The pictures of a document: files beside it by their names; those within it by the name of the document, a number and an ending; and those that are made of them, where one of
 * ours stands for several of theirs.
 */
final class Images {
    private final Tree document;
    private final Buffers buffers;
    private final String prefix;
    private final Notes notes;
    private final Map<String, byte[]> within = new HashMap<>();
    /** Of pictures within the document, by their numbers. */
    private final Map<Integer, String> names = new HashMap<>();

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

    /** The name of a texture's picture. */
    Optional<String> ofTexture(Tree texture) throws IOException {
        if (!texture.has("source")) {
            notes.add(texture.path(), "a picture of an unknown kind is not read");
            return Optional.empty();
        }
        int source = texture.needed("source");
        Tree image = document.item("images", source);
        String known = names.get(source);
        if (known != null) {
            return Optional.of(known);
        }
        String uri = image.text("uri", "");
        if (image.has("uri") && !uri.startsWith("data:")) {
            return Optional.of(buffers.picture(Buffers.name(image, uri)));
        }
        byte[] copy = copy(image.has("uri") ? buffers.data(image, uri) : buffers.view(image.needed("bufferView")));
        String name = prefix + source + (copy.length > 1 && copy[0] == (byte) 0xFF && copy[1] == (byte) 0xD8 ? ".jpg" : ".png");
        within.put(name, copy);
        names.put(source, name);
        return Optional.of(name);
    }

    private static byte[] copy(ByteBuffer bytes) {
        byte[] copy = new byte[bytes.remaining()];
        bytes.duplicate().get(copy);
        return copy;
    }

    /** A picture as it is to be looked at here, with opacity if that is wanted. */
    Image decoded(Tree texture, String name, boolean withOpacity) throws IOException {
        byte[] own = within.get(name);
        byte[] content = own == null ? copy(buffers.beside(texture, name)) : own;
        try {
            return (withOpacity ? ImageFiles.readWithOpacity(content, name) : ImageFiles.readStored(content, name)).image();
        } catch (IOException broken) {
            throw texture.fault("the picture " + name + ": " + Failures.sentence(broken));
        }
    }

    /** Takes in a picture that was made of others, and gives its name. */
    String made(String what, Image image) throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ImageFiles.write(image, file, ImageFormat.PNG);
        String name = prefix + what + ".png";
        within.put(name, file.toByteArray());
        return name;
    }
}
