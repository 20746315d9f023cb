package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.texts.Texts;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;

/** Asks how to render, over what is behind it: Enter renders, Escape leaves all as it was said last. */
final class RenderDialog extends StackPane {
    private final RenderForm form;
    private final Node behind;
    private final Runnable onClosed;

    /**
     * @param behind what nothing can be done with as long as it is asked
     * @param onClosed is told when it is over, either way
     * @param onAnswered is told when to render what the form says
     * @param onAsScene is told when to fill in what the scene asks for
     */
    RenderDialog(RenderForm form, Texts texts, Node behind, Runnable onClosed, Runnable onAnswered, Runnable onAsScene) {
        this.form = form;
        this.behind = behind;
        this.onClosed = onClosed;
        Button render = button(texts.of("render.start"), "render-start", () -> {
            close();
            onAnswered.run();
        });
        render.setDefaultButton(true);
        render.disableProperty().bind(form.valid().not());
        Button cancel = button(texts.of("render.ask.cancel"), "render-ask-cancel", this::close);
        Button asScene = button(texts.of("render.ask.as-scene"), "render-ask-as-scene", onAsScene);
        Region between = new Region();
        HBox.setHgrow(between, Priority.ALWAYS);
        HBox buttons = new HBox(8, asScene, between, cancel, render);
        buttons.setAlignment(Pos.CENTER_RIGHT);
        ScrollPane scroll = new ScrollPane(form);
        scroll.setFitToWidth(true);
        scroll.setFocusTraversable(false);
        Label title = new Label(texts.of("render.ask.title"));
        title.getStyleClass().add("render-dialog-title");
        VBox box = new VBox(10, title, scroll, buttons);
        box.getStyleClass().add("render-dialog");
        box.setMaxSize(USE_PREF_SIZE, USE_PREF_SIZE);
        getChildren().add(box);
        setId("render-dialog");
        getStyleClass().add("render-dialog-room");
        setVisible(false);
        addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                close();
                event.consume();
            }
        });
    }

    private static Button button(String text, String id, Runnable action) {
        Button button = new Button(text);
        button.setId(id);
        button.setMinWidth(USE_PREF_SIZE);
        button.setOnAction(event -> action.run());
        return button;
    }

    /** Asks, beginning with the size. */
    void open() {
        behind.setDisable(true);
        setVisible(true);
        form.takeKeys();
    }

    private void close() {
        setVisible(false);
        behind.setDisable(false);
        onClosed.run();
    }
}
