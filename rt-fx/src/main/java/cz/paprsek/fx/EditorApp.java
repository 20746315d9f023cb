package cz.paprsek.fx;

import cz.paprsek.fx.model.file.Settings;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javafx.application.Application;
import javafx.application.Platform;
import javafx.stage.Stage;

/** The program: one window. */
public final class EditorApp extends Application {
    private static final double WIDTH = 1280;
    private static final double HEIGHT = 800;

    @Override
    public void start(Stage stage) {
        Path home = Path.of(System.getProperty("user.home", "."));
        Path folder = Settings.folder(System.getenv(), System.getProperty("os.name", ""), home);
        Editor editor = new Editor(stage, folder, Locale.getDefault(), SystemDialogs::new);
        Thread.setDefaultUncaughtExceptionHandler((thread, fault) -> Platform.runLater(() -> editor.fault(fault)));
        List<String> arguments = getParameters().getRaw();
        editor.start(StartFile.find(arguments, Path.of("").toAbsolutePath(), StartFile.programFolder()), Templates.read("showcase"));
        WindowPlace.keep(stage, editor.settings(), "window", () -> Sizes.mostOfTheScreen(stage, WIDTH, HEIGHT));
        stage.show();
        if (arguments.isEmpty() && Welcome.isWanted(editor.settings())) {
            editor.welcome();
        }
    }
}
