package cz.paprsek.fx.model.file;

import cz.paprsek.asset.Assets;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/** The pictures that a scene names, on their way to another folder. */
final class Companions {
    private Companions() {}

    /**
     * Copies all pictures of a scene to where it is to be kept, unless they are there. What is missing already stays missing.
     *
     * @throws IOException if there is another file of the same name there, before anything is copied; or a picture cannot be written
     */
    static Assets taken(Scene scene, Assets from, SceneSource to) throws IOException {
        Assets there = Assets.beside(to.file());
        Map<Path, ByteBuffer> copies = new LinkedHashMap<>();
        for (String name : scene.files()) {
            ByteBuffer content;
            try {
                content = from.bytes(name);
            } catch (IOException missing) {
                continue;
            }
            Path copy = to.file().toAbsolutePath().resolveSibling(name);
            if (!Files.exists(copy)) {
                copies.put(copy, content);
            } else if (!there.bytes(name).equals(content)) {
                throw new IOException("there is another picture " + name + " beside it; give one of them another name");
            }
        }
        for (Map.Entry<Path, ByteBuffer> copy : copies.entrySet()) {
            Files.createDirectories(copy.getKey().getParent());
            byte[] content = new byte[copy.getValue().remaining()];
            copy.getValue().get(content);
            AtomicFile.write(copy.getKey(), out -> out.write(content));
        }
        return there;
    }
}
