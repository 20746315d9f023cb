package cz.paprsek.format;

import cz.paprsek.asset.Assets;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Failures;
import cz.paprsek.io.Folders;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Mesh;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;

/** The files that a scene needs besides its own, on their way to another folder: pictures, meshes, and what lies beside those. */
public final class Belongings {
    private static final int BLOCK = 1 << 16;

    private final Scene scene;
    private final Assets assets;

    /**
     * Those of a scene.
     *
     * @param assets where they come from: what may not be read there is not taken along
     */
    public Belongings(Scene scene, Assets assets) {
        this.scene = Objects.requireNonNull(scene, "scene");
        this.assets = Objects.requireNonNull(assets, "assets");
    }

    /**
     * Copies all of them to where the scene is to be kept, unless they are there, or there is no such folder, which whoever writes the scene will say.
     *
     * @return a sentence for each that is missing or may not be read, and so is not taken along
     * @throws IOException if there is another file of the same name there, before anything is copied; or one cannot be written
     */
    public List<String> take(Path sceneFile) throws IOException {
        return take(sceneFile, false, name -> name);
    }

    /**
     * Likewise for another program, which does not find pictures within meshes: those become files, too.
     *
     * @param named what that program calls a file
     */
    public List<String> takeUnpacked(Path sceneFile, UnaryOperator<String> named) throws IOException {
        return take(sceneFile, true, named);
    }

    private List<String> take(Path sceneFile, boolean areUnpacked, UnaryOperator<String> named) throws IOException {
        if (!Files.isDirectory(Objects.requireNonNull(sceneFile.toAbsolutePath().getParent()))) {
            return List.of();
        }
        Scene read = MeshFiles.read(scene, assets, (place, problem) -> { });
        List<String> missing = new ArrayList<>();
        Map<Path, String> copies = new LinkedHashMap<>();
        for (String name : names(read, areUnpacked)) {
            Path copy = beside(sceneFile, named.apply(name));
            InputStream original;
            try {
                original = assets.open(name);
            } catch (IOException refused) {
                missing.add(String.valueOf(refused.getMessage()));
                continue;
            }
            try (original) {
                String other = copies.get(copy);
                if (other == null && !Files.exists(copy)) {
                    copies.put(copy, name);
                } else if (!isSame(original, other == null ? Files.newInputStream(copy) : assets.open(other))) {
                    throw new IOException("there is another " + (ForeignFormat.ofName(name).isPresent() ? "mesh " : name.endsWith(".ttf") ? "font " : "picture ") + name + " beside it; give one of them another name");
                }
            }
        }
        for (Map.Entry<Path, String> copy : copies.entrySet()) {
            Folders.makeFor(copy.getKey());
            AtomicFile.write(copy.getKey(), out -> copy(copy.getValue(), out));
        }
        return missing;
    }

    private static Path beside(Path sceneFile, String name) throws IOException {
        try {
            return sceneFile.toAbsolutePath().resolveSibling(name);
        } catch (InvalidPathException e) {
            throw new IOException("\"" + name + "\": there can be no file of this name: " + Failures.noName(e), e);
        }
    }

    private static SortedSet<String> names(Scene scene, boolean areUnpacked) {
        SortedSet<String> names = new TreeSet<>(scene.files());
        meshes(scene).forEach(mesh -> {
            names.addAll(mesh.companions());
            if (areUnpacked) {
                mesh.materials().forEach(material -> names.addAll(material.files()));
            }
        });
        return names;
    }

    private static Stream<Mesh> meshes(Scene scene) {
        return ScenePath.bodies(scene).map(place -> place.in(scene).shape()).filter(Mesh.class::isInstance).map(Mesh.class::cast);
    }

    private void copy(String name, OutputStream out) throws IOException {
        try (InputStream original = assets.open(name)) {
            original.transferTo(out);
        }
    }

    private static boolean isSame(InputStream original, InputStream other) throws IOException {
        try (other) {
            byte[] block;
            do {
                block = original.readNBytes(BLOCK);
                if (!Arrays.equals(block, other.readNBytes(BLOCK))) {
                    return false;
                }
            } while (block.length > 0);
            return true;
        }
    }
}
