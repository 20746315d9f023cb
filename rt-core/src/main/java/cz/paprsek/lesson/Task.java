package cz.paprsek.lesson;

import cz.paprsek.asset.Assets;
import cz.paprsek.lesson.Lesson.Part;
import cz.paprsek.query.Filter;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.scene.Scene;
import java.util.Objects;

/**
 * Something to be done with the scene.
 *
 * @param asked what
 * @param condition what is so when it is done
 * @param hint how to begin
 * @param why what is to be learnt from it, told when it is done
 * @param solution a scene in which it is done
 */
public record Task(Said asked, Filter<Seen> condition, Said hint, Said why, Scene solution) implements Part {
    public Task {
        Objects.requireNonNull(asked, "asked");
        Objects.requireNonNull(condition, "condition");
        Objects.requireNonNull(hint, "hint");
        Objects.requireNonNull(why, "why");
        Objects.requireNonNull(solution, "solution");
    }

    /**
     * Whether a scene is as it should be.
     *
     * @throws java.util.concurrent.CancellationException if the monitor cancels
     * @throws java.io.UncheckedIOException if a file of the scene cannot be read
     */
    public boolean isDone(Scene scene, Assets assets, RenderMonitor monitor) {
        return condition.test(new Seen(scene, assets, monitor));
    }
}
