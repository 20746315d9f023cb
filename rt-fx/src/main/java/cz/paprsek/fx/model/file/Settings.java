package cz.paprsek.fx.model.file;

import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Failures;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Reader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.function.Consumer;

/** What the program remembers of a user: language, theme, recent files. A file of its own; without it, everything is as at the first start. */
public final class Settings {
    private static final int MOST_RECENT = 10;

    private final Path file;
    private final Consumer<String> onFault;
    private final Properties values = new Properties();

    /** @param onFault is told in a sentence if the settings cannot be read or written */
    public Settings(Path folder, Consumer<String> onFault) {
        this.file = folder.resolve("editor.properties");
        this.onFault = onFault;
        if (Files.exists(file)) {
            try (Reader reader = Files.newBufferedReader(file)) {
                values.load(reader);
            } catch (IOException | IllegalArgumentException e) {
                onFault.accept(file + ": the settings cannot be read: " + Failures.sentence(e));
            }
        }
    }

    /** Where programs of this system keep their settings. */
    public static Path folder(Map<String, String> environment, String systemName, Path home) {
        if (systemName.startsWith("Windows")) {
            return Optional.ofNullable(environment.get("APPDATA")).map(Path::of).orElse(home).resolve("Paprsek");
        }
        if (systemName.startsWith("Mac")) {
            return home.resolve("Library/Application Support/Paprsek");
        }
        return Optional.ofNullable(environment.get("XDG_CONFIG_HOME")).filter(value -> !value.isEmpty()).map(Path::of)
                .orElse(home.resolve(".config")).resolve("paprsek");
    }

    public Optional<String> get(String key) {
        return Optional.ofNullable(values.getProperty(key));
    }

    public void set(String key, String value) {
        values.setProperty(key, value);
        write();
    }

    /** Files opened or saved last, the newest first. */
    public List<Path> recent() {
        List<Path> files = new ArrayList<>();
        for (int i = 0; i < MOST_RECENT; i++) {
            get("recent." + i).ifPresent(text -> {
                try {
                    files.add(Path.of(text));
                } catch (InvalidPathException otherSystem) {
                    onFault.accept(file + ": not a path on this system: " + text);
                }
            });
        }
        return files;
    }

    /** Puts a file at the top of the recent ones. */
    public void addRecent(Path opened) {
        List<Path> files = recent();
        files.remove(opened);
        files.add(0, opened);
        for (int i = 0; i < Math.min(MOST_RECENT, files.size()); i++) {
            values.setProperty("recent." + i, files.get(i).toString());
        }
        write();
    }

    private void write() {
        try {
            Files.createDirectories(file.toAbsolutePath().getParent());
            AtomicFile.write(file, out -> {
                Writer writer = new OutputStreamWriter(out, StandardCharsets.UTF_8);
                values.store(writer, null);
                writer.flush();
            });
        } catch (IOException e) {
            onFault.accept("the settings cannot be written: " + Failures.sentence(e));
        }
    }
}
