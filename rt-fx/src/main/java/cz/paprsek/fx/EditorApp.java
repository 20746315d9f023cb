package cz.paprsek.fx;

import cz.paprsek.fx.model.file.Settings;
import cz.paprsek.fx.view.texts.BuiltInWords;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javafx.animation.AnimationTimer;
import javafx.application.Application;
import javafx.application.Platform;
import javafx.scene.image.ImageView;
import javafx.stage.Stage;

/** The program: one window. */
public final class EditorApp extends Application {
    private static final double WIDTH = 1280;
    private static final double HEIGHT = 800;

    @Override
    public void start(Stage stage) {
        StartTimes times = new StartTimes(System.getProperty("paprsek.started", ""));
        times.tell("JavaFX");
        Path home = Path.of(System.getProperty("user.home", "."));
        Path folder = Settings.folder(System.getenv(), System.getProperty("os.name", ""), home);
        Editor editor = new Editor(stage, folder, BuiltInWords.speakEnglish(), SystemDialogs::new);
        times.tell("window made");
        Thread.setDefaultUncaughtExceptionHandler((thread, fault) -> Platform.runLater(() -> editor.fault(fault)));
        List<String> arguments = getParameters().getRaw();
        editor.start(StartFile.find(arguments, Path.of("").toAbsolutePath(), StartFile.programFolder()), Templates.read("showcase"));
        WindowPlace.keep(stage, editor.settings(), "window", () -> Sizes.mostOfTheScreen(stage, WIDTH, HEIGHT));
        times.tell("scene read");
        if (arguments.isEmpty() && Welcome.isWanted(editor.settings())) {
            editor.welcome();
        }
        stage.show();
        times.follow(stage, editor);
    }

    /**
     * Tells how long it has taken until something was there at the start, in milliseconds since Java began, if the system property {@code paprsek.started} is set;
     * if that is {@code quit}, the program ends with the first whole picture.
     */
    private static final class StartTimes {
        private final String wish;

        StartTimes(String wish) {
            this.wish = wish;
        }

        void tell(String what) {
            if (!wish.isEmpty()) {
                System.err.printf(Locale.ROOT, "%6d ms  %s%n", System.currentTimeMillis() - ManagementFactory.getRuntimeMXBean().getStartTime(), what);
            }
        }

        /** Looks before each frame what the last one has brought. */
        void follow(Stage stage, Editor editor) {
            tell("window shown");
            AnimationTimer timer = new AnimationTimer() {
                private int frames;
                private boolean isSeen;

                @Override
                public void handle(long now) {
                    frames++;
                    if (frames == 2) {
                        tell("window painted");
                    }
                    if (!isSeen && stage.getScene().lookup(".live-picture > .image-view") instanceof ImageView view && view.getImage() != null) {
                        isSeen = true;
                        tell("first picture");
                    }
                    if (editor.isPictureComplete()) {
                        tell("whole picture");
                        stop();
                        if (wish.equals("quit")) {
                            Platform.exit();
                        }
                    }
                }
            };
            if (!wish.isEmpty()) {
                timer.start();
            }
        }
    }
}
