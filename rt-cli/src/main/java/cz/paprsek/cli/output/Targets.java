package cz.paprsek.cli.output;

import cz.paprsek.cli.input.Originals;
import cz.paprsek.cli.input.SceneSource;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.Words;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Failures;
import cz.paprsek.io.Folders;
import cz.paprsek.text.Similar;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Finds a file for every picture, before the first is computed: that something cannot be written should not come out an hour later.
 *
 * @param output what the user gave: a file, a directory, a pattern with <code>{name}</code>, or {@code -} for standard output
 * @param format what the user gave
 * @param raw whether text files are to hold linear luminance
 */
public record Targets(Optional<String> output, Optional<ImageFormat> format, boolean raw) {
    public static final String NAME = "{name}";
    private static final String FOLDER = "{dir}";
    private static final List<String> KNOWN = List.of(NAME, FOLDER, Target.FRAME);
    private static final Pattern PLACE = Pattern.compile("\\{\\w+}");

    /** @throws WrongUsage if what the user gave is no name, or has an unknown <code>{…}</code> in it */
    public Targets {
        output.ifPresent(Targets::check);
    }

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
            return new Target(scene, Optional.empty(), format(Optional.empty()), "");
        }
        if (output.isEmpty() || isDirectory()) {
            ImageFormat chosen = format(Optional.empty());
            String folder = filled(shown(), scene);
            String separator = folder.isEmpty() || folder.endsWith("/") || folder.endsWith(FileSystems.getDefault().getSeparator()) ? "" : "/";
            return target(scene, folder + separator + scene.name() + "." + chosen.extension(), chosen);
        }
        String file = filled(output.get(), scene);
        return target(scene, file, format(Optional.of(file)));
    }

    /** A name that this system cannot write down is refused when its turn comes: the other pictures can be made. */
    private static Target target(SceneSource scene, String file, ImageFormat chosen) {
        try {
            return new Target(scene, Optional.of(Words.path(file)), chosen, "");
        } catch (WrongUsage unspeakable) {
            return new Target(scene, Optional.empty(), chosen, String.valueOf(unspeakable.getMessage()));
        }
    }

    private static String filled(String pattern, SceneSource scene) {
        Path folder = scene.file().getParent();
        return pattern.replace(NAME, scene.name()).replace(FOLDER, folder == null ? "." : folder.toString());
    }

    private ImageFormat format(Optional<String> file) {
        ImageFormat chosen = format.orElseGet(() -> file.map(Targets::byEnding).orElse(raw ? ImageFormat.RAW : ImageFormat.PNG));
        if (!raw) {
            return chosen;
        }
        if (chosen != ImageFormat.TXT && chosen != ImageFormat.RAW) {
            throw new WrongUsage("--raw is for text, not for " + chosen.extension() + "; linear light is also in pfm and ppm16");
        }
        return ImageFormat.RAW;
    }

    private static ImageFormat byEnding(String file) {
        return ImageFormat.ofFile(file).orElseThrow(() -> new WrongUsage("cannot tell the format of '" + file + "': let it end in one of "
                + ImageFormat.all() + ", give --format, or end a directory's name in /"));
    }

    private static void check(String output) {
        if (output.isEmpty()) {
            throw new WrongUsage("an empty name stands where the picture's should");
        }
        if (output.substring(0, Math.max(output.lastIndexOf('/'), output.lastIndexOf(FileSystems.getDefault().getSeparator())) + 1).contains(Target.FRAME)) {
            throw new WrongUsage("'" + output + "': " + Target.FRAME + " can stand in the name of a picture, not in that of a folder");
        }
        Matcher place = PLACE.matcher(output);
        while (place.find()) {
            if (!KNOWN.contains(place.group())) {
                throw new WrongUsage("'" + output + "': there is no " + place.group() + Similar.suggestion(place.group(), KNOWN)
                        + (Similar.nearest(place.group(), KNOWN).isEmpty() ? "; there are " + String.join(" and ", KNOWN) : ""));
            }
        }
    }

    private void check(List<Target> targets) {
        Map<Path, Path> taken = new HashMap<>();
        targets.forEach(target -> taken.put(Originals.real(target.scene()), target.scene()));
        for (Target target : targets) {
            target.file().ifPresent(file -> {
                Path other = taken.put(Originals.real(file), target.scene());
                if (other != null) {
                    throw new WrongUsage(Originals.real(other).equals(Originals.real(file))
                            ? "the picture of " + target.scene() + " would overwrite the scene " + other
                            : other + " and " + target.scene() + " would both be rendered to " + file + "; " + apart(other, target));
                }
            });
        }
        targets.forEach(target -> target.file().ifPresent(Targets::prepare));
    }

    /** How two scenes would get pictures of their own. */
    private String apart(Path other, Target target) {
        boolean isElsewhere = !Objects.equals(Originals.real(other).getParent(), Originals.real(target.scene()).getParent());
        if (isElsewhere && !shown().contains(FOLDER)) {
            String folder = shown().isEmpty() || shown().endsWith("/") ? shown() : shown() + "/";
            return isPattern() ? "put " + FOLDER + " into the output, which stands for the scene's folder"
                    : "-o '" + folder + FOLDER + "/" + NAME + "." + target.format().extension() + "' keeps them apart";
        }
        return isPattern() && !shown().contains(NAME) ? "put " + NAME + " into the output, which stands for the scene's name" : "render them one by one";
    }

    private static void prepare(Path file) {
        try {
            Folders.makeFor(file);
        } catch (FileSystemException e) {
            throw new WrongUsage("cannot make the directory " + Failures.sentence(e));
        } catch (IOException e) {
            throw new WrongUsage(Failures.sentence(e));
        }
        try {
            AtomicFile.check(file);
        } catch (IOException e) {
            throw new WrongUsage("cannot write the picture: " + Failures.sentence(file.toString(), e));
        }
    }

    private boolean isPattern() {
        return PLACE.matcher(shown()).find();
    }

    boolean isDirectory() {
        String text = shown();
        return text.endsWith("/") || text.endsWith(FileSystems.getDefault().getSeparator()) || (!isPattern() && !text.isEmpty() && isFolder(text));
    }

    private static boolean isFolder(String text) {
        return Files.isDirectory(Words.path(text));
    }

    private String shown() {
        return output.orElse("");
    }
}
