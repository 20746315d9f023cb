package cz.paprsek.fx.view.explain;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.edit.Visible;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;

/** Selects in the model what a ray hits. */
public record SurfaceSelection(EditorModel model) {

    /** @param scene in which the ray was followed; if its objects are not those of the model any more, nothing is selected */
    public void select(Scene scene, ScenePath surface) {
        Visible visible = Visible.of(model.state());
        boolean isWhole = scene.objects().equals(model.scene().objects());
        boolean isCurrent = isWhole || scene.objects().equals(visible.scene().objects());
        ScenePath body = isWhole ? surface : visible.original(surface);
        if (isCurrent && body.isIn(model.scene()) && !model.state().isLocked(body)) {
            model.select(body);
        }
    }
}
