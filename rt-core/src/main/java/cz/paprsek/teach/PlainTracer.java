package cz.paprsek.teach;

import cz.paprsek.image.Image;
import cz.paprsek.math.Require;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * The plain tracer, with mistakes or without. Without, its pictures are the renderer's, to the last bit, with a grid of rays a pixel: of {@code samples} A..B
 * it takes A × A. Immutable; any number of threads may use it.
 */
public final class PlainTracer {
    private final Scene scene;
    private final RenderSettings settings;
    private final Mistakes made;
    private final Tracer tracer;
    private final Development development;

    private PlainTracer(Scene scene, RenderSettings settings, Mistakes made) {
        this.scene = scene;
        this.settings = settings;
        this.made = made;
        this.tracer = new Tracer(scene, settings, made, Notes.NONE);
        this.development = new Development(made);
    }

    /**
     * For pictures of a scene.
     *
     * @throws IllegalArgumentException if it does not know all that is in the scene, saying what
     */
    public static PlainTracer of(Scene scene, RenderSettings settings, Mistakes made) {
        List<String> unknown = unknown(scene, settings);
        Scene shown = scene.shown();
        Objects.requireNonNull(made, "made");
        Require.that(unknown.isEmpty(), unknown.isEmpty() ? "" : Unknown.sentence(unknown));
        return new PlainTracer(shown, settings, made);
    }

    /** What of a scene it does not know, in the words of scene files; empty if it can be used. */
    public static List<String> unknown(Scene scene, RenderSettings settings) {
        return Unknown.in(Objects.requireNonNull(scene, "scene").shown(), Objects.requireNonNull(settings, "settings"));
    }

    /**
     * The light of a pixel, linear: red, green, blue. What goes wrong after that is not in it.
     *
     * @param mostRays how many rays it may take, from the eye and from surfaces; shadow rays are not counted
     * @return empty if it takes more
     */
    public Optional<double[]> light(int column, int row, int mostRays) {
        Tracer.Allowance allowed = new Tracer.Allowance(mostRays);
        Vec light = tracer.pixel(column, row, allowed);
        return allowed.isExceeded() ? Optional.empty() : Optional.of(new double[] {light.x(), light.y(), light.z()});
    }

    /** The light that a right picture would have to show the numbers that come of some light with mistakes. */
    public static double[] developed(double[] light, Mistakes made) {
        Vec developed = new Development(made).of(new Vec(light[0], light[1], light[2]));
        return new double[] {developed.x(), developed.y(), developed.z()};
    }

    /**
     * The whole picture.
     *
     * @throws CancellationException if asked to stop
     */
    public Image render(BooleanSupplier stop) {
        Objects.requireNonNull(stop, "stop");
        Image image = new Image(settings.width(), settings.height());
        IntStream.range(0, image.height()).parallel().forEach(row -> {
            for (int column = 0; column < image.width(); column++) {
                if (stop.getAsBoolean()) {
                    throw new CancellationException("asked to stop");
                }
                Vec light = development.of(tracer.pixel(column, row, Tracer.Allowance.unlimited()));
                image.set(column, row, light.x(), light.y(), light.z());
            }
        });
        return image;
    }

    /**
     * The numbers of a pixel, by the names that they have in formulas: one or three each. Of the first ray through it.
     *
     * @throws IllegalArgumentException if there is no such pixel
     */
    public Map<String, double[]> numbers(int column, int row) {
        Require.that(column >= 0 && row >= 0 && column < settings.width() && row < settings.height(),
                "pixel " + column + "," + row + " must lie inside the picture of " + settings.width() + " × " + settings.height() + " pixels");
        Notes.Written written = new Notes.Written();
        Vec light = development.of(new Tracer(scene, settings.withSamples(1), made, written).pixel(column, row, Tracer.Allowance.unlimited()));
        written.put("B", light);
        return new LinkedHashMap<>(written.values);
    }
}
