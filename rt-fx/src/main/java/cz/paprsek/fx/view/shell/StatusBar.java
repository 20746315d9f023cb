package cz.paprsek.fx.view.shell;

import cz.paprsek.fx.view.look.OwnLayout;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;

/** The line at the bottom of the window: what happened last, where the mouse is in the world, what is selected. */
public final class StatusBar extends HBox {
    /** More than where the mouse is takes, pixels. */
    private static final double ROOM = 300;

    private final Label message = label("status-message");
    private final Button warnings = new Button("", new FontIcon(MaterialDesignA.ALERT_OUTLINE));
    private final Label cursor = label("status-cursor");
    private final Label selection = label("status-selection");
    private final Label render = label("status-render");
    private boolean isPointing;

    public StatusBar() {
        setId("status-bar");
        getStyleClass().add("status-bar");
        setAlignment(Pos.CENTER_LEFT);
        HBox.setHgrow(message, Priority.ALWAYS);
        message.setMaxWidth(Double.MAX_VALUE);
        message.setMinWidth(0);
        // What is too long goes on below rather than being cut off.
        message.setWrapText(true);
        message.setMinHeight(Region.USE_PREF_SIZE);
        warnings.setId("status-warnings");
        warnings.getStyleClass().add("view-button");
        warnings.setMinWidth(Region.USE_PREF_SIZE);
        warnings.setFocusTraversable(false);
        showWarnings("");
        cursor.setMinWidth(Region.USE_PREF_SIZE);
        selection.setMinWidth(Region.USE_PREF_SIZE);
        render.setMinWidth(Region.USE_PREF_SIZE);
        getChildren().addAll(message, warnings, cursor, selection, render);
    }

    public void showMessage(String text) {
        message.setText(text);
    }

    /** Shows a message no more, if it is still the one that is shown. */
    public void endMessage(String text) {
        if (message.getText().equals(text)) {
            message.setText("");
        }
    }

    /** Shows how many warnings there are, in words, as a button; none if that is empty. */
    public void showWarnings(String count) {
        warnings.setText(count);
        warnings.setVisible(!count.isEmpty());
        warnings.setManaged(!count.isEmpty());
    }

    /** What the button of the warnings does. */
    public void setOnWarnings(Runnable action) {
        warnings.setOnAction(event -> action.run());
    }

    public void showCursor(String text) {
        isPointing = message.prefWidth(-1) + ROOM < message.getWidth();
        cursor.setText(text);
        isPointing = false;
    }

    /** Where the mouse is changes with each movement, and has only this line laid out anew as long as the message has one line anyway. */
    @Override
    public void requestLayout() {
        if (isPointing && OwnLayout.suffices(this)) {
            setNeedsLayout(true);
        } else {
            super.requestLayout();
        }
    }

    public void showSelection(String text) {
        selection.setText(text);
    }

    /** Shows what has become of the last render, now and later. */
    public void followRender(ObservableValue<String> words) {
        render.textProperty().bind(words);
    }

    private static Label label(String id) {
        Label label = new Label();
        label.setId(id);
        return label;
    }
}
