package cz.paprsek.fx.model.file;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.Belongings;
import cz.paprsek.format.MeshFiles;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** A scene as POV-Ray reads it. */
public final class PovExport {
    private PovExport() {}

    /**
     * Writes it, with the files that it needs beside it.
     *
     * @param folder where those lie now, if that is known
     * @return what is not shown there as it is here, in sentences
     * @throws IllegalArgumentException if POV-Ray has no words for something in the scene
     */
    public static List<String> write(Scene scene, Assets assets, Optional<Path> folder, Path target) throws IOException {
        Stream<String> missing = new Belongings(scene, assets, folder).take(target, true).stream().map(name -> name + " is missing, and is not taken along");
        return Stream.concat(missing, PovFiles.write(MeshFiles.read(scene, assets), target).stream()).toList();
    }
}
