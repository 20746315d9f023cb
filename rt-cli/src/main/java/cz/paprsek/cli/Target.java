package cz.paprsek.cli;

import cz.paprsek.image.ImageFormat;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Where the picture of a scene goes.
 *
 * @param scene the scene's file
 * @param file the picture's file; none for standard output
 */
record Target(Path scene, Optional<Path> file, ImageFormat format) {

    /** The picture's file as the user would name it. */
    String shown() {
        return file.map(Path::toString).orElse("-");
    }
}
