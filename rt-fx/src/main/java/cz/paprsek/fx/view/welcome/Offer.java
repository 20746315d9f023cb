package cz.paprsek.fx.view.welcome;

import cz.paprsek.asset.Assets;
import cz.paprsek.scene.Scene;
import java.util.concurrent.Callable;

/**
 * A scene to begin with.
 *
 * @param hint where it comes from; empty for nowhere that needs saying
 * @param reading reads it for its picture, on a thread of the background; what it throws means that there is none
 * @param action opens it
 */
public record Offer(String title, String hint, Callable<Subject> reading, Runnable action) {
    /** A scene, and where its pictures come from. */
    public record Subject(Scene scene, Assets assets) {}
}
