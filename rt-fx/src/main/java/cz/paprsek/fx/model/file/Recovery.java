package cz.paprsek.fx.model.file;

import cz.paprsek.io.AtomicFile;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.SceneFile;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Copies of unsaved scenes, to be offered after a crash: beside the scene's file, or in a folder of the program's for a scene that has none.
 * A file names the process that wrote it, so that what another open window keeps is left alone.
 */
public final class Recovery {
    private static final String ENDING = ".unsaved";

    private final Path folder;
    private final long process;

    /** @param folder for scenes without a file; made when it is needed */
    public Recovery(Path folder) {
        this(folder, ProcessHandle.current().pid());
    }

    Recovery(Path folder, long process) {
        this.folder = folder;
        this.process = process;
    }

    /** Where the copy of a scene from a source goes: "lens.xml" has ".lens.xml.1234.unsaved" beside it. */
    public Path place(Optional<SceneSource> source) {
        return source.map(known -> known.file().resolveSibling(prefix(known) + process + ENDING))
                .orElseGet(() -> folder.resolve(".untitled." + process + ENDING));
    }

    /** Keeps a copy, replacing the last one; it can take the place of the file that has that text. */
    public void keep(Optional<SceneSource> source, Scene scene, KeptText text) throws IOException {
        Path place = place(source);
        if (source.isEmpty()) {
            Files.createDirectories(folder);
        }
        if (text.file().isPresent()) {
            text.file().get().saveAs(scene, place);
        } else if (text.typed().isPresent()) {
            SceneFile.of(place, text.typed().get()).saveAs(scene, place);
        } else if (text.database().isPresent()) {
            SceneFile.create(place, scene, text.database().get().text());
        } else {
            SceneFiles.write(scene, place);
        }
    }

    /** Keeps what is written in the scene's text and not in the scene beside the copy; forgets it if there is nothing of that. */
    public void keepText(Optional<SceneSource> source, Optional<String> written) throws IOException {
        Path place = textOf(place(source));
        if (written.isPresent()) {
            AtomicFile.write(place, out -> out.write(written.get().getBytes(StandardCharsets.UTF_8)));
        } else {
            Files.deleteIfExists(place);
        }
    }

    /**
     * Reads a copy with its comments and wording.
     *
     * @throws SceneFileException if it is not the text of one scene
     * @throws IOException if it cannot be read
     */
    public static OriginalText read(Path copy) throws IOException, SceneFileException {
        return SceneFiles.open(copy).text();
    }

    /** What was written beside a copy. */
    public static Optional<String> textBeside(Path copy) throws IOException {
        return Files.exists(textOf(copy)) ? Optional.of(Files.readString(textOf(copy))) : Optional.empty();
    }

    /** Forgets the copy, because the scene was saved or given up. */
    public void discard(Optional<SceneSource> source) throws IOException {
        delete(place(source));
    }

    /** Deletes a copy, and what was written beside it. */
    public static void delete(Path copy) throws IOException {
        Files.deleteIfExists(copy);
        Files.deleteIfExists(textOf(copy));
    }

    private static Path textOf(Path copy) {
        return copy.resolveSibling(copy.getFileName() + "-text");
    }

    /** A copy of a scene from a source that a process left which is no more; empty if there is none. */
    public Optional<Path> left(Optional<SceneSource> source) throws IOException {
        Path place = place(source);
        Path parent = place.getParent();
        if (parent == null || !Files.isDirectory(parent)) {
            return Optional.empty();
        }
        String prefix = source.map(Recovery::prefix).orElse(".untitled.");
        try (Stream<Path> files = Files.list(parent)) {
            return files.filter(file -> isLeft(file, prefix)).findFirst();
        }
    }

    private boolean isLeft(Path file, String prefix) {
        String name = file.getFileName().toString();
        if (!name.startsWith(prefix) || !name.endsWith(ENDING)) {
            return false;
        }
        String writer = name.substring(prefix.length(), Math.max(prefix.length(), name.length() - ENDING.length()));
        return writer.matches("\\d{1,18}") && Long.parseLong(writer) != process
                && ProcessHandle.of(Long.parseLong(writer)).filter(ProcessHandle::isAlive).isEmpty();
    }

    private static String prefix(SceneSource source) {
        // A database has many scenes: each has a copy of its own.
        String scene = source.inDatabase().map(name -> "." + Integer.toHexString(name.hashCode())).orElse("");
        return "." + source.file().getFileName() + scene + ".";
    }
}
