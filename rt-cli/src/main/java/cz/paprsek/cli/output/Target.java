package cz.paprsek.cli.output;

import cz.paprsek.cli.input.SceneSource;
import cz.paprsek.image.ImageFormat;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Where the picture of a scene goes.
 *
 * @param source where the scene comes from
 * @param file the picture's file; none for standard output
 */
public record Target(SceneSource source, Optional<Path> file, ImageFormat format) {

    /** The scene's file. */
    Path scene() {
        return source.file();
    }

    /** The picture's file as the user would name it. */
    String shown() {
        return file.map(Path::toString).orElse("-");
    }
}
