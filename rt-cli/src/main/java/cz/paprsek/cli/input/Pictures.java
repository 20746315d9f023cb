package cz.paprsek.cli.input;

import cz.paprsek.asset.Assets;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.format.MeshFiles;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Mesh;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import picocli.CommandLine.Option;

/** Where the files come from that scenes name: pictures, meshes, fonts, and other scenes. */
public final class Pictures {
    @Option(names = "--assets", paramLabel = "DIR", description =
            "The folder that the pictures, meshes, fonts and scenes are in, or below, that a scene names. Default: that of the scene's file; of standard input, none.")
    private Optional<Path> folder = Optional.empty();

    /** Those of the scenes of a file, none read yet. */
    public Assets of(Path file) {
        if (folder.isPresent() && !Files.isDirectory(folder.get())) {
            throw new WrongUsage("--assets: " + folder.get() + (Files.exists(folder.get()) ? " is not a directory" : ": no such directory"));
        }
        return folder.map(Assets::in).orElseGet(() -> Incoming.isOnce(file) ? Assets.none() : Assets.beside(file));
    }

    /**
     * Those that a scene names, all there, though of these only meshes have been decoded.
     *
     * @throws IOException with a sentence that names the first that is missing, or cannot be read
     */
    public Assets read(Path file, Scene scene) throws IOException {
        Assets assets = of(file);
        read(scene, assets);
        return assets;
    }

    /** Likewise, into those of another scene of the same file; returns the scene with its meshes. */
    public Scene read(Scene scene, Assets assets) throws IOException {
        Scene read = MeshFiles.read(scene, assets);
        Set<String> names = new TreeSet<>(scene.files());
        names.addAll(ofMeshes(read).keySet());
        for (String name : names) {
            if (!assets.digests().containsKey(name)) {
                assets.bytes(name);
            }
        }
        return read;
    }

    /** Where those are that the scenes of a file have by such names. */
    public List<Path> files(Path file, Collection<String> names) {
        Path beside = Incoming.isOnce(file) ? Path.of("") : file.resolveSibling("");
        return names.stream().map(name -> folder.orElse(beside).resolve(name)).toList();
    }

    /** The pictures beside the files of meshes that show the materials of these, and for each the first such mesh; those within the files are there. */
    static Map<String, BodyAt> ofMeshes(Scene read) {
        if (read.files().isEmpty()) {
            return Map.of();
        }
        Map<String, BodyAt> names = new LinkedHashMap<>();
        ScenePath.bodies(read).forEach(at -> {
            if (at.in(read).shape() instanceof Mesh mesh && at.source(read) == Inherited.INHERITED) {
                mesh.materials().stream().flatMap(material -> material.files().stream()).filter(name -> !mesh.within().containsKey(name))
                        .forEach(name -> names.putIfAbsent(name, at));
            }
        });
        return names;
    }
}
