package cz.paprsek.xml;

import cz.paprsek.asset.Assets;
import cz.paprsek.formula.Maker;
import cz.paprsek.formula.Written;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.xml.bind.RootElement;
import cz.paprsek.xml.format.SceneFormat;
import cz.paprsek.xml.quick.QuickReader;
import cz.paprsek.xml.write.SceneWriter;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.DoubleFunction;

/**
 * Reads and writes scene files. A file is checked against the schema whenever it is read; all its problems are reported, each with line
 * and column. Nothing that a file refers to is ever fetched.
 */
public final class SceneFiles {
    /** The namespace of scene files. */
    public static final String NAMESPACE = SceneFormat.NAMESPACE;

    /**
     * How deep elements may be nested in a file: far deeper than anybody builds, and safe for every recursion in the program.
     */
    public static final int DEEPEST = SceneFormat.DEEPEST;

    /** How many bytes a file may have: 1 GiB, ten million spheres, or what the system property {@code paprsek.largest-file} says. */
    public static final long LARGEST = Long.getLong("paprsek.largest-file", 1L << 30);

    private SceneFiles() {}

    /**
     * What a file has in it.
     *
     * @param scenes one, or those of a database
     * @param isDatabase whether it is a {@code <database>}, which may be one of a single scene
     */
    public record Contents(List<Scene> scenes, boolean isDatabase) {
        public Contents {
            scenes = List.copyOf(Objects.requireNonNull(scenes, "scenes"));
        }

        /** As a database: a scene on its own is one of one, under that name if it has none of its own. */
        public SceneDatabase database(String nameIfNone) {
            Objects.requireNonNull(nameIfNone, "nameIfNone");
            boolean isNameless = scenes.size() == 1 && scenes.get(0).name().isEmpty();
            return SceneDatabase.of(isNameless ? List.of(scenes.get(0).withName(nameIfNone)) : scenes);
        }
    }

    /**
     * Reads a file with one scene.
     *
     * @throws SceneFileException if it is not a valid scene, with every problem found
     * @throws IOException if it cannot be read
     */
    public static Scene read(Path file) throws SceneFileException, IOException {
        return read(file, ReadMonitor.NONE);
    }

    /**
     * As {@link #read(Path)}, telling how far it is: a million objects take a second or two.
     *
     * @throws java.util.concurrent.CancellationException if the monitor cancels
     * @throws IllegalStateException if the monitor throws anything, with that as its cause
     */
    public static Scene read(Path file, ReadMonitor monitor) throws SceneFileException, IOException {
        return only(contents(file, monitor), file.toString());
    }

    /**
     * Opens a file with one scene, to change it and save it again: what is saved keeps all that has not changed byte by byte, comments too.
     *
     * @throws SceneFileException if it is not a valid scene, with every problem found
     * @throws IOException if it cannot be read
     */
    public static SceneFile open(Path file) throws SceneFileException, IOException {
        return open(file, ReadMonitor.NONE);
    }

    /**
     * As {@link #open(Path)}, telling how far it is.
     *
     * @throws java.util.concurrent.CancellationException if the monitor cancels
     */
    public static SceneFile open(Path file, ReadMonitor monitor) throws SceneFileException, IOException {
        return SceneFile.open(file, Objects.requireNonNull(monitor, "monitor"));
    }

    /** As {@link #read(Path)}, with other values of parameters, as {@link #contents(Path, ReadMonitor, Map, Assets)} takes them. */
    public static Scene read(Path file, Map<String, String> parameters) throws SceneFileException, IOException {
        return read(file, parameters, Assets.beside(file));
    }

    /** As the other, with files to include from where {@link #contents(Path, ReadMonitor, Map, Assets)} has them. */
    public static Scene read(Path file, Map<String, String> parameters, Assets assets) throws SceneFileException, IOException {
        return only(contents(file, ReadMonitor.NONE, parameters, assets), file.toString());
    }

    /** As {@link #read(Path)}, from a stream, which is not closed; the name is used in messages only. */
    public static Scene read(InputStream input, String fileName) throws SceneFileException, IOException {
        return only(SceneReader.read(input, fileName, Making.PLAIN), fileName);
    }

    /** Reads a scene from text. */
    public static Scene parse(String xml) throws SceneFileException {
        try {
            return only(SceneReader.read(xml, "text"), "text");
        } catch (IOException e) {
            throw new IllegalStateException("a text in memory could not be read", e);
        }
    }

    /**
     * Reads a file with one {@code <scene>} or a {@code <database>} of any number.
     *
     * @throws SceneFileException if it is not valid, with every problem found
     * @throws IOException if it cannot be read
     */
    public static List<Scene> readAll(Path file) throws SceneFileException, IOException {
        return readAll(file, ReadMonitor.NONE);
    }

    /**
     * As {@link #readAll(Path)}, telling how far it is.
     *
     * @throws java.util.concurrent.CancellationException if the monitor cancels
     * @throws IllegalStateException if the monitor throws anything, with that as its cause
     */
    public static List<Scene> readAll(Path file, ReadMonitor monitor) throws SceneFileException, IOException {
        return contents(file, monitor).scenes();
    }

    /**
     * Reads whatever is in a file, which is opened once: the way for pipes.
     *
     * @throws SceneFileException if it is not valid, with every problem found
     * @throws IOException if it cannot be read
     * @throws java.util.concurrent.CancellationException if the monitor cancels
     */
    public static Contents contents(Path file, ReadMonitor monitor) throws SceneFileException, IOException {
        Objects.requireNonNull(monitor, "monitor");
        return contents(file, monitor, Map.of(), Assets.beside(file));
    }

    /**
     * As {@link #contents(Path, ReadMonitor)}, with other values of some parameters, and with files from elsewhere.
     *
     * @param parameters by name: a number, a formula in braces, or a text such as the name of a colour
     * @param assets what the file may include
     * @throws SceneFileException as there, or if there is no such parameter, or none that can have such a value
     */
    public static Contents contents(Path file, ReadMonitor monitor, Map<String, String> parameters, Assets assets) throws SceneFileException, IOException {
        Objects.requireNonNull(monitor, "monitor");
        Objects.requireNonNull(parameters, "parameters");
        Objects.requireNonNull(assets, "assets");
        checkReadable(file);
        return SceneReader.read(file, monitor, Making.from(assets, parameters));
    }

    /** As {@link #contents(Path, ReadMonitor)}, from a stream, which is not closed; the name is used in messages only. */
    public static Contents contents(InputStream input, String fileName) throws SceneFileException, IOException {
        return contents(input, fileName, Map.of(), Assets.none());
    }

    /** As {@link #contents(Path, ReadMonitor, Map, Assets)}, from a stream, which is not closed. */
    public static Contents contents(InputStream input, String fileName, Map<String, String> parameters, Assets assets) throws SceneFileException, IOException {
        Objects.requireNonNull(parameters, "parameters");
        Objects.requireNonNull(assets, "assets");
        return SceneReader.read(input, fileName, Making.from(assets, parameters));
    }

    /**
     * A scene made anew with other values of some of its {@linkplain cz.paprsek.scene.Scene.Recipe#parameters parameters}. What has been changed in it since it was
     * read stays as it is now.
     *
     * @param parameters as in {@link #contents(Path, ReadMonitor, Map, Assets)}
     * @throws SceneFileException if it cannot be made of these, or has no such parameter
     */
    public static Scene with(Scene scene, Map<String, String> parameters) throws SceneFileException {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(parameters, "parameters");
        try {
            return Settled.with(scene, parameters);
        } catch (IOException e) {
            throw new IllegalStateException("a text in memory could not be read", e);
        }
    }

    /**
     * What the frames of a film show: for the number of a frame, from 1, the scene in which all that is animated, and all formulas with {@code t} and {@code frame}, are as they are at its time. In
     * that scene nothing moves or is made any more. What does not change is the very same as in the scene that is given. Between two whole numbers there are times as well.
     *
     * @return a function that throws an {@link IllegalArgumentException} where a value makes no scene, naming the frame
     */
    public static DoubleFunction<Scene> frames(Scene scene) {
        return new Frames(Objects.requireNonNull(scene, "scene"));
    }

    /** Whether anything in a scene is animated, or made by formulas with the time. */
    public static boolean moves(Scene scene) {
        return Frames.differ(Objects.requireNonNull(scene, "scene"));
    }

    /**
     * A changed scene in which all copies of what is repeated are as the first of them, which has been changed; else as {@link #settled}.
     *
     * @throws IllegalArgumentException if each copy has of its own what has been changed of the first
     */
    public static Scene following(Scene scene) {
        return Settled.following(Objects.requireNonNull(scene, "scene"));
    }

    /** What is repeated in a scene, and where definitions are used. */
    public static List<Maker> makers(Scene scene) {
        return scene.recipe().isNone() ? List.of() : Settled.makers(scene.recipe());
    }

    /**
     * A scene with another value of an attribute of one of its {@link #makers}.
     *
     * @param number that of the maker
     * @param value as files have it, with formulas in braces; empty for none
     * @throws IllegalArgumentException if that makes no scene, with what is wrong
     */
    public static Scene withMaker(Scene scene, int number, String attribute, String value) {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(attribute, "attribute");
        return Settled.with(scene, number, attribute, Objects.requireNonNull(value, "value"));
    }

    /**
     * A scene with a repeat around bodies that stand side by side.
     *
     * @param bodies by their numbers, as in {@link Maker}
     * @param attributes of the repeat, as files have them
     * @throws IllegalArgumentException if they do not stand so, or that makes no scene
     */
    public static Scene repeated(Scene scene, List<List<Integer>> bodies, Map<String, String> attributes) {
        return Settled.around(scene, bodies, Maker.REPEAT, attributes);
    }

    /**
     * A scene, the same as it is, in which a body is made by a definition: in its place is the use of that.
     *
     * @param body by its numbers, as in {@link Maker}
     * @param name of the definition, with a number if there is one of that name
     * @throws IllegalArgumentException if it is made by a definition already, or cannot be by one
     */
    public static Scene defined(Scene scene, List<Integer> body, String name) {
        return Settled.defined(scene, body, name);
    }

    /** A scene with another use of a definition after one, that of the maker of this number, so far from it along x. */
    public static Scene usedAgain(Scene scene, int maker, double aside) {
        return Settled.usedAgain(scene, maker, aside);
    }

    /** A scene with a recipe that makes just what it has now: formulas stay where their values have stayed. */
    public static Scene settled(Scene scene) {
        return Settled.of(Objects.requireNonNull(scene, "scene"));
    }

    /**
     * A scene with a formula where a change of it puts a number. Where that is in the first copy of what is repeated, it is so in all copies, as with
     * {@link #following}, and with the number of the copy in the formula each has its own.
     *
     * @param change puts a number there
     * @param formula without braces; it may have the names of the scene's parameters, and that of the number of a copy, {@code i}
     * @throws cz.paprsek.formula.FormulaException if it is none, or has no value
     * @throws IllegalArgumentException if the change refuses the value, or what it changes is no number of a file
     */
    public static Scene withFormula(Scene scene, DoubleFunction<Scene> change, String formula) {
        return Formulated.of(Objects.requireNonNull(scene, "scene"), Objects.requireNonNull(change, "change"), Objects.requireNonNull(formula, "formula"));
    }

    /**
     * The formulas of a scene, by what has them; without a place, those of the scene itself and of what there is once in it. What has been changed since
     * it was made or {@linkplain #settled settled} may have other values.
     */
    public static Map<Optional<ScenePath>, List<Written>> formulas(Scene scene) {
        return scene.recipe().isNone() ? Map.of() : Settled.formulas(scene.recipe());
    }

    /**
     * Reads a file as a database; a file with one scene is a database of one, which is named after the file if it has no name.
     *
     * @throws SceneFileException if it is not valid, with every problem found
     * @throws IOException if it cannot be read
     */
    public static SceneDatabase readDatabase(Path file) throws SceneFileException, IOException {
        return contents(file, ReadMonitor.NONE).database(nameOf(file));
    }

    /** Whether a file says of itself that it is a database; no more than its beginning is read, which of a pipe would be lost: see {@link #contents}. */
    public static boolean isDatabase(Path file) throws IOException {
        checkReadable(file);
        return !QuickReader.isScene(file) && RootElement.is("database", file);
    }

    /**
     * Writes a scene in a form of its own, which {@link SceneFile#save} does not; the file is replaced as a whole or not at all, and keeps its permissions.
     *
     * @throws IllegalArgumentException as {@link #format}
     */
    public static void write(Scene scene, Path file) throws IOException {
        write(file, format(scene).getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Writes a database; the file is replaced as a whole or not at all, and keeps its permissions.
     *
     * @throws IllegalArgumentException as {@link #format}
     */
    public static void writeAll(List<Scene> scenes, Path file) throws IOException {
        write(file, bytes(scenes));
    }

    /**
     * The text of a scene file, always the same for the same scene.
     *
     * @throws IllegalArgumentException if the scene has what no file can hold: a text with control characters, or nesting deeper than {@link #DEEPEST}
     */
    public static String format(Scene scene) {
        return new SceneWriter().file(Settled.of(scene));
    }

    /**
     * The text of a database file, always the same for the same scenes.
     *
     * @throws IllegalArgumentException as {@link #format}, or if a scene has no name or that of another
     */
    public static String formatAll(List<Scene> scenes) {
        return new SceneWriter().database(scenes.stream().map(Settled::of).toList());
    }

    /** A database with a test scene and examples of everything that scenes may have. */
    public static SceneDatabase examples() {
        try (InputStream input = Objects.requireNonNull(SceneFiles.class.getResourceAsStream("database.xml"), "database.xml is missing")) {
            return SceneDatabase.of(SceneReader.read(input, "examples", Making.PLAIN).scenes());
        } catch (IOException | SceneFileException e) {
            throw new IllegalStateException("the examples in the program's own jar cannot be read", e);
        }
    }

    /** The schema of scene files, an XSD. */
    public static String schema() {
        return SceneFormat.schemaWithFormulas();
    }

    /** The file's name without its ending. */
    private static String nameOf(Path file) {
        String name = Objects.requireNonNullElse(file.getFileName(), file).toString();
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }

    static byte[] bytes(List<Scene> scenes) {
        return formatAll(scenes).getBytes(StandardCharsets.UTF_8);
    }

    static void write(Path file, byte[] content) throws IOException {
        AtomicFile.write(file, out -> out.write(content));
    }

    /** @throws IOException with one line that says why the file cannot be read */
    static void checkReadable(Path file) throws IOException {
        if (Files.isDirectory(file)) {
            throw new IOException(file + ": this is a directory, not a scene file");
        }
        if (!Files.exists(file)) {
            throw new IOException(file + ": no such file");
        }
        if (!Files.isReadable(file)) {
            throw new IOException(file + ": no permission to read this file");
        }
    }

    static Scene only(Contents contents, String file) throws SceneFileException {
        List<Scene> scenes = contents.scenes();
        if (scenes.size() != 1) {
            throw new SceneFileException(List.of(new Problem(file, 1, 1,
                    "this is a database of " + scenes.size() + " scenes, but one scene was expected")));
        }
        return scenes.get(0);
    }
}
