package cz.paprsek.cli.bench;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.Belongings;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.pov.PovFiles;
import cz.paprsek.scene.Scene;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The program POV-Ray on this machine. */
final class PovRay {
    private static final Pattern VERSION = Pattern.compile("(?:POV-Ray|Ray Tracer Version) (\\d[\\w.]*)");

    private static final Pattern TRACE_TIME = Pattern.compile("Trace Time:[^\\n]*\\s+using \\d+ thread\\(s\\) with ([\\d.]+) CPU-seconds");

    private final Path program;
    private final String version;

    private PovRay(Path program, String version) {
        this.program = program;
        this.version = version;
    }

    /**
     * What came of a run.
     *
     * @param image linear light in 65535 steps, clamped to 0–1
     * @param log what the program said, with the times it took
     */
    record Result(Image image, String log) {
        /** The processor time that all its threads together spent tracing; not a number if the log does not say. */
        double traceCpuSeconds() {
            Matcher found = TRACE_TIME.matcher(log);
            return found.find() ? Double.parseDouble(found.group(1)) : Double.NaN;
        }
    }

    /** The {@code povray} that the search path leads to, if there is one and it runs. */
    static Optional<PovRay> installed() {
        for (String folder : Objects.requireNonNullElse(System.getenv("PATH"), "").split(Pattern.quote(File.pathSeparator), -1)) {
            Path program = Path.of(folder.isEmpty() ? "." : folder, "povray");
            if (Files.isExecutable(program) && Files.isRegularFile(program)) {
                return version(program).map(version -> new PovRay(program, version));
            }
        }
        return Optional.empty();
    }

    /** Its version: {@code 3.7.0.10}. */
    String version() {
        return version;
    }

    /**
     * The command that renders a scene file to a 16-bit PNG of linear light, one ray a pixel. On many systems POV-Ray reads and writes only
     * below the working directory and the one for temporary files.
     *
     * @param scene the scene's file, relative to the working directory
     * @param picture the picture's file, relative to the working directory
     */
    List<String> command(String scene, String picture, int width, int height, int threads) {
        return List.of(program.toString(), "+I" + scene, "+O" + picture, "+W" + width, "+H" + height,
                "+FN16", "File_Gamma=1.0", "-A", "-D", "-GD", "-GR", "+WT" + threads);
    }

    /**
     * Renders a scene at the size it asks for, with one ray a pixel, and reads the picture.
     *
     * @throws IOException with the last lines of the program's own words, if it fails
     * @throws InterruptedException if the thread is interrupted, which ends the program
     */
    Result render(Scene scene, int threads) throws IOException, InterruptedException {
        return render(scene, Assets.none(), threads);
    }

    /** As above, of a scene with pictures. */
    Result render(Scene scene, Assets assets, int threads) throws IOException, InterruptedException {
        Path picture = Files.createTempFile("paprsek-pov", ".png");
        try {
            String log = render(scene, assets, threads, picture);
            return new Result(ImageFiles.read(picture), log);
        } finally {
            Files.deleteIfExists(picture);
        }
    }

    /**
     * Exports a scene to a folder of its own, renders it at the size it asks for with one ray a pixel, and puts the picture into a file.
     *
     * @param assets where its pictures come from, which are copied beside it
     * @param picture becomes a 16-bit PNG of linear light
     * @return what the program said, with the times it took
     * @throws IOException as above
     * @throws InterruptedException as above
     */
    String render(Scene scene, Assets assets, int threads, Path picture) throws IOException, InterruptedException {
        try (TemporaryFolder temporary = TemporaryFolder.create("paprsek-pov")) {
            Path folder = temporary.path();
            PovFiles.write(scene, folder.resolve("scene.pov"));
            new Belongings(scene, assets).takeUnpacked(folder.resolve("scene.pov"), PovFiles::nameOf);
            String log = run(folder, command("scene.pov", "scene.png", scene.settings().width(), scene.settings().height(), threads));
            Path made = folder.resolve("scene.png");
            if (!Files.exists(made)) {
                throw new IOException("POV-Ray wrote no picture: " + lastLines(log));
            }
            AtomicFile.write(picture, out -> Files.copy(made, out));
            return log;
        }
    }

    /**
     * Renders a scene in the words of POV-Ray, with one ray a pixel, and reads the picture.
     *
     * @throws IOException as above
     * @throws InterruptedException as above
     */
    Image render(String words, int width, int height) throws IOException, InterruptedException {
        try (TemporaryFolder folder = TemporaryFolder.create("paprsek-pov")) {
            Files.writeString(folder.path().resolve("scene.pov"), words);
            run(folder.path(), command("scene.pov", "scene.png", width, height, 1));
            return ImageFiles.read(folder.path().resolve("scene.png"));
        }
    }

    private static Optional<String> version(Path program) {
        try {
            Matcher found = VERSION.matcher(run(Path.of(System.getProperty("java.io.tmpdir")), List.of(program.toString(), "--version")));
            return found.find() ? Optional.of(found.group(1)) : Optional.empty();
        } catch (IOException cannotRun) {
            return Optional.empty();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return Optional.empty();
        }
    }

    private static String run(Path folder, List<String> command) throws IOException, InterruptedException {
        Path log = Files.createTempFile("paprsek-pov", ".log");
        Process process = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).redirectOutput(log.toFile()).start();
        try {
            process.getOutputStream().close();
            int code = process.waitFor();
            String words = Files.readString(log, StandardCharsets.ISO_8859_1);
            if (code != 0) {
                throw new IOException("POV-Ray failed with exit code " + code + ": " + lastLines(words));
            }
            return words;
        } finally {
            process.destroyForcibly();
            Files.deleteIfExists(log);
        }
    }

    private static String lastLines(String log) {
        List<String> lines = log.lines().map(String::strip).filter(line -> !line.isEmpty()).toList();
        return String.join(" / ", lines.subList(Math.max(0, lines.size() - 6), lines.size()));
    }
}
