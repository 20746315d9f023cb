package cz.paprsek.fx.model.picture;

import cz.paprsek.asset.Assets;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Reader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Where pictures under way are kept until they are finished, for a program that ends before: a folder for each, which names the process that has it, so that what
 * another open window renders is left alone. Any number of threads may use it.
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

    private final Optional<Path> folder;
    private final long process;
    private final Supplier<Optional<Path>> source;
    private final Consumer<String> onFault;
    private final Duration quick;
    private final AtomicInteger count = new AtomicInteger();

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
        this(Optional.of(folder), ProcessHandle.current().pid(), QUICK, source, onFault);
    }

    UnfinishedPictures(Optional<Path> folder, long process, Duration quick, Supplier<Optional<Path>> source, Consumer<String> onFault) {
        this.folder = folder;
        this.process = process;
        this.quick = quick;
        this.source = source;
        this.onFault = onFault;
    }

    /** Keeps none. */
    public static UnfinishedPictures notKept() {
        return new UnfinishedPictures(Optional.empty(), 0, QUICK, Optional::empty, fault -> {});
    }

    /**
     * One that begins.
     *
     * @param scene that is edited
     * @param answers how it is rendered, by the names of the questions
     */
    public UnfinishedPicture begin(Scene scene, Map<String, String> answers) {
        Optional<Path> from = source.get();
        return new UnfinishedPicture(next(), room -> prepare(room, scene, answers, from), from.isPresent(), quick, this::hasRoom, onFault);
    }

    private Optional<Path> next() {
        return folder.map(all -> all.resolve(process + "-" + count.incrementAndGet()));
    }

    private static void prepare(Path room, Scene scene, Map<String, String> answers, Optional<Path> source) throws IOException {
        Files.createDirectories(room);
        SceneFiles.write(scene, room.resolve(SCENE));
        Properties said = new Properties();
        answers.forEach((name, answer) -> said.setProperty(ANSWER + name, answer));
        source.ifPresent(file -> said.setProperty(SOURCE, file.toString()));
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
        long together = 0;
        try (Stream<Path> files = Files.walk(folder.get(), 2)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                together += Files.size(file);
            }
        }
        return together + bytes <= MOST_BYTES;
    }

    /** The folders of pictures that processes left which are no more. What one of those left that had not begun is deleted. */
    public List<Path> left() throws IOException {
        if (folder.isEmpty() || !Files.isDirectory(folder.get())) {
            return List.of();
        }
        List<Path> left;
        try (Stream<Path> rooms = Files.list(folder.get())) {
            left = rooms.filter(this::isLeft).sorted().toList();
        }
        for (Path room : left) {
            if (!Files.exists(room.resolve(PICTURE))) {
                delete(room);
            }
        }
        return left.stream().filter(Files::isDirectory).toList();
    }

    private boolean isLeft(Path room) {
        String name = room.getFileName().toString();
        if (!name.matches("\\d{1,18}-\\d{1,9}") || !Files.isDirectory(room)) {
            return false;
        }
        long writer = Long.parseLong(name.substring(0, name.indexOf('-')));
        return writer != process && ProcessHandle.of(writer).filter(ProcessHandle::isAlive).isEmpty();
    }

    /**
     * Takes one that was left for this process.
     *
     * @throws IOException if it cannot be read, or another process was quicker
     * @throws SceneFileException if its scene is not valid
     */
    public Resumed take(Path left) throws IOException, SceneFileException {
        Path room = next().orElseThrow();
        Files.move(left, room);
        Properties said = new Properties();
        try (Reader reader = Files.newBufferedReader(room.resolve(PICTURE))) {
            said.load(reader);
        } catch (IllegalArgumentException garbled) {
            throw new IOException(room.resolve(PICTURE) + ": is damaged", garbled);
        }
        Optional<Path> from = source(said);
        Scene scene = SceneFiles.read(room.resolve(SCENE), Map.of(), from.map(Assets::beside).orElseGet(Assets::none));
        Map<String, String> answers = said.stringPropertyNames().stream().filter(name -> name.startsWith(ANSWER))
                .collect(Collectors.toUnmodifiableMap(name -> name.substring(ANSWER.length()), said::getProperty));
        UnfinishedPicture kept = new UnfinishedPicture(Optional.of(room), itself -> {}, from.isPresent(), quick, bytes -> true, onFault);
        return new Resumed(kept, scene, from.map(Assets::beside).orElseGet(Assets::none), answers);
    }

    private static Optional<Path> source(Properties said) throws IOException {
        try {
            return Optional.ofNullable(said.getProperty(SOURCE)).map(Path::of);
        } catch (InvalidPathException e) {
            throw new IOException(said.getProperty(SOURCE) + ": is no file's name here", e);
        }
    }

    /** Deletes all that is kept of one. */
    public static void delete(Path room) throws IOException {
        if (Files.isDirectory(room)) {
            try (Stream<Path> files = Files.list(room)) {
                for (Path file : files.toList()) {
                    Files.delete(file);
                }
            }
            Files.delete(room);
        }
    }
}
