package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileSystems;
import java.nio.file.FileVisitOption;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The scene files that a user's words stand for. Shells expand {@code *} themselves, but not all of them and not in quotes. */
public final class SceneArguments {
    private static final Pattern WILD = Pattern.compile("[*?\\[{]");

    private SceneArguments() {}

    /**
     * The files in the order given, those of one pattern sorted, none twice. A pattern that no file matches stays as it is, and will be
     * reported as a file that does not exist.
     */
    public static List<Path> files(Collection<String> words) {
        Map<Path, Path> files = new LinkedHashMap<>();
        for (String word : words) {
            List<Path> found = exists(word) ? List.of() : matches(word);
            for (Path file : found.isEmpty() ? List.of(path(word)) : found) {
                files.putIfAbsent(file.toAbsolutePath().normalize(), file);
            }
        }
        return List.copyOf(files.values());
    }

    /** A file's name without folder and ending. */
    static String nameOf(Path file) {
        String name = Objects.requireNonNullElse(file.getFileName(), file).toString();
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }

    private static boolean exists(String word) {
        return !WILD.matcher(word).find() || Files.exists(path(word));
    }

    private static List<Path> matches(String word) {
        String pattern = word.replace(FileSystems.getDefault().getSeparator(), "/");
        int wild = WILD.matcher(pattern).results().findFirst().orElseThrow().start();
        int end = pattern.lastIndexOf('/', wild) + 1;
        Path base = path(pattern.substring(0, end));
        String rest = pattern.substring(end);
        int depth = rest.contains("**") ? Integer.MAX_VALUE : rest.split("/", -1).length;
        PathMatcher matcher = matcher(rest);
        try (Stream<Path> files = Files.find(end == 0 ? Path.of(".") : base, depth,
                (file, attributes) -> attributes.isRegularFile(), FileVisitOption.FOLLOW_LINKS)) {
            return files.map(file -> end == 0 ? Path.of(".").relativize(file) : file)
                    .filter(file -> matcher.matches(end == 0 ? file : base.relativize(file)))
                    .sorted()
                    .toList();
        } catch (IOException | UncheckedIOException unreadable) {
            return List.of();
        }
    }

    private static PathMatcher matcher(String pattern) {
        try {
            return FileSystems.getDefault().getPathMatcher("glob:" + pattern);
        } catch (IllegalArgumentException broken) {
            throw new WrongUsage("'" + pattern + "' is not a valid pattern: " + broken.getMessage());
        }
    }

    private static Path path(String word) {
        try {
            return Path.of(word);
        } catch (InvalidPathException e) {
            throw new WrongUsage("'" + word + "' is not a valid file name: " + e.getReason());
        }
    }
}
