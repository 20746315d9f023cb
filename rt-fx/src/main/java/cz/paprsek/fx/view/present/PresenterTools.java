package cz.paprsek.fx.view.present;

import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import java.util.function.IntConsumer;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.Region;

/** What stands above picture and exercise: which pixel, which of its rays, and buttons, each with the key that does the same. */
final class PresenterTools extends FlowPane {
    private final Texts texts;
    private final Label title = new Label();
    private final Label progress = new Label();
    private final ToggleButton playing;
    private final ToggleButton zoomed;
    private final ToggleButton blank;

    /** @param onStep goes so many rays further, or back */
    PresenterTools(Texts texts, IntConsumer onStep) {
        super(8, 4);
        this.texts = texts;
        playing = tool(new ToggleButton(), "present.play", texts.of("present.space"));
        zoomed = tool(new ToggleButton(), "present.zoom", "Z");
        blank = tool(new ToggleButton(), "present.blank", "B");
        title.setId("present-title");
        progress.setId("present-progress");
        setId("present-tools");
        setAlignment(Pos.CENTER_LEFT);
        getChildren().addAll(title, button("present.back", "←", () -> onStep.accept(-1)), progress, button("present.next", "→", () -> onStep.accept(1)), playing, zoomed, blank);
    }

    Label title() {
        return title;
    }

    Label progress() {
        return progress;
    }

    ToggleButton playing() {
        return playing;
    }

    ToggleButton zoomed() {
        return zoomed;
    }

    ToggleButton blank() {
        return blank;
    }

    private Button button(String key, String keys, Runnable action) {
        Button button = new Button();
        button.setOnAction(event -> action.run());
        return tool(button, key, keys);
    }

    /** @param keys what does the same, as it is written on them */
    private <T extends ButtonBase> T tool(T button, String key, String keys) {
        button.setText(texts.of(key));
        button.setId(key.replace('.', '-'));
        Hint.of(button).set(keys);
        button.setFocusTraversable(false);
        button.setMinWidth(Region.USE_PREF_SIZE);
        return button;
    }
}
