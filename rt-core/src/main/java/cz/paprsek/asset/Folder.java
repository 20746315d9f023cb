package cz.paprsek.asset;

import cz.paprsek.io.Failures;
import java.io.IOException;
import java.io.InputStream;
import java.nio.channels.Channels;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.SecureDirectoryStream;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributeView;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Objects;
import java.util.Set;

/**
 * The files of a folder and of those below, in any file system. Links are followed if they lead to a file within. Where a link leads is found out first; then
 * the file it leads to is opened from the folder down, part by part and without following any link, so that a link put in place meanwhile gains nothing.
 *
 * @param isBeside whether it is that of the scene's file
 */
record Folder(Path folder, boolean isBeside) implements Assets.Source {

    @Override
    public InputStream open(String name) throws IOException {
        try {
            return openWithin(folder.toAbsolutePath().toRealPath(), name);
        } catch (FileSystemException e) {
            // It names a file of this machine, which is nothing to those who wrote the scene.
            throw new IOException(reason(e), e);
        } catch (InvalidPathException e) {
            throw new IOException("there can be no file of this name: " + Failures.noName(e), e);
        }
    }

    private static InputStream openWithin(Path root, String name) throws IOException {
        Path file = root.resolve(name).toRealPath();
        if (!file.startsWith(root) || file.equals(root)) {
            throw new IOException("this is a link that leads out of the scene's folder, and only files within can be read");
        }
        try (DirectoryStream<Path> entries = Files.newDirectoryStream(root)) {
            if (entries instanceof SecureDirectoryStream<Path> secure) {
                return openBelow(secure, root.relativize(file));
            }
        }
        return openAnywhere(root, file);
    }

    private static String reason(FileSystemException e) {
        String reason = Objects.requireNonNullElse(e.getReason(), "it cannot be read");
        return e instanceof NoSuchFileException || reason.equals("Not a directory") ? "there is no such file beside the scene"
                : e instanceof AccessDeniedException ? "permission denied" : reason;
    }

    private static InputStream openBelow(SecureDirectoryStream<Path> directory, Path rest) throws IOException {
        Path first = rest.getName(0);
        if (rest.getNameCount() > 1) {
            try (SecureDirectoryStream<Path> next = directory.newDirectoryStream(first, LinkOption.NOFOLLOW_LINKS)) {
                return openBelow(next, rest.subpath(1, rest.getNameCount()));
            }
        }
        requireFile(directory.getFileAttributeView(first, BasicFileAttributeView.class, LinkOption.NOFOLLOW_LINKS).readAttributes());
        return stream(directory.newByteChannel(first, Set.of(StandardOpenOption.READ, LinkOption.NOFOLLOW_LINKS)));
    }

    /** Where folders cannot be held open, as in a zip file and on Windows: what was opened is looked at once more. */
    private static InputStream openAnywhere(Path root, Path file) throws IOException {
        requireFile(Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS));
        InputStream opened = stream(Files.newByteChannel(file, StandardOpenOption.READ));
        if (!file.toRealPath().equals(file) || !root.toRealPath().equals(root)) {
            opened.close();
            throw new IOException("this was replaced while it was opened");
        }
        return opened;
    }

    private static InputStream stream(SeekableByteChannel channel) throws IOException {
        return new Assets.Sized(Channels.newInputStream(channel), channel.size());
    }

    /** Before it is opened: opening a pipe waits for somebody who writes to it. */
    private static void requireFile(BasicFileAttributes attributes) throws IOException {
        if (!attributes.isRegularFile()) {
            throw new IOException(attributes.isDirectory() ? "this is a folder, not a file" : "this is a device or pipe, not a file");
        }
    }
}
