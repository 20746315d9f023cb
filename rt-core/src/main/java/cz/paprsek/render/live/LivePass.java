package cz.paprsek.render.live;

import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderScene;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import java.util.Objects;

/**
 * One of the ever finer pictures by which a {@link LiveRender} gets to the final one.
 *
 * @param scene what is rendered
 * @param settings of the final picture
 * @param step how many pixels of the final picture stand side by side in one of this pass
 * @param isLast whether this is the final picture: every pixel with all its samples
 */
public record LivePass(RenderScene scene, RenderSettings settings, int step, boolean isLast) {
    public LivePass {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(settings, "settings");
    }


    /** What to render for this pass. */
    RenderOptions options(int threads) {
        RenderSettings own = isLast ? settings
                : settings.withSamples(1).withFilter(PixelFilter.BOX);
        return RenderOptions.of(own).withStep(step).withThreads(threads);
    }

    /** The next finer pass. */
    LivePass next() {
        return step > 1 ? at(scene, settings, step / 2) : new LivePass(scene, settings, 1, true);
    }

    /** The pass of the given step, a power of two; the last one if there is nothing to add to it. */
    static LivePass at(RenderScene scene, RenderSettings settings, int step) {
        return new LivePass(scene, settings, step, step == 1 && settings.mostRays() == 1);
    }
}
