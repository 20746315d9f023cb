package cz.paprsek.cli.process;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.Objects;

/** What went wrong with a file, in one line: many an exception's message is the file's name and nothing else. */
public final class Failures {
    private Failures() {}

    public static String sentence(String file, IOException failure) {
        if (failure instanceof FileSystemException broken) {
            return file + ": " + small(Objects.requireNonNullElse(broken.getReason(), meaning(broken)));
        }
        String message = Objects.requireNonNullElse(failure.getMessage(), failure.getClass().getSimpleName());
        return message.startsWith(file) ? message : file + ": " + small(message);
    }

    /** Systems begin their sentences in capitals; ours stand after a colon. */
    private static String small(String sentence) {
        return sentence.length() > 1 && Character.isLowerCase(sentence.charAt(1)) ? Character.toLowerCase(sentence.charAt(0)) + sentence.substring(1) : sentence;
    }

    private static String meaning(FileSystemException failure) {
        if (failure instanceof NoSuchFileException) {
            return "no such file";
        }
        return failure instanceof AccessDeniedException ? "permission denied" : failure.getClass().getSimpleName();
    }
}
