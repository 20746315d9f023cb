package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.util.Locale;
import java.util.Optional;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.control.TextField;

/** The sheet of a scene in a window of its own, high enough for all of it. */
record SheetInHand(EditorModel model, Clock clock, Gui gui) {
    static SheetInHand of(Scene scene) {
        return of(scene, Locale.ENGLISH);
    }

    static SheetInHand of(Scene scene, Locale language) {
        EditorModel model = new EditorModel(scene);
        Clock clock = new Clock(model);
        return new SheetInHand(model, clock, Gui.show(
                () -> new PropertySheet(model, Texts.in(language), new SimpleBooleanProperty(true), (kind, owner) -> Optional.empty(), clock), 320, 900));
    }

    /** A parameter w of 3, a camera, and what is given, as a scene file has it. */
    static Scene scene(String rest) {
        try {
            return SceneFiles.parse("""
                    <scene xmlns="urn:paprsek:scene:1"><param name="w" value="3" min="1" max="9"/><camera position="0 0 9" target="0 0 0"/>
                    """ + rest + "</scene>");
        } catch (SceneFileException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Opens a scene whose first body is a ball, which is selected then. */
    void select(Scene scene) {
        gui.act(() -> model.open(scene));
        gui.act(() -> model.select(ScenePath.body(0)));
        gui.until("the sheet shows the ball", () -> gui.stage().getScene().lookup("#shape-radius") instanceof TextField field && !field.getText().isEmpty());
    }
}
