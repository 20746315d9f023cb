package cz.paprsek.render.account;

import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.integrate.Whitted;
import cz.paprsek.render.sample.PixelSums;
import cz.paprsek.render.sample.Place;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.sample.Sampling;
import cz.paprsek.render.surface.World;
import cz.paprsek.scene.RenderSettings;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/** Traces single pixels and rays as a picture would, with everything written down. */
public final class Explainer {
    private Explainer() {}

    /** @param stop whether to give up, which throws a {@link java.util.concurrent.CancellationException} */
    public static Pixel pixel(World scene, RenderSettings settings, boolean fixed, int column, int row, BooleanSupplier stop) {
        Require.that(column >= 0 && column < settings.width() && row >= 0 && row < settings.height(),
                "pixel " + column + "," + row + " must lie inside the picture of " + settings.width() + " × " + settings.height() + " pixels");
        Require.that(!settings.isPath(), "these settings are of paths, whose pixels are explained as paths, not as trees of rays");
        Eye eye = eye(scene, settings);
        Sampling sampling = Sampling.of(settings, fixed);
        RayBook book = new RayBook(scene, settings.maxDepth(), stop);
        book.lookThrough(eye);
        PixelSums sums = new Whitted(scene, settings.maxDepth(), sampling, book).pixel(eye, column, row);
        List<Place> places = places(sampling, column, row, sums.count());
        return new Pixel(column, row, book.trees(), places.stream().map(place -> new Pixel.Place(place.x, place.y)).toList(),
                places.stream().map(place -> place.isNegative ? sums.negativeWeight : sums.weight).toList(), settings.exposure(), settings.tone());
    }

    private static List<Place> places(Sampling sampling, int column, int row, int count) {
        Sampler sampler = sampling.newSampler();
        return IntStream.range(0, count).mapToObj(i -> {
            Place place = new Place();
            sampling.place(sampler, column, row, i, place);
            return place;
        }).toList();
    }

    public static TracedRay point(World scene, RenderSettings settings, double x, double y, BooleanSupplier stop) {
        RayBook book = new RayBook(scene, settings.maxDepth(), stop);
        Whitted tracer = new Whitted(scene, settings.maxDepth(), Sampling.grid(1), book);
        Eye eye = eye(scene, settings);
        book.lookThrough(eye);
        tracer.startAlone(eye, x, y);
        tracer.traceAlone();
        return book.trees().get(0);
    }

    public static TracedRay ray(World scene, Vec3 origin, Vec3 direction, int maxDepth, BooleanSupplier stop) {
        Require.within("max-depth", maxDepth, 1, RenderSettings.DEEPEST);
        RayBook book = new RayBook(scene, maxDepth, stop);
        Whitted tracer = new Whitted(scene, maxDepth, Sampling.grid(1), book);
        tracer.startAlone(origin, direction.normalized());
        tracer.traceAlone();
        return book.trees().get(0);
    }

    private static Eye eye(World scene, RenderSettings settings) {
        return Eye.of(scene.scene().camera(), settings.width(), settings.height());
    }
}
