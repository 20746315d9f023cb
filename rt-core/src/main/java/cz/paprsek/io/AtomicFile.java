package cz.paprsek.io;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.ClosedByInterruptException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.PosixFileAttributeView;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Replaces files as a whole: the new one is written beside the old and moved into its place, so that nobody ever sees half a file. */
public final class AtomicFile {
    private static final String TEMPORARY = ".tmp";
    private static final Duration ABANDONED_AFTER = Duration.ofMinutes(1);
    /** How many bytes a file's name may have on all systems in use. */
    private static final int LONGEST_NAME = 255;
    /** What makes the names of files that are being written different: a dot, a process, a dash, a time, the ending. */
    private static final int LONGEST_UNIQUE = 1 + 18 + 1 + 16 + TEMPORARY.length();
    private static final int MOST_LINKS = 40;

    private AtomicFile() {}

    /** Writes the content of a file to a stream. */
    @FunctionalInterface
    public interface Content {
        void writeTo(OutputStream out) throws IOException;
    }

    /**
     * Replaces or creates a file; an old file's permissions are kept. A device or pipe is written to directly.
     *
     * @throws IOException with one line that names the file, if it cannot be written, or the thread is interrupted meanwhile; what was
     *     there before is still there
     */
    public static void write(Path file, Content content) throws IOException {
        Objects.requireNonNull(file, "file");
        Objects.requireNonNull(content, "content");
        attempt(file, target -> {
            if (!isSpecial(target)) {
                sweep(target.resolveSibling("."), Pattern.quote(stem(target)));
            }
            put(target, content);
        });
    }

    /**
     * As {@link #write}, without looking for what was left half-written of the file: for one of thousands in a folder, which has been {@linkplain #sweepAll swept} before.
     *
     * @throws IOException as {@link #write}
     */
    public static void writeUnswept(Path file, Content content) throws IOException {
        Objects.requireNonNull(file, "file");
        Objects.requireNonNull(content, "content");
        attempt(file, target -> put(target, content));
    }

    private static boolean isSpecial(Path target) {
        return Files.exists(target) && !Files.isRegularFile(target);
    }

    private static void put(Path target, Content content) throws IOException {
        if (isSpecial(target)) {
            fill(target, content, StandardOpenOption.WRITE);
        } else {
            replace(target, content);
        }
    }

    /**
     * Finds out whether a file can be written, by making an empty one beside it and removing that.
     *
     * @throws IOException as {@link #write} would
     */
    public static void check(Path file) throws IOException {
        attempt(file, target -> {
            if (!Files.exists(target)) {
                checkName(target);
            }
            if (!Files.exists(target) || Files.isRegularFile(target)) {
                Path fresh = fresh(target);
                Files.createFile(fresh);
                Files.delete(fresh);
            }
        });
    }

    private static void checkName(Path target) throws IOException {
        try {
            Files.readAttributes(target, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
        } catch (NoSuchFileException none) {
            // Nothing else is wrong with it.
        }
    }

    /** The name of a file that belongs to another and lies beside it: its name with something before and after, cut where that is too long. */
    public static Path beside(Path file, String before, String after) {
        return file.resolveSibling(before + cut(file, LONGEST_NAME - before.length() - after.length()) + after);
    }

    /** A file's name if it is not too long, else its beginning and a mark that tells it from others. */
    private static String cut(Path file, int mostBytes) {
        String name = String.valueOf(file.getFileName());
        if (bytes(name) <= mostBytes) {
            return name;
        }
        String mark = "~" + Integer.toHexString(name.hashCode());
        String shorter = name;
        while (bytes(shorter) > mostBytes - mark.length()) {
            shorter = shorter.substring(0, shorter.offsetByCodePoints(shorter.length(), -1));
        }
        return shorter + mark;
    }

    private static int bytes(String name) {
        return name.getBytes(StandardCharsets.UTF_8).length;
    }

    /** What is done to the file that a name leads to. */
    private interface Attempt {
        void on(Path target) throws IOException;
    }

    private static void attempt(Path file, Attempt attempt) throws IOException {
        boolean exists = Files.exists(file);
        if (exists && Files.isDirectory(file)) {
            throw new IOException(file + ": this is a directory, not a file");
        }
        if (exists && !Files.isWritable(file)) {
            // A move would replace it all the same: it asks the folder's permissions only.
            throw new IOException(file + ": cannot be written, permission denied");
        }
        try {
            // A link is followed: the file it leads to is replaced or made, not the link.
            attempt.on(!exists ? end(file) : Files.isRegularFile(file) ? file.toRealPath() : file);
        } catch (NoSuchFileException e) {
            throw new IOException(file + ": cannot be written, there is no such folder", e);
        } catch (AccessDeniedException e) {
            throw new IOException(file + ": cannot be written, permission denied", e);
        } catch (ClosedByInterruptException e) {
            throw new IOException(file + ": writing was interrupted", e);
        } catch (IOException e) {
            throw isOfWriting(e) ? new IOException(Failures.sentence(file.toString(), e), e) : e;
        }
    }

    /** Whether the system could not write, which names no file, or the one that was to become it; not what the content failed at. */
    private static boolean isOfWriting(IOException e) {
        return e instanceof FileSystemException broken ? String.valueOf(broken.getFile()).endsWith(TEMPORARY)
                : Failures.isOfSystem(e) && !e.getStackTrace()[0].getMethodName().startsWith("read");
    }

    /** Where the links lead that begin at a name and end at a file that is not there yet. */
    private static Path end(Path file) throws IOException {
        Path end = file.toAbsolutePath();
        for (int i = 0; Files.isSymbolicLink(end); i++) {
            if (i == MOST_LINKS) {
                throw new IOException(file + ": cannot be written, it is a link that leads to itself");
            }
            end = end.resolveSibling(Files.readSymbolicLink(end));
        }
        return end;
    }

    private static Path fresh(Path target) {
        return target.resolveSibling(stem(target) + ProcessHandle.current().pid() + "-" + Long.toHexString(System.nanoTime()) + TEMPORARY);
    }

    /** What the names of all files begin with that have not become the target yet. */
    private static String stem(Path target) {
        return cut(target, LONGEST_NAME - LONGEST_UNIQUE) + ".";
    }

    private static void replace(Path target, Content content) throws IOException {
        Path fresh = fresh(target);
        try {
            // Not createTempFile, whose files are readable by their owner alone, whatever the old file was.
            fill(fresh, content, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
            PosixFileAttributeView old = Files.exists(target) ? Files.getFileAttributeView(target, PosixFileAttributeView.class) : null;
            if (old != null) {
                Files.setPosixFilePermissions(fresh, old.readAttributes().permissions());
            }
            Files.move(fresh, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } finally {
            Files.deleteIfExists(fresh);
        }
    }

    /**
     * Removes what processes that are no more have left half-written of all files of a folder whose names end alike.
     *
     * @param ending such as {@code .part}
     * @throws IOException if there is no such folder
     */
    public static void sweepAll(Path folder, String ending) throws IOException {
        Objects.requireNonNull(folder, "folder");
        sweep(folder, ".*" + Pattern.quote(Objects.requireNonNull(ending, "ending") + "."));
    }

    private static void sweep(Path folder, String stem) throws IOException {
        Pattern left = Pattern.compile(stem + "(\\d{1,18})-\\p{XDigit}{1,16}" + Pattern.quote(TEMPORARY));
        List<Path> abandoned = new ArrayList<>();
        try (DirectoryStream<Path> siblings = Files.newDirectoryStream(folder, file -> {
            Matcher name = left.matcher(String.valueOf(file.getFileName()));
            return name.matches() && isAbandoned(file, Long.parseLong(name.group(1)));
        })) {
            siblings.forEach(abandoned::add);
        } catch (AccessDeniedException | DirectoryIteratorException e) {
            // A folder that may be written to but not listed: whatever lies there is not ours to judge.
            return;
        }
        for (Path file : abandoned) {
            try {
                Files.deleteIfExists(file);
            } catch (IOException kept) {
                // Somebody else's, in a folder of many: nothing is lost by what is left.
            }
        }
    }

    /** The process may run on another machine that shares the folder: a file that was touched lately is left alone. */
    private static boolean isAbandoned(Path file, long process) {
        try {
            return ProcessHandle.of(process).isEmpty() && Files.getLastModifiedTime(file).toInstant().isBefore(Instant.now().minus(ABANDONED_AFTER));
        } catch (IOException gone) {
            // It has become what it was to be, or somebody else has removed it.
            return false;
        }
    }

    private static void fill(Path file, Content content, StandardOpenOption... how) throws IOException {
        // Not newOutputStream: an interrupt of the thread closes a channel, and that is how a write is stopped half-way.
        try (OutputStream out = new BufferedOutputStream(Channels.newOutputStream(Files.newByteChannel(file, how)), 1 << 16)) {
            content.writeTo(out);
        }
    }
}
