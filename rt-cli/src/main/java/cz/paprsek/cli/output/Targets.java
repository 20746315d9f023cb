package cz.paprsek.cli.output;

import cz.paprsek.cli.input.SceneSource;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.image.ImageFormat;
import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Finds a file for every picture, before the first is computed: that something cannot be written should not come out an hour later.
 *
 * @param output what the user gave: a file, a directory, a pattern with <code>{name}</code>, or {@code -} for standard output
 * @param format what the user gave
 * @param raw whether text files are to hold linear luminance
 */
public record Targets(Optional<String> output, Optional<ImageFormat> format, boolean raw) {
    public static final String NAME = "{name}";

    /** @throws WrongUsage if two pictures would go to one file, or a file cannot be written */
    public List<Target> of(List<SceneSource> scenes) {
        if (scenes.size() > 1 && output.isPresent() && !isDirectory() && !isPattern()) {
            throw new WrongUsage(scenes.size() + " scenes do not fit into " + shown()
                    + "; name a directory, or a pattern such as " + NAME + ".png");
        }
        List<Target> targets = scenes.stream().map(this::of).toList();
        check(targets);
        return targets;
    }

    private Target of(SceneSource scene) {
        if (output.equals(Optional.of("-"))) {
            return new Target(scene, Optional.empty(), format(Optional.empty()));
        }
        String name = scene.name();
        if (output.isEmpty() || isDirectory()) {
            ImageFormat chosen = format(Optional.empty());
            return new Target(scene, Optional.of(path(output.orElse("")).resolve(name + "." + chosen.extension())), chosen);
        }
        Path file = path(output.get().replace(NAME, name));
        return new Target(scene, Optional.of(file), format(Optional.of(file)));
    }

    private ImageFormat format(Optional<Path> file) {
        ImageFormat chosen = format.orElseGet(() -> file.map(Targets::byEnding).orElse(raw ? ImageFormat.RAW : ImageFormat.PNG));
        if (!raw) {
            return chosen;
        }
        if (chosen != ImageFormat.TXT && chosen != ImageFormat.RAW) {
            throw new WrongUsage("--raw is for text, not for " + chosen.extension() + "; linear light is also in pfm and ppm16");
        }
        return ImageFormat.RAW;
    }

    private static ImageFormat byEnding(Path file) {
        return ImageFormat.ofFile(file.toString()).orElseThrow(() -> new WrongUsage("cannot tell the format of '" + file + "': let it end in one of "
                + ImageFormat.all() + ", give --format, or end a directory's name in /"));
    }

    private void check(List<Target> targets) {
        Map<Path, Path> taken = new HashMap<>();
        targets.forEach(target -> taken.put(absolute(target.scene()), target.scene()));
        for (Target target : targets) {
            target.file().ifPresent(file -> {
                Path other = taken.put(absolute(file), target.scene());
                if (other != null) {
                    throw new WrongUsage(absolute(other).equals(absolute(file))
                            ? "the picture of " + target.scene() + " would overwrite the scene " + other
                            : other + " and " + target.scene() + " would both be rendered to " + file + "; render them one by one");
                }
                makeFolder(file);
            });
        }
    }

    private void makeFolder(Path file) {
        Path folder = Objects.requireNonNull(file.toAbsolutePath().getParent());
        try {
            if (isDirectory() || isPattern()) {
                Files.createDirectories(folder);
            }
        } catch (IOException e) {
            throw new WrongUsage("cannot make the directory " + folder);
        }
        if (!Files.isDirectory(folder)) {
            throw new WrongUsage("there is no directory " + folder + " to write " + file + " to");
        }
        if (Files.isDirectory(file)) {
            throw new WrongUsage("cannot write a picture to " + file + ": this is a directory");
        }
    }

    private boolean isPattern() {
        return shown().contains(NAME);
    }

    private boolean isDirectory() {
        String text = shown();
        return !text.isEmpty() && (text.endsWith("/") || text.endsWith(FileSystems.getDefault().getSeparator())
                || (!isPattern() && Files.isDirectory(path(text))));
    }

    private String shown() {
        return output.orElse("");
    }

    private static Path absolute(Path file) {
        return file.toAbsolutePath().normalize();
    }

    private static Path path(String text) {
        try {
            return Path.of(text);
        } catch (InvalidPathException e) {
            throw new WrongUsage("'" + text + "' is not a valid file name: " + e.getReason());
        }
    }
}
