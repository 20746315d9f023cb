package cz.paprsek.cli;

import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** The scene files that a user named, also by patterns that the shell left alone. */
final class SceneArguments {
    private SceneArguments() {}

    /** @throws IOException with one line, if a pattern matches nothing or its folder cannot be listed */
    static List<Path> expand(List<String> arguments) throws IOException {
        List<Path> files = new ArrayList<>();
        for (String argument : arguments) {
            boolean isPattern = argument.contains("*") || argument.contains("?") || argument.contains("{");
            if (!isPattern || Files.exists(Path.of(argument))) {
                files.add(Path.of(argument));
            } else {
                files.addAll(matches(argument));
            }
        }
        return files;
    }

    private static List<Path> matches(String pattern) throws IOException {
        int slash = Math.max(pattern.lastIndexOf('/'), pattern.lastIndexOf('\\'));
        Path folder = Path.of(slash < 0 ? "." : pattern.substring(0, slash + 1));
        PathMatcher matcher = FileSystems.getDefault().getPathMatcher("glob:" + pattern.substring(slash + 1));
        if (!Files.isDirectory(folder)) {
            throw new IOException(pattern + ": there is no folder " + folder);
        }
        try (Stream<Path> entries = Files.list(folder)) {
            List<Path> found = entries.filter(file -> matcher.matches(file.getFileName())).sorted()
                    .map(file -> slash < 0 ? file.getFileName() : file).toList();
            if (found.isEmpty()) {
                throw new IOException(pattern + ": no file matches");
            }
            return found;
        }
    }
}
