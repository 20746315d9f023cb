package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.format.ForeignFormat;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.ReadMonitor;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import cz.paprsek.xml.SceneFiles.Contents;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** What can be read once only: standard input, for which the word is {@code -}, pipes and devices. */
public final class Incoming {
    private static final String STANDARD_INPUT = "-";

    private Incoming() {}

    /** Reads what is in a file or comes in, once; the file may be another program's. */
    public static Contents read(Path file, ParameterWishes parameters) throws SceneFileException, IOException {
        Foreign.refuse(file);
        Optional<ForeignFormat> format = Models.format(file);
        if (format.isPresent()) {
            refuse(file, parameters);
            return new Contents(List.of(Models.read(file, format.get()).scene()), false);
        }
        return reading(() -> isStandardInput(file) ? SceneFiles.contents(standardInput(), STANDARD_INPUT, parameters.values(), parameters.pictures().of(file))
                : SceneFiles.contents(file, ReadMonitor.NONE, parameters.values(), parameters.pictures().of(file)));
    }

    /** Reads a file with one scene. */
    static Scene scene(Path file, ParameterWishes parameters) throws SceneFileException, IOException {
        Foreign.refuse(file);
        return reading(() -> SceneFiles.read(file, parameters.values(), parameters.pictures().of(file)));
    }

    /** As {@link #read}, with the text, to tell where in it something is, or to take it elsewhere. */
    public static OriginalText text(Path file, ParameterWishes parameters) throws SceneFileException, IOException {
        Foreign.refuse(file);
        return reading(() -> isStandardInput(file) ? OriginalText.read(standardInput(), STANDARD_INPUT, parameters.values(), parameters.pictures().of(file))
                : OriginalText.read(file, parameters.values(), parameters.pictures().of(file)));
    }

    /** @throws WrongUsage if there are values of parameters, which files of other programs do not have */
    static void refuse(Path file, ParameterWishes parameters) {
        if (parameters.areSaid()) {
            throw new WrongUsage(file + " is a file of another program, which has no parameters; -D is for scenes");
        }
    }

    /** @throws IOException if a model of another program comes in, which may need files beside it */
    private static InputStream standardInput() throws IOException {
        InputStream input = new BufferedInputStream(System.in, ForeignFormat.HEAD);
        input.mark(ForeignFormat.HEAD);
        byte[] head = input.readNBytes(ForeignFormat.HEAD);
        input.reset();
        Optional<ForeignFormat> format = Foreign.isMarkup(head) ? Optional.empty() : ForeignFormat.of(STANDARD_INPUT, head);
        if (format.isPresent()) {
            throw new IOException(STANDARD_INPUT + ": this looks like " + format.get().label() + "; " + Foreign.NOT_THROUGH);
        }
        return input;
    }

    /** That memory does not suffice is told with how to give this program more, and is no fault of the file. */
    private static <T> T reading(Reading<T> reading) throws SceneFileException, IOException {
        try {
            return reading.read();
        } catch (IOException failed) {
            if (failed.getCause() instanceof OutOfMemoryError exhausted) {
                throw exhausted;
            }
            throw failed;
        }
    }

    @FunctionalInterface
    private interface Reading<T> {
        T read() throws SceneFileException, IOException;
    }

    /** Whether a second reading would find nothing. */
    public static boolean isOnce(Path file) {
        return isStandardInput(file) || (Files.exists(file) && !Files.isRegularFile(file) && !Files.isDirectory(file));
    }

    /** What a scene is called that has no name of its own: what it came through has none that means anything. */
    public static String nameOf(Path file) {
        return isOnce(file) ? "scene" : SceneArguments.nameOf(file);
    }

    /** @throws WrongUsage if a file that is to be changed or written is none */
    public static void requireFile(Path file) {
        if (isOnce(file)) {
            throw new WrongUsage("a database that is to be changed must be a file, but '" + file + "' is "
                    + (isStandardInput(file) ? "standard input" : "a pipe or a device"));
        }
    }

    private static boolean isStandardInput(Path file) {
        return file.toString().equals(STANDARD_INPUT);
    }
}
