package cz.paprsek.fx;

import javafx.scene.Parent;
import javafx.scene.layout.BorderPane;

/** What the window holds. */
final class MainWindow {
    private final BorderPane root = new BorderPane();

    MainWindow() {
        root.setId("main-window");
    }

    Parent root() {
        return root;
    }
}
