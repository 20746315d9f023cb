package cz.paprsek.xml;

import cz.paprsek.io.FileLock;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.xml.SceneFiles.Contents;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.function.UnaryOperator;

/**
 * A database as it was in a file when it was read or written. What others change in the file after that is never overwritten: a scene that
 * only they changed stays as they made it, and where both changed one, nothing is written. The text of the file is changed where its scenes have
 * changed: comments, order, wording and every other byte stay.
 */
public final class DatabaseFile {
    static final long PATIENCE_MILLIS = 60_000;

    private final Path path;
    private final SceneDatabase database;
    /** Of the file's bytes; tells whether it is still the same. Empty if there was no file. */
    private final byte[] digest;
    /** The file as it was opened, which later saves start from, too. */
    private final OriginalText text;

    private DatabaseFile(Path path, SceneDatabase database, byte[] digest, OriginalText text) {
        this.path = path;
        this.database = database;
        this.digest = digest;
        this.text = text;
    }

    /**
     * Reads a database.
     *
     * @throws SceneFileException if it is not valid, with every problem found
     * @throws IOException if it cannot be read
     */
    public static DatabaseFile open(Path path) throws SceneFileException, IOException {
        OriginalText text = OriginalText.read(path, ReadMonitor.NONE);
        if (!text.contents().isDatabase()) {
            throw new IOException(path + ": this is a scene, not a database; it can be added to one");
        }
        return new DatabaseFile(path, SceneDatabase.of(text.contents().scenes()), newDigest().digest(text.bytes()), text);
    }

    /** A database that is to be a new file; there is none yet. */
    public static DatabaseFile create(Path path) {
        Objects.requireNonNull(path, "path");
        return new DatabaseFile(path, SceneDatabase.EMPTY, new byte[0], OriginalText.ofDatabase(List.of()));
    }

    /**
     * Reads a database, changes it and writes it, while nobody else can.
     *
     * @param change what is to be done; may refuse with any exception, and nothing is written
     * @param from files that scenes are taken from, with their text
     * @throws SceneFileException as {@link #open}
     * @throws IOException if it cannot be read or written
     */
    @SuppressWarnings("try") // The lock is held, not used.
    public static DatabaseFile update(Path path, UnaryOperator<SceneDatabase> change, OriginalText... from) throws SceneFileException, IOException {
        Objects.requireNonNull(path, "path");
        Objects.requireNonNull(change, "change");
        List<OriginalText> texts = List.of(Objects.requireNonNull(from, "from"));
        requireFile(path);
        try (FileLock lock = FileLock.of(path, PATIENCE_MILLIS)) {
            DatabaseFile file = open(path);
            SceneDatabase changed = change.apply(file.database);
            return changed.equals(file.database) && texts.stream().noneMatch(OriginalText::isTyped) ? file : file.write(changed, texts);
        }
    }

    /**
     * As {@link #update(Path, UnaryOperator, OriginalText...)}; if the file is as it was when this was read or written, it need not be read once more.
     *
     * @throws SceneFileException as {@link #open}
     * @throws IOException if it cannot be read or written
     */
    @SuppressWarnings("try")
    public DatabaseFile update(UnaryOperator<SceneDatabase> change, OriginalText... from) throws SceneFileException, IOException {
        Objects.requireNonNull(change, "change");
        List<OriginalText> texts = List.of(Objects.requireNonNull(from, "from"));
        requireFile(path);
        try (FileLock lock = FileLock.of(path, PATIENCE_MILLIS)) {
            DatabaseFile file = Arrays.equals(digest(path), digest) ? this : open(path);
            SceneDatabase changed = change.apply(file.database);
            return changed.equals(file.database) && texts.stream().noneMatch(OriginalText::isTyped) ? file : file.write(changed, texts);
        }
    }

    public Path path() {
        return path;
    }

    /** What was in the file. */
    public SceneDatabase database() {
        return database;
    }

    /** The file as it was opened, to take scenes from it into other files. */
    public OriginalText text() {
        return text;
    }

    /**
     * Writes what this database has become. If the file has been changed by others since, both changes are put together, scene by scene.
     *
     * @param from files that scenes were taken from, with their text
     * @return the file as it is now, with the changes of others
     * @throws DatabaseConflictException if both changed the same scenes; nothing is written
     * @throws SceneFileException if others left it so that it cannot be read; nothing is written
     * @throws IOException if it cannot be written
     */
    @SuppressWarnings("try")
    public DatabaseFile save(SceneDatabase changed, OriginalText... from) throws SceneFileException, IOException {
        Objects.requireNonNull(changed, "changed");
        List<OriginalText> texts = List.of(Objects.requireNonNull(from, "from"));
        requireFile(path);
        try (FileLock lock = FileLock.of(path, PATIENCE_MILLIS)) {
            if (Arrays.equals(digest(path), digest)) {
                return write(changed, texts);
            }
            DatabaseFile theirs = Files.exists(path) ? open(path) : create(path);
            return theirs.write(together(changed, theirs.database), texts);
        }
    }

    /** A pipe gives once what it has, and keeps nothing. */
    static void requireFile(Path path) throws IOException {
        if (Files.isDirectory(path)) {
            throw new IOException(path + ": this is a directory, not a file");
        }
        if (Files.exists(path) && !Files.isRegularFile(path)) {
            throw new IOException(path + ": what is to be changed must be a file, not a pipe or a device");
        }
    }

    private SceneDatabase together(SceneDatabase changed, SceneDatabase theirs) throws DatabaseConflictException {
        try {
            return changed.rebase(database, theirs);
        } catch (IllegalArgumentException conflict) {
            throw new DatabaseConflictException(path + ": somebody else has changed this file since it was read, and " + conflict.getMessage()
                    + "; nothing is written", conflict);
        }
    }

    private DatabaseFile write(SceneDatabase changed, List<OriginalText> from) throws IOException {
        byte[] bytes = text.with(changed.scenes(), from);
        SceneFiles.write(path, bytes);
        // What has come along from elsewhere is to stay, too.
        OriginalText next = from.isEmpty() ? text : new OriginalText(path.toString(), bytes, new Contents(changed.scenes(), true));
        return new DatabaseFile(path, changed, newDigest().digest(bytes), next);
    }

    static byte[] digest(Path path) throws IOException {
        if (!Files.exists(path)) {
            return new byte[0];
        }
        MessageDigest digest = newDigest();
        try (InputStream input = new DigestInputStream(Files.newInputStream(path), digest)) {
            input.transferTo(OutputStream.nullOutputStream());
        }
        return digest.digest();
    }

    static MessageDigest newDigest() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("this Java lacks SHA-256, which every Java has", e);
        }
    }
}
