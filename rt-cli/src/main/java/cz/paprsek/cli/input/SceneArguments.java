package cz.paprsek.cli.input;

import cz.paprsek.cli.value.Words;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** The scene files that a user's words stand for. Shells expand {@code *} themselves, but not all of them and not in quotes. */
public final class SceneArguments {
    private static final char UNKNOWN = '\ufffd';

    private SceneArguments() {}

    /**
     * The files in the order given, those of one pattern sorted, none twice. A pattern that no file matches stays as it is, and will be
     * reported as a file that does not exist.
     */
    public static List<Path> files(Collection<String> words) {
        Map<Path, Path> files = new LinkedHashMap<>();
        for (String word : words) {
            for (Path file : files(word)) {
                files.putIfAbsent(file.toAbsolutePath().normalize(), file);
            }
        }
        return List.copyOf(files.values());
    }

    private static List<Path> files(String given) {
        // What no letter of this locale could be made of, any letter may be.
        String word = given.replace(UNKNOWN, '?');
        List<Path> found = !Glob.isWild(word) || exists(given) ? List.of() : Glob.files(word);
        return found.isEmpty() ? List.of(Words.path(given)) : found;
    }

    private static boolean exists(String word) {
        try {
            return Files.exists(Path.of(word));
        } catch (InvalidPathException noName) {
            return false;
        }
    }

    /** A file's name without folder and ending. */
    static String nameOf(Path file) {
        String name = Objects.requireNonNullElse(file.getFileName(), file).toString();
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }
}
