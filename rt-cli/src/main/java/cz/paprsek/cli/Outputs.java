package cz.paprsek.cli;

import cz.paprsek.image.ImageFormat;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Where the pictures go.
 *
 * @param target a file, a pattern with {@value #NAME}, a folder, or nothing: the working directory
 * @param format the format asked for; if null, what the file's name says, or PNG
 */
record Outputs(String target, @org.jspecify.annotations.Nullable ImageFormat format) {
    /** Stands for the scene file's name without its ending. */
    static final String NAME = "{name}";

    /** Whether each scene gets a file of its own. */
    boolean isForMany() {
        return target.isEmpty() || target.contains(NAME) || isFolder();
    }

    Path file(Path scene) {
        String file = scene.getFileName().toString();
        String name = file.contains(".") ? file.substring(0, file.lastIndexOf('.')) : file;
        String ending = "." + (format == null ? ImageFormat.PNG : format).extension();
        if (target.isEmpty()) {
            return Path.of(name + ending);
        }
        return isFolder() ? Path.of(target).resolve(name + ending) : Path.of(target.replace(NAME, name));
    }

    /** The format of a file: as asked for, else as it is called. Null if its name ends with nothing we know. */
    @org.jspecify.annotations.Nullable ImageFormat formatOf(Path file) {
        return format != null ? format : ImageFormat.ofFile(file.toString()).orElse(null);
    }

    private boolean isFolder() {
        return target.endsWith("/") || target.endsWith("\\") || Files.isDirectory(Path.of(target));
    }
}
