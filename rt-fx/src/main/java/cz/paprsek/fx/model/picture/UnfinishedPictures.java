package cz.paprsek.fx.model.picture;

import cz.paprsek.asset.Assets;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.FileLock;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Reader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Properties;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Where pictures under way are kept until they are finished, for a program that ends before: a folder for each, of a name that comes but once, with a lock beside it
 * as long as a process has it, so that what another open window renders is left alone, be it on another machine. Any number of threads may use it.
 */
public final class UnfinishedPictures {
    /** How many bytes all of them may have together: 512 MiB. */
    private static final long MOST_BYTES = 1L << 29;
    /** What takes no longer is soon made again. */
    private static final Duration QUICK = Duration.ofSeconds(3);
    private static final String SCENE = "scene.xml";
    private static final String PICTURE = "picture.properties";
    private static final String ANSWER = "answer.";
    private static final String SOURCE = "source";
    private static final String NAME = "name";
    private static final Pattern ROOM = Pattern.compile("[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}");

    private final Optional<Path> folder;
    private final Supplier<Optional<Path>> source;
    private final Consumer<String> onFault;
    private final Duration quick;

    /**
     * One that goes on.
     *
     * @param kept what is done of it
     * @param scene as it was
     * @param assets the files beside where that was kept
     * @param answers how it is rendered, by the names of the questions
     */
    public record Resumed(UnfinishedPicture kept, Scene scene, Assets assets, Map<String, String> answers) {}

    /**
     * In a folder of the program's.
     *
     * @param folder made when it is needed
     * @param source the file of the scene that is edited, if it has one
     * @param onFault is told in a sentence why one is not kept, on any thread
     */
    public UnfinishedPictures(Path folder, Supplier<Optional<Path>> source, Consumer<String> onFault) {
        this(Optional.of(folder), QUICK, source, onFault);
    }

    UnfinishedPictures(Optional<Path> folder, Duration quick, Supplier<Optional<Path>> source, Consumer<String> onFault) {
        this.folder = folder;
        this.quick = quick;
        this.source = source;
        this.onFault = onFault;
    }

    /** Keeps none. */
    public static UnfinishedPictures notKept() {
        return new UnfinishedPictures(Optional.empty(), QUICK, Optional::empty, fault -> {});
    }

    /**
     * One that begins.
     *
     * @param scene that is edited
     * @param answers how it is rendered, by the names of the questions
     */
    public UnfinishedPicture begin(Scene scene, Map<String, String> answers) {
        Optional<Path> from = source.get();
        return new UnfinishedPicture(folder.map(all -> all.resolve(UUID.randomUUID().toString())), Optional.empty(), room -> prepare(room, scene, answers, from), from.isPresent(), quick, this::hasRoom, onFault);
    }

    /** Has others see that the picture is under way, before there is anything to see of it. */
    private static FileLock prepare(Path room, Scene scene, Map<String, String> answers, Optional<Path> source) throws IOException {
        Files.createDirectories(Objects.requireNonNull(room.getParent()));
        FileLock lock = lock(room);
        boolean isWritten = false;
        try {
            write(room, scene, answers, source);
            isWritten = true;
            return lock;
        } finally {
            if (!isWritten) {
                lock.close();
            }
        }
    }

    /**
     * By the one name that the room has, however the way to it is written.
     *
     * @throws IOException also if somebody has it
     */
    private static FileLock lock(Path room) throws IOException {
        return FileLock.of(Objects.requireNonNull(room.toAbsolutePath().getParent()).toRealPath().resolve(room.getFileName()), 0);
    }

    private static void write(Path room, Scene scene, Map<String, String> answers, Optional<Path> source) throws IOException {
        Files.createDirectories(room);
        SceneFiles.write(scene, room.resolve(SCENE));
        Properties said = new Properties();
        answers.forEach((name, answer) -> said.setProperty(ANSWER + name, answer));
        source.ifPresent(file -> said.setProperty(SOURCE, file.toString()));
        said.setProperty(NAME, scene.name());
        // The last to be written: without it, a picture had not begun.
        AtomicFile.write(room.resolve(PICTURE), out -> {
            Writer writer = new OutputStreamWriter(out, StandardCharsets.UTF_8);
            said.store(writer, null);
            writer.flush();
        });
    }

    private boolean hasRoom(long bytes) throws IOException {
        if (bytes > MOST_BYTES || folder.isEmpty() || !Files.isDirectory(folder.get())) {
            return bytes <= MOST_BYTES;
        }
        AtomicLong together = new AtomicLong(bytes);
        Files.walkFileTree(folder.get(), Set.of(), 2, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                together.addAndGet(attributes.isRegularFile() ? attributes.size() : 0);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFileFailed(Path file, IOException gone) {
                // Another window has finished its picture.
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult postVisitDirectory(Path room, @Nullable IOException gone) {
                return FileVisitResult.CONTINUE;
            }
        });
        return together.get() <= MOST_BYTES;
    }

    /** The folders of pictures that nobody is at work on. What is there of one that had not begun is deleted. */
    public List<Path> left() throws IOException {
        if (folder.isEmpty() || !Files.isDirectory(folder.get())) {
            return List.of();
        }
        List<Path> rooms;
        try (Stream<Path> all = Files.list(folder.get())) {
            rooms = all.filter(room -> ROOM.matcher(room.getFileName().toString()).matches() && Files.isDirectory(room)).sorted().toList();
        }
        List<Path> left = new ArrayList<>();
        for (Path room : rooms) {
            if (isLeft(room)) {
                left.add(room);
            }
        }
        return left;
    }

    private static boolean isLeft(Path room) {
        try (FileLock nobodyElse = lock(room)) {
            Objects.requireNonNull(nobodyElse);
            if (!Files.exists(room.resolve(PICTURE))) {
                delete(room);
            }
            return Files.isDirectory(room);
        } catch (IOException taken) {
            return false;
        }
    }

    /**
     * Takes one that was left for this process. What cannot be read stays where it is.
     *
     * @throws IOException if it cannot be read, or another process was quicker
     * @throws SceneFileException if its scene is not valid
     */
    public Resumed take(Path left) throws IOException, SceneFileException {
        FileLock lock = taken(left);
        boolean isRead = false;
        try {
            Resumed resumed = read(left, lock);
            isRead = true;
            return resumed;
        } finally {
            if (!isRead) {
                lock.close();
            }
        }
    }

    private static FileLock taken(Path left) throws IOException {
        try {
            return lock(left);
        } catch (IOException e) {
            throw new IOException(left + ": another render is at work on this picture", e);
        }
    }

    /** What the scene is called of which one that was left is a picture; empty if it has no name, or that cannot be read. */
    public static String name(Path left) {
        try {
            return said(left).getProperty(NAME, "");
        } catch (IOException damaged) {
            // Who takes it says what is wrong.
            return "";
        }
    }

    private static Properties said(Path room) throws IOException {
        Properties said = new Properties();
        try (Reader reader = Files.newBufferedReader(room.resolve(PICTURE))) {
            said.load(reader);
        } catch (IllegalArgumentException garbled) {
            throw new IOException(room.resolve(PICTURE) + ": is damaged", garbled);
        }
        return said;
    }

    private Resumed read(Path room, FileLock lock) throws IOException, SceneFileException {
        Properties said = said(room);
        Optional<Path> from = source(said);
        Scene scene = SceneFiles.read(room.resolve(SCENE), Map.of(), from.map(Assets::beside).orElseGet(Assets::none));
        Map<String, String> answers = said.stringPropertyNames().stream().filter(name -> name.startsWith(ANSWER))
                .collect(Collectors.toUnmodifiableMap(name -> name.substring(ANSWER.length()), said::getProperty));
        UnfinishedPicture kept = new UnfinishedPicture(Optional.of(room), Optional.of(lock), itself -> lock, from.isPresent(), quick, bytes -> true, onFault);
        return new Resumed(kept, scene, from.map(Assets::beside).orElseGet(Assets::none), answers);
    }

    private static Optional<Path> source(Properties said) throws IOException {
        try {
            return Optional.ofNullable(said.getProperty(SOURCE)).map(Path::of);
        } catch (InvalidPathException e) {
            throw new IOException(said.getProperty(SOURCE) + ": is no file's name here", e);
        }
    }

    /**
     * Deletes one that was left.
     *
     * @throws IOException if that cannot be, or another process is at work on it
     */
    public void discard(Path left) throws IOException {
        try (FileLock nobodyElse = taken(left)) {
            Objects.requireNonNull(nobodyElse);
            delete(left);
        }
    }

    /** Deletes all that is kept of one. */
    static void delete(Path room) throws IOException {
        if (Files.isDirectory(room)) {
            try (Stream<Path> files = Files.list(room)) {
                for (Path file : files.toList()) {
                    Files.deleteIfExists(file);
                }
            }
            Files.deleteIfExists(room);
        }
    }
}
