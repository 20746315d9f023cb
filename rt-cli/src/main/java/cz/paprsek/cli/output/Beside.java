package cz.paprsek.cli.output;

import cz.paprsek.cli.input.SceneReading;
import cz.paprsek.format.MeshWriter;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.shape.mesh.Triangles;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;

/** What a scene that was made of another program's file needs beside its own. */
public final class Beside {
    private Beside() {}

    /**
     * Writes the meshes that lie in no file yet, and takes the file along if the scene goes to another folder; what lies beside that file is for its owner to copy.
     *
     * @param scene the file of the scene
     */
    public static void write(SceneReading reading, Path scene) throws IOException {
        if (reading.foreign().isEmpty()) {
            return;
        }
        for (Map.Entry<String, Triangles> mesh : reading.foreign().get().meshes().entrySet()) {
            AtomicFile.write(scene.resolveSibling(mesh.getKey()), out -> MeshWriter.obj(mesh.getValue(), out));
        }
        Path model = reading.file();
        Optional<Path> copy = Optional.ofNullable(model.getFileName()).map(scene::resolveSibling);
        if (reading.foreign().get().triangles().isPresent() && copy.isPresent() && !(Files.exists(copy.get()) && Files.isSameFile(copy.get(), model))) {
            AtomicFile.write(copy.get(), out -> Files.copy(model, out));
        }
    }
}
