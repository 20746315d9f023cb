package cz.paprsek.fx.view.texts;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.property.Section;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import java.util.Set;

/** What the sheet calls what it shows. */
public final class Titles {
    private final Texts texts;

    public Titles(Texts texts) {
        this.texts = texts;
    }

    /** What is selected, in a few words. */
    public String of(EditorState state) {
        Set<ScenePath> selection = state.selection();
        if (selection.isEmpty()) {
            return texts.of("section.scene");
        }
        if (selection.size() > 1) {
            return texts.of("sheet.several", selection.size());
        }
        ScenePath item = selection.iterator().next();
        if (item instanceof BodyAt at) {
            Body body = at.in(state.scene());
            return named(capital(texts.kind(body.shape())), body.name());
        }
        if (item instanceof LightAt at) {
            Light light = state.scene().lights().get(at.index());
            return named(capital(texts.kind(light)), light.name());
        }
        return named(texts.of("section.camera"), item instanceof CameraAt camera ? state.scene().cameras().get(camera.index()).name() : "");
    }

    /** A section's heading. */
    public String of(Section section) {
        return capital(texts.of(section.title()));
    }

    private String named(String kind, String name) {
        return name.isEmpty() ? kind : texts.of("sheet.named", kind, name);
    }

    private String capital(String text) {
        return text.substring(0, 1).toUpperCase(texts.locale()) + text.substring(1);
    }
}
