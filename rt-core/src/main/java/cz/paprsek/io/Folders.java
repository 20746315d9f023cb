package cz.paprsek.io;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;

/** Makes the folders that files are written into. */
public final class Folders {
    private Folders() {}

    /**
     * Makes a folder, and those that it lies in, unless it is there.
     *
     * @throws IOException if it cannot be made; with one line that says so if a file has its name, or that of one it lies in
     */
    public static void make(Path folder) throws IOException {
        try {
            Files.createDirectories(folder);
        } catch (FileAlreadyExistsException taken) {
            // A link to a folder is taken for no folder by some JDK 17; and what leads nowhere may be one that the folder lies in.
            if (!Files.isDirectory(folder)) {
                throw occupied(taken.getFile(), taken);
            }
        } catch (FileSystemException refused) {
            for (Path above = folder.getParent(); above != null; above = above.getParent()) {
                if (Files.exists(above) && !Files.isDirectory(above)) {
                    throw occupied(above.toString(), refused);
                }
            }
            throw refused;
        }
    }

    /**
     * Makes the folder that a file is to lie in.
     *
     * @throws IOException as {@link #make}
     */
    public static void makeFor(Path file) throws IOException {
        make(Objects.requireNonNull(file.toAbsolutePath().getParent()));
    }

    private static IOException occupied(String folder, IOException cause) {
        return new IOException(folder + " is not a directory, so nothing can be written there", cause);
    }
}
