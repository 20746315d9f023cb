package cz.paprsek.xml;

import cz.paprsek.io.AtomicFile;
import cz.paprsek.scene.Scene;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;

/**
 * Reads and writes scene files. A file is checked against the schema whenever it is read; all its problems are reported, each with line
 * and column. Nothing that a file refers to is ever fetched.
 */
public final class SceneFiles {
    /** The namespace of scene files. */
    public static final String NAMESPACE = "urn:paprsek:scene:1";

    /**
     * How deep elements may be nested in a file: far deeper than anybody builds, and safe for every recursion in the program. The hungriest is
     * the comparison of two scenes, which fills a stack of 1 MB at 570 levels.
     */
    public static final int DEEPEST = 250;

    /** How many bytes a file may have: 1 GiB, ten million spheres. */
    public static final long LARGEST = 1L << 30;

    private SceneFiles() {}

    /**
     * Reads a file with one scene.
     *
     * @throws SceneFileException if it is not a valid scene, with every problem found
     * @throws IOException if it cannot be read
     */
    public static Scene read(Path file) throws SceneFileException, IOException {
        return only(readAll(file), file.toString());
    }

    /** As {@link #read(Path)}, from a stream, which is not closed; the name is used in messages only. */
    public static Scene read(InputStream input, String fileName) throws SceneFileException, IOException {
        return only(SceneReader.read(input, fileName), fileName);
    }

    /** Reads a scene from text. */
    public static Scene parse(String xml) throws SceneFileException {
        try {
            return only(SceneReader.read(xml, "text"), "text");
        } catch (IOException e) {
            throw new IllegalStateException("a text in memory could not be read", e);
        }
    }

    /**
     * Reads a file with one {@code <scene>} or a {@code <database>} of any number.
     *
     * @throws SceneFileException if it is not valid, with every problem found
     * @throws IOException if it cannot be read
     */
    public static List<Scene> readAll(Path file) throws SceneFileException, IOException {
        if (Files.isDirectory(file)) {
            throw new IOException(file + ": this is a directory, not a scene file");
        }
        if (!Files.exists(file)) {
            throw new IOException(file + ": no such file");
        }
        if (!Files.isReadable(file)) {
            throw new IOException(file + ": no permission to read this file");
        }
        try (InputStream input = Files.newInputStream(file)) {
            return SceneReader.read(input, file.toString());
        }
    }

    /**
     * Writes a scene; the file is replaced as a whole or not at all, and keeps its permissions.
     *
     * @throws IllegalArgumentException as {@link #format}
     */
    public static void write(Scene scene, Path file) throws IOException {
        write(file, format(scene));
    }

    /**
     * Writes a database; the file is replaced as a whole or not at all, and keeps its permissions.
     *
     * @throws IllegalArgumentException as {@link #format}
     */
    public static void writeAll(List<Scene> scenes, Path file) throws IOException {
        write(file, formatAll(scenes));
    }

    /**
     * The text of a scene file, always the same for the same scene.
     *
     * @throws IllegalArgumentException if the scene has what no file can hold: a text with control characters, or nesting deeper than {@link #DEEPEST}
     */
    public static String format(Scene scene) {
        return new SceneWriter().file(scene);
    }

    /**
     * The text of a database file, always the same for the same scenes.
     *
     * @throws IllegalArgumentException as {@link #format}
     */
    public static String formatAll(List<Scene> scenes) {
        return new SceneWriter().database(scenes);
    }

    /** The schema of scene files, an XSD. */
    public static String schema() {
        try (InputStream input = Objects.requireNonNull(SceneFiles.class.getResourceAsStream("scene.xsd"), "scene.xsd is missing")) {
            return new String(input.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new IllegalStateException("the schema in the program's own jar cannot be read", e);
        }
    }

    private static void write(Path file, String text) throws IOException {
        AtomicFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }

    private static Scene only(List<Scene> scenes, String file) throws SceneFileException {
        if (scenes.size() != 1) {
            throw new SceneFileException(List.of(new Problem(file, 1, 1,
                    "this is a database of " + scenes.size() + " scenes, but one scene was expected")));
        }
        return scenes.get(0);
    }
}
