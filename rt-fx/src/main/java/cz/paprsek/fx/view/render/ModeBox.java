package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.render.fields.Named;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.render.mode.RenderMode;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Tooltip;

/** Chooses what a picture shows: light, or something to learn from. */
final class ModeBox extends ChoiceBox<Named<RenderMode>> {
    ModeBox(Texts texts) {
        setId("render-mode");
        setTooltip(new Tooltip(texts.of("render.mode.hint")));
        for (RenderMode mode : RenderMode.values()) {
            getItems().add(new Named<>(mode, texts.of("mode." + mode)));
        }
        reset();
    }

    /** Chooses light. */
    void reset() {
        getSelectionModel().selectFirst();
    }

    RenderMode mode() {
        return getValue().value();
    }
}
