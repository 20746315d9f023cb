package cz.paprsek.fx;

import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.logging.Level;
import java.util.logging.Logger;
import javafx.application.Application;

/** Where the process begins. Not an {@link Application} itself: Java would then look for JavaFX outside the program's own jar, and refuse to start. */
public final class Launcher {
    private static final int FAILED = 1;
    private static final int WRONG_USAGE = 2;
    private static final String HELP = """
            Usage: java -jar rt-fx.jar [SCENE.xml]
            Opens the scene editor with a scene or a database of scenes. Without a file it opens database.xml in the working
            directory or beside the program, else an example.
              -h, --help      Prints this help and exits.
              -V, --version   Prints the version and exits.
            Pictures are also rendered without a screen: paprsek render --help""";
    private static final String NO_DISPLAY = "paprsek: the editor needs a screen, but %s; pictures are rendered without one: paprsek render SCENE.xml";

    /** True by the start script where Java is to make an archive of the loaded classes when the window is closed. */
    private static final String MAKES_ARCHIVE = "paprsek.archive";

    /** How many seconds a closed window's process waits for the compilers at most. */
    private static final int LONGEST_WAIT = 20;

    /** JavaFX's logger, held so that its level is not forgotten. */
    private static final Logger JAVAFX = Logger.getLogger("javafx");

    private Launcher() {}

    /** Opens the editor, with the scene file that is the first argument if there is one. */
    public static void main(String[] args) {
        List<String> words = List.of(args);
        if (words.contains("--help") || words.contains("-h")) {
            System.out.println(HELP);
            return;
        }
        if (words.contains("--version") || words.contains("-V")) {
            System.out.println("Paprsek " + Objects.requireNonNullElse(Launcher.class.getPackage().getImplementationVersion(), "(development)"));
            return;
        }
        Optional<String> unknown = words.stream().filter(word -> word.startsWith("-")).findFirst();
        unknown.ifPresent(word -> end(WRONG_USAGE, "paprsek: unknown option \"" + word + "\"; there are --help and --version, and ./" + word + " is a file"));
        missingDisplay(System.getProperty("os.name", ""), System.getProperties().containsKey("glass.platform"), System.getenv())
                .ifPresent(reason -> end(FAILED, String.format(Locale.ROOT, NO_DISPLAY, reason)));
        // JavaFX warns of being started from one jar, which is how it is meant to be started here.
        JAVAFX.setLevel(Level.SEVERE);
        try {
            Application.launch(EditorApp.class, args);
            if (Boolean.getBoolean(MAKES_ARCHIVE)) {
                awaitCompilers();
            }
        } catch (RuntimeException failure) {
            if (!isOfDisplay(failure)) {
                throw failure;
            }
            end(FAILED, String.format(Locale.ROOT, NO_DISPLAY, "the one that DISPLAY names cannot be opened"));
        }
    }

    /**
     * Waits until nothing has been compiled for a second. Java 17 archives, too, that a method waits to be compiled, and then never compiles it in any process that
     * has the archive.
     */
    private static void awaitCompilers() {
        CompilationMXBean compilers = ManagementFactory.getCompilationMXBean();
        long spent = -1;
        for (int second = 0; second < LONGEST_WAIT && compilers != null && compilers.getTotalCompilationTime() != spent; second++) {
            spent = compilers.getTotalCompilationTime();
            LockSupport.parkNanos(TimeUnit.SECONDS.toNanos(1));
        }
    }

    /** Why there can be no window, where that is known beforehand: on systems with X11. */
    static Optional<String> missingDisplay(String system, boolean isSpecial, Map<String, String> environment) {
        boolean hasX11 = system.toLowerCase(Locale.ROOT).contains("linux") && !isSpecial;
        return hasX11 && environment.getOrDefault("DISPLAY", "").isEmpty() ? Optional.of("there is none (DISPLAY is not set)") : Optional.empty();
    }

    private static boolean isOfDisplay(Throwable failure) {
        for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
            if (String.valueOf(cause.getMessage()).contains("DISPLAY")) {
                return true;
            }
        }
        return false;
    }

    private static void end(int code, String sentence) {
        System.err.println(sentence);
        System.exit(code);
    }
}
