package cz.paprsek.fx.view.shell;

import cz.paprsek.fx.view.look.Hint;
import javafx.beans.binding.Bindings;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.control.Labeled;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignW;

/** One of the four views: a narrow title with a button that makes it fill the whole, and the view itself. */
public final class TitledView extends BorderPane {
    /** A narrower title has room for its caption and one name only, pixels. */
    private static final double ROOM_FOR_TEXTS = 330;
    /** And one narrower than this for its caption only, pixels. */
    private static final double ROOM_FOR_A_NAME = 230;

    private final Node content;
    private final FontIcon icon = new FontIcon(MaterialDesignW.WINDOW_MAXIMIZE);
    private final HBox title;
    private Runnable onMaximize = () -> {};

    /** @param name for style sheets and tests: the button's id is the name with "-maximize" */
    public TitledView(String name, String caption, String maximizeHint, Node content) {
        this.content = content;
        Label label = new Label(caption);
        label.getStyleClass().add("view-caption");
        label.setMinWidth(Region.USE_PREF_SIZE);
        Region space = new Region();
        HBox.setHgrow(space, Priority.ALWAYS);
        Button maximize = new Button("", icon);
        maximize.setId(name + "-maximize");
        maximize.getStyleClass().add("view-button");
        Hint.of(maximize).set(maximizeHint);
        maximize.setAccessibleText(maximizeHint);
        maximize.setFocusTraversable(false);
        maximize.setOnAction(event -> onMaximize.run());
        title = new HBox(4, label, space, maximize);
        title.setAlignment(Pos.CENTER_LEFT);
        title.getStyleClass().add("view-title");
        title.setOnMouseClicked(event -> {
            if (event.getClickCount() == 2) {
                onMaximize.run();
            }
        });
        getStyleClass().add("view");
        setTop(title);
        setCenter(content);
        // What is drawn inside must not keep a divider from moving.
        setMinSize(60, 60);
        content.focusWithinProperty().addListener((property, old, now) -> {
            getStyleClass().remove("active");
            if (now) {
                getStyleClass().add("active");
            }
        });
    }

    /** Puts buttons and the like into the title, left of the button that maximises. */
    public void addTool(Node tool) {
        title.getChildren().add(title.getChildren().size() - 1, tool);
    }

    /** Puts a button into the title which loses its text, but not its icon, where there is no room. */
    public void addFoldingTool(Labeled tool) {
        addTool(tool);
        fold(tool, ROOM_FOR_TEXTS);
        tool.setMinWidth(Region.USE_PREF_SIZE);
    }

    /** Puts a menu into the title which loses the name of what is chosen, but not its icon, where not even that has room. */
    public void addChooser(Labeled chooser) {
        addTool(chooser);
        fold(chooser, ROOM_FOR_A_NAME);
    }

    private void fold(Labeled tool, double room) {
        tool.contentDisplayProperty().bind(Bindings.when(title.widthProperty().lessThan(room)).then(ContentDisplay.GRAPHIC_ONLY).otherwise(ContentDisplay.LEFT));
    }

    /** The view itself. */
    public Node content() {
        return content;
    }

    /** Gives the keyboard to the view. */
    public void focusContent() {
        content.requestFocus();
    }

    void setOnMaximize(Runnable action) {
        onMaximize = action;
    }

    void setMaximized(boolean value) {
        icon.setIconCode(value ? MaterialDesignW.WINDOW_RESTORE : MaterialDesignW.WINDOW_MAXIMIZE);
    }
}
