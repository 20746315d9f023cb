package cz.paprsek.cli.input;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.ForeignFormat;
import cz.paprsek.format.MeshFiles;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Option;

/** Where the pictures come from that scenes name. */
public final class Pictures {
    @Option(names = "--assets", paramLabel = "DIR", description =
            "The folder that pictures named by scenes are in, or below. Default: that of the scene's file; of standard input, none.")
    private Optional<Path> folder = Optional.empty();

    /** Those of the scenes of a file, none read yet. */
    public Assets of(Path file) {
        return folder.map(Assets::in).orElseGet(() -> Incoming.isOnce(file) ? Assets.none() : Assets.beside(file));
    }

    /** With those that are within the file itself, if it is another program's. */
    private Assets with(Path file) throws IOException {
        Assets assets = of(file);
        if (Models.format(file).equals(Optional.of(ForeignFormat.GLTF))) {
            Assets own = folder.isEmpty() ? assets : Assets.beside(file);
            for (Map.Entry<String, byte[]> picture : MeshFiles.pictures(Models.name(file), own).entrySet()) {
                assets.supply(picture.getKey(), picture.getValue());
            }
        }
        return assets;
    }

    /**
     * Those that a scene names, all there, though of these only meshes have been decoded.
     *
     * @throws IOException with a sentence that names the first that is missing, or cannot be read
     */
    public Assets read(Path file, Scene scene) throws IOException {
        Assets assets = with(file);
        MeshFiles.read(scene, assets);
        for (String name : scene.files()) {
            if (!assets.digests().containsKey(name)) {
                assets.bytes(name);
            }
        }
        return assets;
    }
}
