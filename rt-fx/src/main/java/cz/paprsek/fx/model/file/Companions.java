package cz.paprsek.fx.model.file;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.ForeignFormat;
import cz.paprsek.format.MeshFiles;
import cz.paprsek.format.MeshWriter;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Mesh;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** The pictures and meshes that a scene names, on their way to another folder. */
final class Companions {
    private Companions() {}

    /**
     * Copies all pictures and meshes of a scene to where it is to be kept, unless they are there. What is missing already stays missing.
     *
     * @throws IOException if there is another file of the same name there, before anything is copied; or a picture cannot be written
     */
    static Assets taken(Scene scene, Assets from, SceneSource to) throws IOException {
        Assets there = Assets.beside(to.file());
        Map<Path, ByteBuffer> copies = new LinkedHashMap<>();
        Set<String> names = new LinkedHashSet<>(scene.files());
        Map<String, Mesh> meshes = meshes(scene);
        names.addAll(meshes.keySet());
        for (String name : names) {
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
                throw new IOException("there is another " + (meshes.containsKey(name) ? "mesh " : "picture ") + name + " beside it; give one of them another name");
            }
        }
        for (Map.Entry<Path, ByteBuffer> copy : copies.entrySet()) {
            Files.createDirectories(copy.getKey().getParent());
            byte[] content = new byte[copy.getValue().remaining()];
            copy.getValue().get(content);
            AtomicFile.write(copy.getKey(), out -> out.write(content));
        }
        for (Map.Entry<String, Mesh> mesh : meshes.entrySet()) {
            write(mesh.getKey(), mesh.getValue(), to.file().toAbsolutePath().resolveSibling(mesh.getKey()), there);
        }
        return there;
    }

    /** Of all bodies, by the names of their files. */
    private static Map<String, Mesh> meshes(Scene scene) {
        Map<String, Mesh> meshes = new LinkedHashMap<>();
        ScenePath.bodies(scene).map(place -> place.in(scene).shape()).forEach(shape -> {
            if (shape instanceof Mesh mesh && !mesh.file().isEmpty()) {
                meshes.putIfAbsent(mesh.file(), mesh);
            }
        });
        return meshes;
    }

    /** What was made of another program's file may be in none yet; and what is within one is found there again. */
    private static void write(String name, Mesh mesh, Path file, Assets there) throws IOException {
        boolean isObj = ForeignFormat.ofName(name).equals(Optional.of(ForeignFormat.OBJ));
        if (!Files.exists(file) && mesh.isRead() && mesh.part().isEmpty() && isObj) {
            AtomicFile.write(file, out -> MeshWriter.obj(mesh.triangles(), out));
        } else if (Files.exists(file) && ForeignFormat.ofName(name).equals(Optional.of(ForeignFormat.GLTF))) {
            MeshFiles.whole(name, there);
        }
    }
}
