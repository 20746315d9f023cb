package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.render.fields.Named;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.render.mode.RenderMode;
import javafx.scene.control.ChoiceBox;

/** Chooses what a picture shows: light, or something to learn from. */
final class ModeBox extends ChoiceBox<Named<RenderMode>> {
    ModeBox(Texts texts) {
        setId("render-mode");
        Hint.of(this).set(texts.of("render.mode.hint"));
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
