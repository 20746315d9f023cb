package cz.paprsek.cli.bench;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.scene.Scene;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;

/** Mitsuba 3, if Python has it: one process, which renders as often as it is asked. */
final class Mitsuba implements Rival {
    private static final List<String> PYTHONS = List.of("python3", "python");
    private static final String SCRIPT = "bench.py";
    private static final int PATIENCE_MILLIS = 2;

    private final Stop stop;
    private final TemporaryFolder folder;
    private final Process process;
    private final BufferedReader answers;
    private final String version;
    private String loaded = "";

    /**
     * What it answers.
     *
     * @param seconds of all processors
     * @param whole of paths the mean of all channels of all pixels, of rays how many have hit something
     */
    record Rendered(double seconds, double whole) {
        /** @throws IOException if it is a line of something else, such as what a library has to say */
        static Rendered read(String answer) throws IOException {
            int blank = answer.indexOf(' ');
            try {
                return new Rendered(Double.parseDouble(answer.substring(0, Math.max(0, blank))), Double.parseDouble(answer.substring(blank + 1)));
            } catch (NumberFormatException e) {
                throw new IOException("Mitsuba answers \"" + answer + "\" where its time should stand", e);
            }
        }
    }

    /**
     * Starts it.
     *
     * @throws WrongUsage if there is no Mitsuba
     */
    Mitsuba(int threads, Stop stop) throws IOException {
        this.stop = stop;
        // A stop waits until the folder is gone.
        stop.oweLastWords();
        this.folder = TemporaryFolder.create("paprsek-mitsuba");
        try (InputStream script = Objects.requireNonNull(Mitsuba.class.getResourceAsStream(SCRIPT))) {
            Files.copy(script, folder.path().resolve(SCRIPT));
        }
        try {
            process = start(threads);
        } catch (IOException e) {
            folder.close();
            throw missing("there is no program \"" + PYTHONS.get(0) + "\" on the search path");
        }
        answers = process.inputReader(StandardCharsets.UTF_8);
        try {
            version = answer();
        } catch (InterruptedIOException e) {
            close();
            throw e;
        } catch (IOException e) {
            close();
            throw missing("Python says: " + e.getMessage());
        }
    }

    private static WrongUsage missing(String why) {
        return new WrongUsage("--against mitsuba needs Python with Mitsuba 3 (pip install mitsuba), but " + why);
    }

    private Process start(int threads) throws IOException {
        IOException none = new IOException();
        for (String python : PYTHONS) {
            try {
                return new ProcessBuilder(python, SCRIPT, Integer.toString(threads)).directory(folder.path().toFile()).redirectError(log().toFile()).start();
            } catch (IOException e) {
                none = e;
            }
        }
        throw none;
    }

    private Path log() {
        return folder.path().resolve("log.txt");
    }

    @Override
    public String version() {
        return label() + " " + version;
    }

    @Override
    public String label() {
        return "Mitsuba";
    }

    @Override
    public boolean warmsUp() {
        return true;
    }

    @Override
    public double seconds(String name, Scene scene, int threads) throws IOException {
        return render(name, scene).seconds();
    }

    /** Renders a scene, which is handed over first if it is another one than the last. */
    Rendered render(String name, Scene scene) throws IOException {
        if (!loaded.equals(name)) {
            MitsubaScene.write(scene, folder.path());
            ask(folder.path().toString());
            loaded = name;
        }
        return Rendered.read(ask(""));
    }

    private String ask(String line) throws IOException {
        process.getOutputStream().write((line + "\n").getBytes(StandardCharsets.UTF_8));
        process.getOutputStream().flush();
        return answer();
    }

    /** What it says next, of which a reader could not be told to stop. */
    private String answer() throws IOException {
        try {
            while (!answers.ready()) {
                if (stop.requested()) {
                    throw new InterruptedIOException("interrupted");
                }
                if (!process.isAlive() && !answers.ready()) {
                    throw new IOException(lastWords());
                }
                Thread.sleep(PATIENCE_MILLIS);
            }
        } catch (InterruptedException e) {
            throw new InterruptedIOException("interrupted");
        }
        return answers.readLine();
    }

    private String lastWords() throws IOException {
        List<String> lines = Files.readString(log(), StandardCharsets.ISO_8859_1).lines().filter(line -> !line.isBlank()).toList();
        return lines.isEmpty() ? "nothing, exit code " + process.exitValue() : lines.get(lines.size() - 1).strip();
    }

    @Override
    public void close() throws IOException {
        process.destroyForcibly();
        try {
            process.waitFor();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        folder.close();
    }
}
