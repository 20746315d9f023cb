package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.Words;
import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** The files that a pattern stands for, as in a shell. */
final class Glob {
    private static final Pattern WILD = Pattern.compile("[*?\\[{]");

    private Glob() {}

    static boolean isWild(String word) {
        return WILD.matcher(word).find();
    }

    /** The files that match, sorted; what cannot be looked into is left out. */
    static List<Path> files(String word) {
        String pattern = word.replace(FileSystems.getDefault().getSeparator(), "/");
        int end = pattern.lastIndexOf('/', WILD.matcher(pattern).results().findFirst().orElseThrow().start()) + 1;
        Path base = end == 0 ? Path.of("") : Words.path(pattern.substring(0, end));
        String rest = pattern.substring(end);
        int depth = rest.contains("**") ? Integer.MAX_VALUE : rest.split("/", -1).length;
        PathMatcher matcher = matcher(rest);
        List<Path> found = new ArrayList<>();
        try {
            Files.walkFileTree(end == 0 ? Path.of(".") : base, EnumSet.of(FileVisitOption.FOLLOW_LINKS), depth, new SimpleFileVisitor<>() {
                @Override
                public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                    Path seen = end == 0 ? Path.of(".").relativize(file) : base.relativize(file);
                    if (attributes.isRegularFile() && matcher.matches(seen)) {
                        found.add(end == 0 ? seen : file);
                    }
                    return FileVisitResult.CONTINUE;
                }

                @Override
                public FileVisitResult visitFileFailed(Path file, IOException unreadable) {
                    return FileVisitResult.CONTINUE;
                }

                @Override
                public FileVisitResult postVisitDirectory(Path folder, @Nullable IOException unreadable) {
                    return FileVisitResult.CONTINUE;
                }
            });
        } catch (IOException unreadable) {
            return List.of();
        }
        found.sort(null);
        return List.copyOf(found);
    }

    private static PathMatcher matcher(String pattern) {
        try {
            // Java's own ** wants a folder at least; in all shells it may be none.
            return FileSystems.getDefault().getPathMatcher("glob:" + pattern.replaceAll("(?<![^/])\\*\\*/", "{,**/}"));
        } catch (IllegalArgumentException broken) {
            throw new WrongUsage("'" + pattern + "' is not a valid pattern: " + broken.getMessage());
        }
    }
}
