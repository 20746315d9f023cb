package cz.paprsek.fx.model.file;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.Belongings;
import cz.paprsek.format.MeshFiles;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** A scene as POV-Ray reads it. */
public final class PovExport {
    private PovExport() {}

    /**
     * Writes it, with the files that it needs beside it.
     *
     * @return what is not shown there as it is here, in sentences
     * @throws IOException if it cannot be written, or POV-Ray has no words for something in the scene
     */
    public static List<String> write(Scene scene, Assets assets, Path target) throws IOException {
        try {
            return Stream.concat(new Belongings(scene, assets).takeUnpacked(target, PovFiles::nameOf).stream(), PovFiles.write(MeshFiles.read(scene, assets), target).stream()).toList();
        } catch (IllegalArgumentException refused) {
            throw new IOException(refused.getMessage(), refused);
        }
    }
}
