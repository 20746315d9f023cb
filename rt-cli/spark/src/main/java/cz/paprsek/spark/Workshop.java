package cz.paprsek.spark;

import cz.paprsek.cli.Embedded;
import cz.paprsek.cli.shard.Piecework;
import cz.paprsek.render.Tile;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.apache.spark.SparkFiles;

/** A machine at work: the scene that it has read, and a folder of its own. Used by as many threads as it has tasks. */
final class Workshop {
    private final Job job;
    private final Path folder;
    private final Piecework piecework;
    private final List<Tile> tiles;

    private Workshop(Job job, Path folder, Piecework piecework) {
        this.job = job;
        this.folder = folder;
        this.piecework = piecework;
        tiles = piecework.tiles(job.side());
    }

    /**
     * Reads the scene.
     *
     * @throws IOException if it cannot be read here, or is not the same as where it came from
     */
    static Workshop open(Job job) throws IOException {
        Path folder = Files.createTempDirectory(Path.of(SparkFiles.getRootDirectory()).toAbsolutePath().normalize(), "paprsek");
        Path beside = Files.createDirectory(folder.resolve("scene"));
        for (Map.Entry<String, byte[]> file : job.files().entrySet()) {
            Path place = beside.resolve(file.getKey()).normalize();
            if (!place.startsWith(beside)) {
                throw new IOException(file.getKey() + " does not lie beside the scene");
            }
            Files.createDirectories(place.getParent());
            Files.write(place, file.getValue());
        }
        List<String> words = Words.elsewhere(job.order(), job.scene(), beside.resolve(job.scene()).toString());
        Piecework piecework = ordered(job.order(), words);
        if (!piecework.card().equals(job.card())) {
            throw new IOException("this machine reads another scene, or has another version, than where the scene came from");
        }
        return new Workshop(job, folder, piecework);
    }

    /**
     * Gives an order.
     *
     * @param known words that parts tell of
     * @throws Refused if it is refused
     */
    static Piecework ordered(List<String> known, List<String> words) throws IOException {
        ByteArrayOutputStream results = new ByteArrayOutputStream();
        StringWriter told = new StringWriter();
        Piecework piecework = new Piecework(known);
        int code = Embedded.order(results, new PrintWriter(told), words, piecework);
        if (!piecework.isOrdered()) {
            throw new Refused(results.toString(StandardCharsets.UTF_8) + told, code);
        }
        return piecework;
    }

    /** A command was refused. */
    static final class Refused extends IOException {
        private static final long serialVersionUID = 1;

        private final int code;

        Refused(String told, int code) {
            super(told.strip());
            this.code = code;
        }

        int code() {
            return code;
        }
    }

    /**
     * Makes tiles, those that are not there.
     *
     * @param cancelled whether nobody wants them any more
     * @return how many were made
     */
    int work(Unit unit, BooleanSupplier cancelled) throws IOException {
        if (job.places().isFinished(unit.frame())) {
            return 0;
        }
        Path own = Files.createTempDirectory(folder, "task");
        int made = 0;
        try {
            for (Tile tile : tiles.subList(unit.from(), unit.to())) {
                Path part = Piecework.part(own, unit.frame(), tile);
                if (!isThere(unit.frame(), tile, part)) {
                    piecework.make(own, unit.frame(), tile, cancelled);
                    job.places().keep(unit.frame(), name(part), part);
                    made++;
                }
            }
            if (unit.isWhole()) {
                merge(unit.frame(), own);
            }
        } finally {
            delete(own);
        }
        return made;
    }

    /** Puts the picture of a frame together, whose parts are all there. */
    void merge(int frame) throws IOException {
        if (job.places().isFinished(frame)) {
            return;
        }
        Path own = Files.createTempDirectory(folder, "task");
        try {
            for (Tile tile : tiles) {
                Path part = Piecework.part(own, frame, tile);
                Files.createDirectories(part.getParent());
                if (!isFetched(frame, part)) {
                    return;
                }
            }
            merge(frame, own);
        } finally {
            delete(own);
        }
    }

    /** Fetches a part that must be there; false if another attempt at the frame has finished it meanwhile, which removes its parts. */
    private boolean isFetched(int frame, Path part) throws IOException {
        IOException failure = new IOException(name(part) + " of frame " + frame + " has gone");
        try {
            if (job.places().fetch(frame, name(part), part)) {
                return true;
            }
        } catch (IOException brokenOff) {
            failure = brokenOff;
        }
        if (!job.places().isFinished(frame)) {
            throw failure;
        }
        return false;
    }

    private void merge(int frame, Path parts) throws IOException {
        Path made = Files.createDirectory(parts.resolve("made"));
        boolean isFilm = !piecework.span().isStill();
        List<String> words = new ArrayList<>(List.of("merge", parts.toString(), "-o", made.resolve((isFilm ? Places.FRAME : "0") + "." + job.ending()).toString(), "--quiet"));
        if (isFilm) {
            words.addAll(List.of("--frames", frame + "-" + frame));
        }
        words.addAll(job.written());
        StringWriter told = new StringWriter();
        int code = Embedded.run(OutputStream.nullOutputStream(), new PrintWriter(told), words);
        if (code != 0) {
            throw new Refused(told.toString(), code);
        }
        try (Stream<Path> all = Files.list(made)) {
            Path file = all.findFirst().orElseThrow();
            String name = file.getFileName().toString();
            job.places().finish(frame, name.substring(0, name.lastIndexOf('.')), file);
        }
    }

    private boolean isThere(int frame, Tile tile, Path part) throws IOException {
        Files.createDirectories(part.getParent());
        return job.places().fetch(frame, name(part), part) && piecework.isPart(part, frame, tile);
    }

    private static String name(Path part) {
        return part.getFileName().toString();
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(each);
            }
        }
    }
}
