package cz.paprsek.xml;

import cz.paprsek.asset.Assets;
import cz.paprsek.math.Require;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.scene.ScenePath.MaterialAt;
import cz.paprsek.xml.SceneFiles.Contents;
import cz.paprsek.xml.text.Excerpt;
import cz.paprsek.xml.text.FileText;
import cz.paprsek.xml.text.Form;
import cz.paprsek.xml.text.Places.Step;
import cz.paprsek.xml.text.Unpatchable;
import cz.paprsek.xml.write.SceneForms;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/**
 * The text of a file and the scenes in it. A scene that is taken from here into another file takes along its comments, order and wording, also
 * under another name and with other tags. Immutable.
 */
public final class OriginalText {
    /**
     * How deep elements are changed piece by piece: all the way; if that went wrong, those directly inside a scene or a database are written anew.
     * At last the whole file is.
     */
    private static final int[] DEPTHS = {SceneFiles.DEEPEST + 1, 2, 1};

    private final String file;
    private final byte[] bytes;
    private final Contents contents;
    /** Whether somebody has written it for a scene as it is, so that it counts for more than what is there. */
    private final boolean isTyped;
    /** How the scenes are made of the text. */
    private final Making how;

    /** @param file its name, for messages */
    OriginalText(String file, byte[] bytes, Contents contents) {
        this(file, bytes, contents, false, Making.PLAIN);
    }

    private OriginalText(String file, byte[] bytes, Contents contents, boolean isTyped, Making how) {
        this.file = file;
        this.bytes = bytes;
        this.contents = contents;
        this.isTyped = isTyped;
        this.how = how;
    }

    /** What somebody has written, which says this scene. */
    OriginalText typed(Scene scene) {
        return new OriginalText(file, bytes, new Contents(List.of(scene), false), true, how);
    }

    /**
     * The same, as what somebody has written: it takes the place of the text that a scene has where it goes, also if that scene is the same.
     *
     * @throws IllegalArgumentException if that is not the text of one scene
     */
    public OriginalText asTyped() {
        Require.that(contents.scenes().size() == 1 && !contents.isDatabase(), "what is typed must be the text of one scene");
        return new OriginalText("text", bytes, contents, true, how);
    }

    boolean isTyped() {
        return isTyped;
    }

    /**
     * Reads a file with a scene or a database.
     *
     * @throws SceneFileException if it is not valid, with every problem found
     * @throws IOException if it cannot be read
     */
    public static OriginalText read(Path path) throws SceneFileException, IOException {
        return read(path, ReadMonitor.NONE);
    }

    /** As {@link #read(Path)}, with other values of parameters and other files, as {@link SceneFiles#contents(Path, ReadMonitor, Map, Assets)} takes them. */
    public static OriginalText read(Path path, Map<String, String> parameters, Assets assets) throws SceneFileException, IOException {
        return read(path, ReadMonitor.NONE, Making.from(Objects.requireNonNull(assets, "assets"), Objects.requireNonNull(parameters, "parameters")));
    }

    /** As {@link #read(Path)}, from a stream, which is not closed; the name is used in messages only. */
    public static OriginalText read(InputStream input, String fileName) throws SceneFileException, IOException {
        return read(input, fileName, Map.of(), Assets.none());
    }

    /** As {@link #read(Path, Map, Assets)}, from a stream, which is not closed. */
    public static OriginalText read(InputStream input, String fileName, Map<String, String> parameters, Assets assets) throws SceneFileException, IOException {
        Objects.requireNonNull(assets, "assets");
        return read(Source.of(input), fileName, ReadMonitor.NONE, Making.from(assets, Objects.requireNonNull(parameters, "parameters")));
    }

    /** Says something of what is in a file, with line and column; of what comes of a file that is included, there. */
    public interface Pointer {
        /**
         * What is to be said, and where it begins that this is about.
         *
         * @param scene which of the scenes of the file, from 0
         * @param place in that scene; empty for the scene as a whole
         * @param attribute of what is there; empty, or one that the file does not give, for all of it
         */
        Problem at(int scene, Optional<ScenePath> place, String attribute, String message);

        /**
         * What is to be said of a file that a scene names, and where it is named.
         *
         * @param scene which of the scenes of the file, from 0
         */
        Problem naming(int scene, String named, String message);
    }

    static OriginalText read(Path path, ReadMonitor monitor) throws SceneFileException, IOException {
        return read(path, monitor, Making.from(Assets.beside(path), Map.of()));
    }

    private static OriginalText read(Path path, ReadMonitor monitor, Making how) throws SceneFileException, IOException {
        SceneFiles.checkReadable(path);
        try (Source source = Source.of(path)) {
            return read(source, path.toString(), monitor, how);
        }
    }

    private static OriginalText read(Source source, String file, ReadMonitor monitor, Making how) throws SceneFileException, IOException {
        long size = source.size();
        // One for each reader; the last has heard all.
        Deque<RecordedInput> recorded = new ArrayDeque<>();
        Contents contents = SceneReader.read(source, input -> {
            recorded.clear();
            recorded.add(new RecordedInput(new WatchedInput(input, size, monitor)));
            return recorded.getLast();
        }, file, how);
        return new OriginalText(file, recorded.getLast().bytes(), contents, false, how);
    }

    /**
     * The text of a new file.
     *
     * @throws IllegalArgumentException as {@link SceneFiles#format}
     */
    public static OriginalText of(Scene scene) {
        return new OriginalText("", SceneFiles.format(Objects.requireNonNull(scene, "scene")).getBytes(StandardCharsets.UTF_8), new Contents(List.of(scene), false));
    }

    /** The text of a new database. */
    static OriginalText ofDatabase(List<Scene> scenes) {
        return new OriginalText("", SceneFiles.bytes(scenes), new Contents(scenes, true));
    }

    byte[] bytes() {
        return bytes;
    }

    /** Writes all bytes of the file into a stream, which is not closed. */
    public void writeTo(OutputStream output) throws IOException {
        output.write(bytes);
    }

    public Contents contents() {
        return contents;
    }

    /**
     * The file with other scenes.
     *
     * @param from where those that are new here may have their text
     * @throws IllegalArgumentException if these cannot be written, as {@link SceneFiles#format} and {@link SceneFiles#formatAll}
     */
    byte[] with(List<Scene> scenes, List<OriginalText> from) {
        List<Scene> wanted = scenes.stream().map(Settled::of).toList();
        if (contents.isDatabase()) {
            SceneDatabase.of(wanted);
        }
        Optional<FileText> text = Whereabouts.text(bytes);
        List<Form> plain = forms(wanted);
        List<Form> written = IntStream.range(0, wanted.size()).mapToObj(i -> written(wanted.get(i), plain.get(i), from)).toList();
        for (List<Form> forms : from.isEmpty() ? List.of(plain) : List.of(written, plain)) {
            for (int depth : DEPTHS) {
                Optional<byte[]> patched = text.flatMap(original -> patched(original, wanted, forms, depth));
                if (patched.isPresent()) {
                    return patched.get();
                }
            }
        }
        return (contents.isDatabase() ? SceneFiles.formatAll(wanted) : SceneFiles.format(wanted.get(0))).getBytes(StandardCharsets.UTF_8);
    }

    /** Finds out where things are in the file when first it is asked, once for any number of messages. */
    public Pointer pointer() {
        return new Pointer() {
            private Optional<Whereabouts> known = Optional.empty();

            private Whereabouts known() {
                Whereabouts now = known.orElseGet(() -> new Whereabouts(file, bytes, how));
                known = Optional.of(now);
                return now;
            }

            @Override
            public Problem at(int scene, Optional<ScenePath> place, String attribute, String message) {
                return known().of(scene, place.map(there -> way(contents.scenes().get(scene), there)).orElse(List.of()), attribute, message);
            }

            @Override
            public Problem naming(int scene, String named, String message) {
                return known().naming(scene, named, message);
            }
        };
    }

    private static List<Step> way(Scene scene, ScenePath path) {
        if (path instanceof BodyAt body) {
            return body.numbers().stream().map(number -> new Step("body", number)).toList();
        }
        return List.of(path instanceof LightAt light ? new Step("light", light.index())
                : path instanceof CameraAt camera ? new Step("camera", camera.index())
                : new Step("material", List.copyOf(scene.materials().keySet()).indexOf(((MaterialAt) path).name())));
    }

    /**
     * A file of its own for a scene, which keeps the text that it has here, or that a scene of that name has.
     *
     * @throws IllegalArgumentException as {@link SceneFiles#format}
     */
    public OriginalText alone(Scene given) {
        Scene scene = Settled.of(given);
        Optional<Excerpt> excerpt = excerpt(scene).or(() -> excerpt(scene, there -> there.name().equals(scene.name())));
        if (excerpt.isPresent()) {
            FileText text = Whereabouts.text(bytes).orElseThrow();
            String alone = "<?xml version=\"" + text.version() + "\" encoding=\"UTF-8\"?>" + text.lineBreak() + excerpt.get().alone(text.lineBreak());
            byte[] own = alone.getBytes(StandardCharsets.UTF_8);
            if (says(own, List.of(scene))) {
                return new OriginalText(file, own, new Contents(List.of(scene), false), isTyped, how);
            }
        }
        return of(scene);
    }

    /** What somebody has written is of the very scene that it says, not of another one that is the same but for its name. */
    private Form written(Scene wanted, Form form, List<OriginalText> from) {
        Optional<OriginalText> typed = from.stream().filter(text -> text.isTyped && text.contents.scenes().contains(wanted)).findFirst();
        return contents.scenes().contains(wanted) && typed.isEmpty() ? form
                : typed.stream().flatMap(text -> text.excerpt(wanted).stream()).findFirst()
                        .or(() -> from.stream().flatMap(text -> text.excerpt(wanted).stream()).findFirst()).map(form::as).orElse(form);
    }

    /** The text of the scene that this is here, or was before it got another name or other tags. */
    private Optional<Excerpt> excerpt(Scene wanted) {
        return excerpt(wanted, there -> Settled.of(there.withName(wanted.name()).withTags(wanted.tags())).equals(wanted));
    }

    /** The text of the scene that this was here, with what has become of it. */
    private Optional<Excerpt> excerpt(Scene wanted, Predicate<Scene> was) {
        List<Scene> scenes = contents.scenes();
        OptionalInt found = IntStream.range(0, scenes.size()).filter(i -> was.test(scenes.get(i))).findFirst();
        if (found.isEmpty()) {
            return Optional.empty();
        }
        try {
            return Whereabouts.text(bytes).map(text -> text.excerpt(found.getAsInt(), SceneForms.scene(scenes.get(found.getAsInt())), SceneForms.scene(wanted)));
        } catch (Unpatchable e) {
            return Optional.empty();
        }
    }

    private static List<Form> forms(List<Scene> scenes) {
        return scenes.stream().map(SceneForms::scene).toList();
    }

    /** The changed text; empty if it does not say what it should. */
    Optional<byte[]> patched(FileText text, List<Scene> wanted, int depth) {
        return patched(text, wanted, forms(wanted), depth);
    }

    private Optional<byte[]> patched(FileText text, List<Scene> wanted, List<Form> forms, int depth) {
        Form before = contents.isDatabase() ? SceneForms.database(forms(contents.scenes())) : SceneForms.file(contents.scenes().get(0));
        Form now = contents.isDatabase() ? SceneForms.database(forms) : SceneForms.file(wanted.get(0));
        try {
            FileText.Changed changed = text.changed(before, now, depth);
            List<Scene> inSample = new ArrayList<>();
            for (int i = 0; i < forms.size(); i++) {
                if (!changed.leftOut().contains(forms.get(i))) {
                    inSample.add(wanted.get(i));
                }
            }
            boolean isGood = changed.whole() == bytes || says(changed.sample(), inSample);
            return isGood ? Optional.of(changed.whole()) : Optional.empty();
        } catch (Unpatchable e) {
            return Optional.empty();
        }
    }

    private static boolean says(byte[] text, List<Scene> wanted) {
        try {
            Map<String, String> included = new LinkedHashMap<>();
            wanted.forEach(scene -> included.putAll(scene.recipe().included()));
            Making how = Making.of(new Recipe("", included, List.of()), Map.of());
            return SceneReader.read(Source.of(text), input -> input, "text", how).scenes().equals(wanted);
        } catch (SceneFileException wrong) {
            return false;
        } catch (IOException e) {
            throw new IllegalStateException("bytes in memory could not be read", e);
        }
    }
}
