package cz.paprsek.fx.view.shell;

import java.util.List;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;

/** A strip at the top of the window that says something and may ask something, while work can go on. */
public final class MessageBar extends HBox {
    /** An answer. */
    public record Choice(String id, String text, Runnable action) {}

    private final Label label = new Label();

    public MessageBar(String closeHint) {
        setId("message-bar");
        getStyleClass().add("message-bar");
        setAlignment(Pos.CENTER_LEFT);
        label.setId("message");
        label.setMaxWidth(Double.MAX_VALUE);
        label.setWrapText(true);
        HBox.setHgrow(label, Priority.ALWAYS);
        Button close = new Button("", new FontIcon(MaterialDesignC.CLOSE));
        close.setId("message-close");
        close.setAccessibleText(closeHint);
        close.getStyleClass().add("view-button");
        close.setOnAction(event -> hide());
        getChildren().addAll(label, close);
        hide();
    }

    public void show(String text, List<Choice> choices) {
        hide();
        label.setText(text);
        for (Choice choice : choices) {
            Button button = new Button(choice.text());
            button.setId(choice.id());
            button.setMinWidth(Region.USE_PREF_SIZE);
            button.setOnAction(event -> {
                hide();
                choice.action().run();
            });
            getChildren().add(getChildren().size() - 1, button);
        }
        setVisible(true);
        setManaged(true);
    }

    public void hide() {
        getChildren().remove(1, getChildren().size() - 1);
        label.setText("");
        setVisible(false);
        setManaged(false);
    }
}
