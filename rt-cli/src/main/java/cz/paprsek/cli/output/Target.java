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
 * @param refusal why there can be no such file; empty if there can
 */
public record Target(SceneSource source, Optional<Path> file, ImageFormat format, String refusal) {

    /** The scene's file. */
    public Path scene() {
        return source.file();
    }

    /** The picture's file as the user would name it. */
    public String shown() {
        return file.map(Path::toString).orElse("-");
    }
}
