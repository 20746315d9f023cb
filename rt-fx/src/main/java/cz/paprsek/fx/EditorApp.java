package cz.paprsek.fx;

import javafx.application.Application;
import javafx.scene.Scene;
import javafx.stage.Stage;

/** The program: one window. */
public final class EditorApp extends Application {
    @Override
    public void start(Stage stage) {
        MainWindow window = new MainWindow();
        stage.setScene(new Scene(window.root(), 1280, 800));
        stage.setTitle("Paprsek");
        stage.show();
    }
}
