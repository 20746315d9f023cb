package cz.paprsek.fx;

import static cz.paprsek.fx.EditorGui.place;

import cz.paprsek.fx.view.projection.ProjectionPane;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.nio.file.Path;
import javafx.geometry.Point2D;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** A test in the projections of an editor in which nothing snaps at first. */
abstract class InProjections {
    @TempDir
    Path folder;

    EditorGui editor;

    /** What is opened. */
    abstract Scene scene();

    @BeforeEach
    void open() {
        editor = new EditorGui(folder, scene());
        editor.gui.act(() -> editor.editor.snapping().set(false));
    }

    @AfterEach
    void close() {
        editor.close();
    }

    void click(ProjectionPane pane, double x, double y, double z) {
        Point2D at = place(pane, x, y, z);
        editor.gui.click(pane, at.getX(), at.getY());
    }

    void drag(ProjectionPane pane, Vec3 from, Vec3 to) {
        Point2D a = place(pane, from.x(), from.y(), from.z());
        Point2D b = place(pane, to.x(), to.y(), to.z());
        editor.gui.drag(pane, a.getX(), a.getY(), b.getX(), b.getY());
    }

    Vec3 position(ScenePath item) {
        return editor.model().scene().objects().get(((ScenePath.BodyAt) item).index()).placement().position();
    }

    /** Pixels per scene unit: the height of a unit along y, or along x for the view from above. */
    static double scale(ProjectionPane pane) {
        double height = place(pane, 0, 1, 0).distance(place(pane, 0, 0, 0));
        return height > 0 ? height : place(pane, 1, 0, 0).distance(place(pane, 0, 0, 0));
    }
}
