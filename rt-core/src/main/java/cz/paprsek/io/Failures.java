package cz.paprsek.io;

import java.io.EOFException;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.channels.ClosedChannelException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** What went wrong, in one line: many an exception's message is the file's name and nothing else, and some have none at all. */
public final class Failures {
    private static final List<Class<? extends FileSystemException>> LASTING = List.of(NoSuchFileException.class, AccessDeniedException.class, NotDirectoryException.class,
            FileSystemLoopException.class, FileAlreadyExistsException.class, DirectoryNotEmptyException.class);

    private Failures() {}

    /** In front stands the file's name, where the failure knows it. */
    public static String sentence(Throwable failure) {
        Throwable cause = failure.getCause();
        if (failure instanceof UncheckedIOException && cause != null) {
            return sentence(cause);
        }
        String what = what(failure);
        String file = failure instanceof FileSystemException broken ? broken.getFile() : null;
        return file == null ? what : file + ": " + small(what);
    }

    /** In front stands the file's name. */
    public static String sentence(String file, IOException failure) {
        String what = what(failure);
        return what.startsWith(file) ? what : file + ": " + small(what);
    }

    /** Why nothing can have such a name here: the system has no code for its letters, or does not allow them. */
    public static String noName(InvalidPathException failure) {
        String reason = failure.getReason();
        return !reason.contains("unmappable") && !reason.contains("Malformed") ? small(reason)
                : "the locale (" + System.getProperty("sun.jnu.encoding", "unknown") + ") has no code for its letters; LC_ALL=C.UTF-8 has";
    }

    /**
     * Whether a file may be as it should, but could not be read here and now: the system failed, there was too little memory, or somebody interrupted. What is missing,
     * forbidden or cannot be decoded stays so if it is tried again.
     */
    public static boolean isOfMachine(Throwable failure) {
        Throwable cause = failure.getCause();
        return failure instanceof OutOfMemoryError || failure instanceof InterruptedIOException || failure instanceof ClosedChannelException
                || (failure instanceof FileSystemException && LASTING.stream().noneMatch(kind -> kind.isInstance(failure)))
                || isOfSystem(failure) || (cause != null && isOfMachine(cause));
    }

    /** What reading or writing bytes throws, be it for a disk or a network, has no class of its own: it comes from code that is not Java. */
    static boolean isOfSystem(Throwable failure) {
        StackTraceElement[] calls = failure.getStackTrace();
        return failure.getClass() == IOException.class && calls.length > 0 && calls[0].isNativeMethod();
    }

    private static String what(Throwable failure) {
        String said = failure instanceof FileSystemException broken ? broken.getReason() : failure.getMessage();
        return Optional.ofNullable(said).filter(text -> !text.isBlank()).or(() -> meaning(failure)).orElseGet(() -> words(failure.getClass().getSimpleName()));
    }

    /** Systems begin their sentences in capitals; ours stand after a colon. */
    private static String small(String sentence) {
        return sentence.length() > 1 && Character.isLowerCase(sentence.charAt(1)) ? Character.toLowerCase(sentence.charAt(0)) + sentence.substring(1) : sentence;
    }

    /** Of those that leave it to their class to say it. */
    private static Optional<String> meaning(Throwable failure) {
        return Optional.ofNullable(
                failure instanceof NoSuchFileException ? "no such file"
                : failure instanceof AccessDeniedException ? "permission denied"
                : failure instanceof FileAlreadyExistsException ? "there is such a file already"
                : failure instanceof DirectoryNotEmptyException ? "the directory is not empty"
                : failure instanceof NotDirectoryException ? "this is not a directory"
                : failure instanceof FileSystemLoopException ? "links lead in a circle"
                : failure instanceof EOFException ? "the file is cut off"
                : failure instanceof ClosedByInterruptException ? "interrupted"
                : failure instanceof ClosedChannelException ? "the file was closed while it was in use"
                : failure instanceof CharacterCodingException ? "there are bytes that are no text in this encoding"
                : failure instanceof OutOfMemoryError ? "out of memory"
                : null);
    }

    /** {@code ZipException} and its kind without a word: "zip". */
    private static String words(String name) {
        String words = name.replaceAll("(Exception|Error)$", "").replaceAll("(?<=[a-z])(?=[A-Z])", " ").toLowerCase(Locale.ROOT).strip();
        return words.isEmpty() || words.equals("io") ? "it cannot be read or written" : words;
    }
}
