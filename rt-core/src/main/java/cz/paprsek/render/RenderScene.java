package cz.paprsek.render;

import cz.paprsek.scene.Scene;

/** A scene prepared for tracing. Immutable; any number of renders may use it at once. */
public final class RenderScene {
    private RenderScene() {}

    public static RenderScene of(Scene scene) {
        return of(scene, RenderMonitor.NONE);
    }

    /** @throws java.util.concurrent.CancellationException if the monitor cancels before the scene is ready */
    public static RenderScene of(Scene scene, RenderMonitor monitor) {
        monitor.cancelled();
        return new RenderScene();
    }
}
