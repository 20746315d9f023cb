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
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The files that a scene needs besides its own, on their way to another folder: pictures, meshes, and what lies beside those. */
public final class Belongings {
    private final Scene scene;
    private final Assets assets;
    private final Optional<Path> folder;

    /**
     * Those of a scene.
     *
     * @param assets where they come from
     * @param folder where they lie, if that is known: files are then copied from there, however large they are
     */
    public Belongings(Scene scene, Assets assets, Optional<Path> folder) {
        this.scene = Objects.requireNonNull(scene, "scene");
        this.assets = Objects.requireNonNull(assets, "assets");
        this.folder = Objects.requireNonNull(folder, "folder");
    }

    /**
     * Copies all of them to where the scene is to be kept, unless they are there, or there is no such folder, which whoever writes the scene will say.
     *
     * @param areUnpacked whether pictures within meshes are wanted as files, too: other programs do not find them there
     * @return what is missing, which stays so
     * @throws IOException if there is another file of the same name there, before anything is copied; or one cannot be written
     */
    public List<String> take(Path sceneFile, boolean areUnpacked) throws IOException {
        if (!Files.isDirectory(Objects.requireNonNull(sceneFile.toAbsolutePath().getParent()))) {
            return List.of();
        }
        Scene read = MeshFiles.read(scene, assets, (place, problem) -> { });
        List<String> missing = new ArrayList<>();
        Map<Path, AtomicFile.Content> copies = new LinkedHashMap<>();
        Set<String> inner = meshes(read).flatMap(mesh -> mesh.within().keySet().stream()).collect(Collectors.toSet());
        for (String name : names(read, areUnpacked)) {
            Path copy = beside(sceneFile, name);
            Optional<Path> original = folder.filter(from -> !inner.contains(name)).map(from -> from.resolve(name)).filter(Files::isRegularFile);
            Optional<byte[]> content = original.isPresent() ? Optional.empty() : content(name);
            if (original.isEmpty() && content.isEmpty()) {
                missing.add(name);
            } else if (!Files.exists(copy)) {
                copies.put(copy, original.<AtomicFile.Content>map(from -> out -> Files.copy(from, out)).orElse(out -> out.write(content.orElseThrow())));
            } else if (!(original.isPresent() ? isSame(original.get(), copy) : isSame(content.orElseThrow(), copy))) {
                throw new IOException("there is another " + (ForeignFormat.ofName(name).isPresent() ? "mesh " : name.endsWith(".ttf") ? "font " : "picture ") + name + " beside it; give one of them another name");
            }
        }
        for (Map.Entry<Path, AtomicFile.Content> copy : copies.entrySet()) {
            Folders.makeFor(copy.getKey());
            AtomicFile.write(copy.getKey(), copy.getValue());
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

    private Optional<byte[]> content(String name) {
        try {
            ByteBuffer content = assets.bytes(name);
            byte[] bytes = new byte[content.remaining()];
            content.get(bytes);
            return Optional.of(bytes);
        } catch (IOException missing) {
            return Optional.empty();
        }
    }

    private static boolean isSame(Path one, Path other) throws IOException {
        return Files.isSameFile(one, other) || Files.mismatch(one, other) < 0;
    }

    private static boolean isSame(byte[] content, Path file) throws IOException {
        try (InputStream input = Files.newInputStream(file)) {
            return Files.size(file) == content.length && Arrays.equals(content, input.readNBytes(content.length));
        }
    }
}
