package cz.paprsek.format.gltf;

import cz.paprsek.format.model.Companions;
import cz.paprsek.format.model.FormatFault;
import java.io.IOException;
import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** The bytes of a document, wherever they are: within it, in the same file, or in files beside it. Each is read once, when it is needed. */
final class Buffers {
    private final Tree document;
    private final Optional<ByteBuffer> chunk;
    private final Companions companions;
    private final Map<Integer, ByteBuffer> known = new HashMap<>();

    /** @param chunk the bytes that come with the document in one file */
    Buffers(Tree document, Optional<ByteBuffer> chunk, Companions companions) {
        this.document = document;
        this.chunk = chunk;
        this.companions = companions;
    }

    private ByteBuffer buffer(int index) throws IOException {
        ByteBuffer ready = known.get(index);
        if (ready == null) {
            Tree buffer = document.item("buffers", index);
            int length = buffer.needed("byteLength");
            if (!buffer.has("uri") && (index > 0 || chunk.isEmpty())) {
                throw buffer.fault("this has no uri, and there are no bytes in this file");
            }
            ByteBuffer all = buffer.has("uri") ? data(buffer, buffer.text("uri", "")) : chunk.orElseThrow();
            if (all.remaining() < length) {
                throw buffer.fault("byteLength", "these are to be " + length + " bytes, but are " + all.remaining());
            }
            ready = all.slice(0, length);
            known.put(index, ready);
        }
        return ready;
    }

    /** What an address means: the bytes themselves, or a file beside the document. */
    ByteBuffer data(Tree owner, String uri) throws IOException {
        if (uri.startsWith("data:")) {
            int comma = uri.indexOf(',');
            if (!isBase64(uri)) {
                throw owner.fault("uri", "data must be in base64");
            }
            try {
                return ByteBuffer.wrap(Base64.getDecoder().decode(uri.substring(comma + 1)));
            } catch (IllegalArgumentException broken) {
                throw owner.fault("uri", "this is not base64");
            }
        }
        return beside(owner, name(owner, uri));
    }

    private static boolean isBase64(String uri) {
        int comma = uri.indexOf(',');
        return comma >= 0 && uri.substring(0, comma).endsWith(";base64");
    }

    /** The name of a picture beside the document as it is found. */
    String picture(String name) {
        return companions.picture(name);
    }

    /** A file beside the document. */
    ByteBuffer beside(Tree owner, String name) throws IOException {
        try {
            return companions.bytes(name).duplicate();
        } catch (FormatFault own) {
            throw own;
        } catch (IOException unreadable) {
            throw owner.fault("uri", String.valueOf(unreadable.getMessage()));
        }
    }

    /** The name of the file that an address means. */
    static String name(Tree owner, String uri) throws FormatFault {
        try {
            return URLDecoder.decode(uri.replace("+", "%2B"), StandardCharsets.UTF_8);
        } catch (IllegalArgumentException broken) {
            throw owner.fault("uri", "after % must be two hexadecimal digits");
        }
    }

    /** The bytes of a view. */
    ByteBuffer view(int index) throws IOException {
        Tree view = document.item("bufferViews", index);
        ByteBuffer buffer = buffer(view.needed("buffer"));
        long offset = view.whole("byteOffset", 0);
        long length = view.needed("byteLength");
        if (offset + length > buffer.capacity()) {
            throw view.fault("this reaches to byte " + (offset + length) + ", but the buffer has " + buffer.capacity());
        }
        return buffer.slice((int) offset, (int) length).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Whether somebody says where its bytes are; a document may leave that to others. */
    boolean isGiven(int index) throws IOException {
        return document.item("buffers", index).has("uri") || (index == 0 && chunk.isPresent());
    }

    /** Whether a buffer can be read; of data in another form than ours that is asked when they are needed. */
    void check(int index) throws IOException {
        String uri = document.item("buffers", index).text("uri", "");
        if (isGiven(index) && (!uri.startsWith("data:") || isBase64(uri))) {
            buffer(index);
        }
    }

    /** Whether a view lies within its buffer, as far as that is known; and whether its bytes are. */
    boolean isKnown(int view) throws IOException {
        Tree tree = document.item("bufferViews", view);
        int index = tree.needed("buffer");
        long end = (long) tree.whole("byteOffset", 0) + tree.needed("byteLength");
        long length = document.item("buffers", index).needed("byteLength");
        if (end > length) {
            throw tree.fault("this reaches to byte " + end + ", but the buffer has " + length);
        }
        return isGiven(index);
    }

    /** Where in its buffer a view begins, in bytes. */
    int offset(int view) throws IOException {
        return document.item("bufferViews", view).whole("byteOffset", 0);
    }

    /** From one element of a view to the next, in bytes; 0 if they are side by side. */
    int stride(int index) throws IOException {
        return document.item("bufferViews", index).whole("byteStride", 0);
    }
}
