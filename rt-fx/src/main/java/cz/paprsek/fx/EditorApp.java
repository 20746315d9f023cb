package cz.paprsek.fx;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.Texts;
import cz.paprsek.fx.view.Theme;
import java.util.Locale;
import javafx.application.Application;
import javafx.beans.property.SimpleObjectProperty;
import javafx.scene.Scene;
import javafx.stage.Stage;

/** The program: one window. */
public final class EditorApp extends Application {
    @Override
    public void start(Stage stage) {
        MainWindow window = new MainWindow(new EditorModel(cz.paprsek.scene.Scene.EMPTY), Texts.in(Locale.getDefault()), new SimpleObjectProperty<>(Theme.LIGHT));
        Scene scene = new Scene(window.root(), 1280, 800);
        Theme.LIGHT.applyTo(scene);
        stage.setScene(scene);
        stage.setTitle("Paprsek");
        stage.show();
    }
}
