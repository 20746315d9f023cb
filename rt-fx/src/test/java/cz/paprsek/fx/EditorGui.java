package cz.paprsek.fx;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.projection.ProjectionPane;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javafx.geometry.Point2D;
import javafx.scene.control.Labeled;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.stage.Stage;

/** The whole editor in a window, driven by a test. */
final class EditorGui implements AutoCloseable {
    final TestDialogs dialogs = new TestDialogs();
    final Gui gui;
    final Editor editor;

    /** @param folder for settings; a test's own */
    EditorGui(Path folder, Scene scene) {
        this(folder, scene, 1280, 800);
    }

    EditorGui(Path folder, Scene scene, double width, double height) {
        editor = Gui.on(() -> {
            Stage stage = new Stage();
            Editor fresh = new Editor(stage, folder, Locale.ENGLISH, (owner, texts) -> dialogs);
            stage.setWidth(width);
            stage.setHeight(height);
            fresh.start(Optional.empty(), scene);
            return fresh;
        });
        gui = Gui.open(editor::stage);
    }

    EditorModel model() {
        return editor.model();
    }

    ProjectionPane projection(String axes) {
        return (ProjectionPane) gui.node("#projection-" + axes);
    }

    /** Where a point of the world is on a projection, pixels. */
    static Point2D place(ProjectionPane pane, double x, double y, double z) {
        return Gui.on(() -> pane.toPane(new Vec3(x, y, z)));
    }

    /** Does what a menu item does, found by its id. */
    void menu(String id) {
        MenuItem item = Gui.on(() -> find(((MenuBar) gui.stage().getScene().lookup("#menu-bar")).getMenus(), id)
                .orElseThrow(() -> new AssertionError("there is no menu item " + id)));
        gui.act(() -> {
            if (item.isDisable()) {
                throw new AssertionError(id + " is disabled");
            }
            item.fire();
        });
    }

    /** What the status bar says; for any thread, as a condition to wait for or once nothing moves any more. */
    String status() {
        return ((Labeled) gui.stage().getScene().lookup("#status-message")).getText();
    }

    String text(String selector) {
        return Gui.on(() -> ((Labeled) gui.stage().getScene().lookup(selector)).getText());
    }

    @Override
    public void close() {
        gui.act(editor::close);
        gui.close();
    }

    private static Optional<MenuItem> find(Iterable<? extends MenuItem> items, String id) {
        for (MenuItem item : items) {
            if (id.equals(item.getId())) {
                return Optional.of(item);
            }
            Optional<MenuItem> inside = item instanceof Menu menu ? find(menu.getItems(), id) : Optional.empty();
            if (inside.isPresent()) {
                return inside;
            }
        }
        return Optional.empty();
    }
}
