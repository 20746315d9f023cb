package cz.paprsek.fx;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.AddPalette;
import cz.paprsek.fx.view.ObjectTree;
import cz.paprsek.fx.view.PaneGrid;
import cz.paprsek.fx.view.PropertySheet;
import cz.paprsek.fx.view.Texts;
import cz.paprsek.fx.view.Theme;
import cz.paprsek.fx.view.TitledView;
import cz.paprsek.fx.view.projection.Axes;
import cz.paprsek.fx.view.projection.ProjectionPane;
import cz.paprsek.math.Vec3;
import java.util.List;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.SplitPane;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;

/** What the window holds, in one language: made anew when the language changes, while the model stays. */
final class MainWindow {
    private final BorderPane root = new BorderPane();

    MainWindow(EditorModel model, Texts texts, ObservableValue<Theme> theme) {
        root.setId("main-window");
        BooleanProperty snapping = new SimpleBooleanProperty(true);
        ObjectTree tree = new ObjectTree(model, texts);
        AddPalette palette = new AddPalette(model, texts, () -> Vec3.ZERO);
        VBox.setVgrow(tree, Priority.ALWAYS);
        PaneGrid grid = new PaneGrid(List.of(
                view("top", texts.of("view.top"), texts, new ProjectionPane(model, texts, Axes.TOP, theme, snapping)),
                view("camera", texts.of("view.camera"), texts, new StackPane()),
                view("front", texts.of("view.front"), texts, new ProjectionPane(model, texts, Axes.FRONT, theme, snapping)),
                view("right", texts.of("view.right"), texts, new ProjectionPane(model, texts, Axes.RIGHT, theme, snapping))));
        PropertySheet sheet = new PropertySheet(model, texts);
        VBox left = new VBox(palette, tree);
        SplitPane.setResizableWithParent(left, false);
        SplitPane.setResizableWithParent(sheet, false);
        SplitPane center = new SplitPane(left, grid, sheet);
        center.setDividerPositions(0.17, 0.78);
        root.setCenter(center);
    }

    Parent root() {
        return root;
    }

    private static TitledView view(String name, String caption, Texts texts, Node content) {
        return new TitledView(name, caption, texts.of("view.maximize"), content);
    }
}
