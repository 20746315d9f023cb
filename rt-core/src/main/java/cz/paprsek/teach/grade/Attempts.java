package cz.paprsek.teach.grade;

import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.PlainTracer;
import cz.paprsek.teach.mistake.Mistake.Part;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.BooleanSupplier;

/** What pictures with mistakes look like at some places; each place is traced once for each mistake, however many pictures it is compared with. */
final class Attempts {
    /** More rays are not followed, for each ray through a pixel: what is seen at the few places that take more is left open. */
    private static final int RAYS = 64;

    private final Scene scene;
    private final RenderSettings settings;
    private final Places places;
    private final BooleanSupplier stop;
    private final Map<Mistakes, Attempt> light = new ConcurrentHashMap<>();

    /** The light with some mistakes, as far as it is known. */
    private record Attempt(PlainTracer tracer, AtomicReferenceArray<double[]> light) {}

    Attempts(Scene scene, RenderSettings settings, Places places, BooleanSupplier stop) {
        this.scene = scene;
        this.settings = settings;
        this.places = places;
        this.stop = stop;
    }

    Places places() {
        return places;
    }

    /** The numbers at some places; unknown where light takes too many rays. What goes wrong when light becomes numbers needs no rays of its own. */
    Sheet with(Mistakes made, int[] at, boolean isGrey) {
        Attempt attempt = light.computeIfAbsent(made.without(Part.PICTURE), rays ->
                new Attempt(PlainTracer.of(scene, settings, rays), new AtomicReferenceArray<>(places.count())));
        double[][] found = new double[at.length][];
        for (int i = 0; i < at.length; i++) {
            double[] known = attempt.light.get(at[i]);
            found[i] = known == null ? traced(attempt, at[i]) : known;
        }
        return Sheet.of(found, made, isGrey);
    }

    private double[] traced(Attempt attempt, int place) {
        if (stop.getAsBoolean()) {
            throw new CancellationException("asked to stop");
        }
        double[] traced = attempt.tracer.light(places.column(place), places.row(place), RAYS * settings.samples() * settings.samples()).orElse(Sheet.UNKNOWN);
        attempt.light.set(place, traced);
        return traced;
    }
}
