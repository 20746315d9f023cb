package cz.paprsek.cli.output;

import cz.paprsek.cli.input.SceneSource;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.value.FrameRange;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.Layers;
import java.io.IOException;
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
    /** Stands in a name for the number of a frame. */
    public static final String FRAME = "{frame}";

    /** The scene's file. */
    public Path scene() {
        return source.file();
    }

    /**
     * Writes the picture.
     *
     * @param written its format, if that is not quite the target's
     * @param layers what else is known of its pixels, which only OpenEXR can hold
     */
    public void write(ImageFormat written, Image image, Layers layers, ImageOptions how, Terminal terminal) throws IOException {
        boolean isLayered = !layers.names().isEmpty();
        if (file.isPresent() && isLayered) {
            ImageFiles.write(image, layers, file.get(), how);
        } else if (file.isPresent()) {
            ImageFiles.write(image, file.get(), written, how);
        } else if (isLayered) {
            ImageFiles.write(image, layers, terminal.bytes(), how);
        } else {
            ImageFiles.write(image, terminal.bytes(), written, how);
        }
    }

    /** The picture's file as the user would name it. */
    public String shown() {
        return file.map(Path::toString).orElse("-");
    }

    /** Whether its name has a place for the number of a frame. */
    boolean isNumbered() {
        return file.filter(path -> name(path).contains(FRAME)).isPresent();
    }

    /** Where one of the frames goes that have pictures of their own. */
    public Target ofFrame(FrameRange range, int frame) {
        return new Target(labelled(frame).source, file.map(path -> path.resolveSibling(name(path).replace(FRAME, range.padded(frame)))), format, refusal);
    }

    /** With the number of a frame in what messages call the scene. */
    Target labelled(int frame) {
        return new Target(new SceneSource(source.file(), source.label() + ", frame " + frame, source.name(), source.reading()), file, format, refusal);
    }

    /** The name that a frame of a film would have beside it. */
    Path besideFrame(FrameRange range, int frame) {
        Path film = file.orElseThrow();
        return film.resolveSibling(name(film) + "-" + range.padded(frame));
    }

    private static String name(Path path) {
        return String.valueOf(path.getFileName());
    }
}
