package cz.paprsek.lesson;

import cz.paprsek.asset.Assets;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.query.Column;
import cz.paprsek.query.Relation;
import cz.paprsek.query.SceneTables;
import cz.paprsek.query.Table;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CancellationException;
import java.util.function.IntBinaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * A scene, and what there is to see of it: a small picture, and of each of its pixels what the ray through its middle meets. What conditions of tasks are about.
 * Nothing is worked out before it is asked for.
 */
public final class Seen {
    /** So many pixels a small picture has at most. */
    private static final int MOST = 2000;
    private static final int MOST_PATHS = 64;

    /** All that is known of a scene as a database, and of the pixels of its picture, as {@code exists(pixel where object = "ball")}. */
    static final Table<Seen> TABLE = table();

    private final RenderScene ready;
    private final RenderSettings settings;
    private final RenderMonitor monitor;
    private @Nullable IntBinaryOperator shown;
    private @Nullable List<SeenPixel> pixels;

    /**
     * Looks at a scene.
     *
     * @throws CancellationException if the monitor cancels
     * @throws java.io.UncheckedIOException if a file of the scene cannot be read
     */
    Seen(Scene scene, Assets assets, RenderMonitor monitor) {
        this.ready = RenderScene.of(Objects.requireNonNull(scene, "scene"), assets, monitor);
        this.monitor = monitor;
        double scale = Math.min(1, Math.sqrt(MOST / ((double) scene.settings().width() * scene.settings().height())));
        RenderSettings small = scene.settings().withSize(Math.max(1, (int) (scale * scene.settings().width())), Math.max(1, (int) (scale * scene.settings().height())));
        this.settings = small.isPath() ? small.withMostRays(Math.min(MOST_PATHS, small.mostRays())) : small;
    }

    /** The settings with one ray a pixel, and without paths. */
    static RenderSettings whitted(RenderSettings settings) {
        return settings.withIntegrator(Integrator.WHITTED).withSamples(1);
    }

    private static Table<Seen> table() {
        List<Column<Seen>> columns = new ArrayList<>();
        SceneTables.SCENE.columns().forEach(column -> columns.add(column.through(seen -> Stream.of(seen.ready.scene()))));
        List<Relation<Seen, ?>> related = new ArrayList<>(List.of(new Relation<>(SeenPixel.TABLE, Seen::pixels, false)));
        SceneTables.SCENE.related().forEach(relation -> related.add(ofScene(relation)));
        return new Table<>("scene", columns, related);
    }

    private static <R> Relation<Seen, R> ofScene(Relation<Scene, R> relation) {
        return new Relation<>(relation.table(), seen -> relation.rows().apply(seen.ready.scene()), relation.isPart());
    }

    private Stream<SeenPixel> pixels() {
        if (pixels == null) {
            pixels = IntStream.range(0, settings.width() * settings.height()).mapToObj(this::pixel).toList();
        }
        return pixels.stream();
    }

    private SeenPixel pixel(int number) {
        if (monitor.cancelled()) {
            throw new CancellationException("nobody waits for it any more");
        }
        int column = number % settings.width();
        int row = number / settings.width();
        double x = column + 0.5;
        double y = row + 0.5;
        return SeenPixel.of(x / settings.width(), y / settings.height(), ready.explainPoint(whitted(settings), x, y),
                () -> shown().applyAsInt(column, row));
    }

    /** The colours of the small picture. */
    private IntBinaryOperator shown() {
        if (shown == null) {
            RenderResult result = Renderer.render(ready, RenderOptions.of(settings), monitor);
            if (result.outcome() == RenderResult.Outcome.CANCELLED) {
                throw new CancellationException("nobody waits for it any more");
            }
            shown = ImageOptions.shown(settings.exposure(), settings.tone()).shown(result.image());
        }
        return shown;
    }
}
