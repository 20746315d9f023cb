package cz.paprsek.cli.output;

import cz.paprsek.asset.Assets;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderScene;
import cz.paprsek.scene.Scene;
import org.jspecify.annotations.Nullable;

/** What is prepared of one frame of a film, and taken over by the next: of a flight of the camera, all but the camera. */
final class Scenery {
    private @Nullable RenderScene latest;

    RenderScene prepared(Scene scene, Assets assets, RenderMonitor monitor) {
        RenderScene fresh = latest == null ? RenderScene.of(scene, assets, monitor) : latest.changedTo(scene, monitor);
        latest = fresh;
        return fresh;
    }
}
