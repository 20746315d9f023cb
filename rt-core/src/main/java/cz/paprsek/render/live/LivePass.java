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
 * @param paths how many there are in a pixel, if the light of the final picture is that of paths
 * @param isLast whether this is the final picture: every pixel with all its samples
 */
public record LivePass(RenderScene scene, RenderSettings settings, int step, int paths, boolean isLast) {
    /** How many times as many paths as a pass the next one has: all that came before cost a third of the last. */
    private static final int MORE = 4;

    public LivePass {
        Objects.requireNonNull(scene, "scene");
        Objects.requireNonNull(settings, "settings");
    }

    /** What to render for this pass. */
    RenderOptions options(int threads) {
        RenderSettings own = isLast ? settings : settings.withSamples(paths).withFilter(step > 1 || !settings.isPath() ? PixelFilter.BOX : settings.filter());
        return RenderOptions.of(own).withStep(step).withThreads(threads);
    }

    /** The next finer pass. */
    LivePass next() {
        return step > 1 ? at(scene, settings, step / 2) : at(scene, settings, settings.isPath() ? paths * MORE : Integer.MAX_VALUE, 1);
    }

    /** The pass of the given step, a power of two; the last one if there is nothing to add to it. */
    static LivePass at(RenderScene scene, RenderSettings settings, int step) {
        return at(scene, settings, 1, step);
    }

    private static LivePass at(RenderScene scene, RenderSettings settings, int paths, int step) {
        boolean isLast = step == 1 && paths >= settings.mostRays();
        return new LivePass(scene, settings, step, isLast ? settings.samples() : paths, isLast);
    }
}
