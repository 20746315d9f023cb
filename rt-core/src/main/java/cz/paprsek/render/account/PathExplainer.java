package cz.paprsek.render.account;

import cz.paprsek.math.Require;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.Pixel.PathPixel;
import cz.paprsek.render.explain.Pixel.PathPixel.Example;
import cz.paprsek.render.explain.Pixel.PathPixel.Source;
import cz.paprsek.render.explain.Pixel.PathPixel.Way;
import cz.paprsek.render.eye.Eye;
import cz.paprsek.render.integrate.Ledger;
import cz.paprsek.render.integrate.Paths;
import cz.paprsek.render.light.Emitters;
import cz.paprsek.render.sample.PassSums;
import cz.paprsek.render.sample.Passes;
import cz.paprsek.render.sample.Sampler;
import cz.paprsek.render.surface.World;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.ScenePath;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/** Traces all paths of a pixel as a picture would, and tells what they bring. */
public final class PathExplainer {
    /** More of them take longer than anybody waits. */
    private static final int MOST_PATHS = 1 << 17;
    /** So many surfaces of a way are told apart: those nearest to the eye. */
    private static final int MOST_SURFACES = 4;
    private static final int MOST_EXAMPLES = 12;

    private final World scene;
    private final Emitters emitters;
    private final RenderSettings settings;
    private final Passes sampling;
    private final Ledger ledger = new Ledger();
    private final Paths tracer;
    private final Map<Tally.Key, Tally> ways = new LinkedHashMap<>();
    private final Map<Tally.Key, Tally> sources = new LinkedHashMap<>();
    private final PassSums sums;
    private final List<LinearRgb> samples = new ArrayList<>();

    private PathExplainer(World scene, RenderSettings settings, boolean fixed) {
        this.scene = scene;
        emitters = scene.emitters();
        this.settings = settings;
        sampling = new Passes(settings, fixed, true);
        tracer = new Paths(scene, settings.maxDepth(), sampling, ledger);
        sums = sampling.newSums();
    }

    /** @param stop whether to give up, which throws a {@link CancellationException} */
    public static PathPixel pixel(World scene, RenderSettings settings, boolean fixed, int column, int row, BooleanSupplier stop) {
        Require.that(settings.isPath(), "these settings are of rays, not of paths");
        Require.that(column >= 0 && column < settings.width() && row >= 0 && row < settings.height(),
                "pixel " + column + "," + row + " must lie inside the picture of " + settings.width() + " × " + settings.height() + " pixels");
        return new PathExplainer(scene, settings, fixed).pixel(column, row, stop);
    }

    private PathPixel pixel(int column, int row, BooleanSupplier stop) {
        Eye eye = Eye.of(scene.scene().camera(), settings.width(), settings.height());
        tracer.begin(stop);
        double interval = sums.interval();
        for (int more = sampling.further(sums); more > 0; more = sampling.further(sums)) {
            Require.that(sums.count() < MOST_PATHS, "there are more than " + MOST_PATHS + " paths, too many to explain; ask for fewer samples, or a larger error");
            for (int i = 0; i < more; i++) {
                trace(eye, column, row, sums.count());
            }
            if (tracer.isCancelled()) {
                throw new CancellationException();
            }
            interval = sums.areWhole() ? sums.interval() : interval;
        }
        sums.mean();
        List<Tally> brightest = ordered(ways);
        return new PathPixel(column, row, samples, new LinearRgb(sums.red, sums.green, sums.blue), interval, brightest.stream().map(this::way).toList(), ordered(sources).stream().map(this::way).toList(),
                examples(brightest, eye, column, row, stop), settings.exposure(), settings.tone());
    }

    private void trace(Eye eye, int column, int row, int sample) {
        ledger.clear();
        tracer.traceAlone(eye, column, row, sample);
        ledger.close();
        boolean isNegative = tracer.alone().isNegative;
        sums.meets |= tracer.alone().ray.part >= 0;
        sums.add(tracer.alone().red, tracer.alone().green, tracer.alone().blue, isNegative);
        samples.add(new LinearRgb(tracer.alone().red, tracer.alone().green, tracer.alone().blue));
        for (int i = 0; i < ledger.entries(); i++) {
            if (ledger.red(i) != 0 || ledger.green(i) != 0 || ledger.blue(i) != 0) {
                Tally.Key key = key(i);
                add(ways, key, sample, isNegative, i);
                add(sources, new Tally.Key(key.source(), key.number(), List.of(), false), sample, isNegative, i);
            }
        }
    }

    private void add(Map<Tally.Key, Tally> to, Tally.Key key, int sample, boolean isNegative, int entry) {
        to.computeIfAbsent(key, one -> new Tally(one, Sampler.SCRAMBLES))
                .add(sample, Sampler.scramble(sample), isNegative, ledger.red(entry), ledger.green(entry), ledger.blue(entry));
    }

    private Tally.Key key(int entry) {
        int from = ledger.source(entry);
        int ray = ledger.ray(entry);
        boolean isBody = emitters.has(from);
        Source source = from >= 0 && from < scene.lamps().length ? Source.LIGHT : from == Ledger.SKY || (from >= 0 && !isBody) ? Source.SKY : from == Ledger.AMBIENT ? Source.AMBIENT : Source.SURFACE;
        int number = source == Source.LIGHT ? from : isBody ? emitters.object(from) : source == Source.SURFACE ? object(ray) : 0;
        List<Integer> objects = new ArrayList<>();
        for (int at = source == Source.SURFACE && !isBody ? ledger.parent(ray) : ray; at >= 0; at = ledger.parent(at)) {
            if (ledger.part(at) >= 0) {
                objects.add(object(at));
            }
        }
        int most = objects.size();
        return new Tally.Key(source, number, List.copyOf(objects.subList(Math.max(0, most - MOST_SURFACES), most)), most > MOST_SURFACES);
    }

    private int object(int ray) {
        return scene.index(scene.parts().object(ledger.part(ray)));
    }

    private List<Tally> ordered(Map<Tally.Key, Tally> tallies) {
        List<Tally> all = new ArrayList<>(tallies.values());
        all.sort(Comparator.comparingDouble(this::brightness).reversed());
        return Collections.unmodifiableList(all);
    }

    private double brightness(Tally tally) {
        LinearRgb light = tally.light(sums.weight, sums.negativeWeight);
        return light.red() + light.green() + light.blue();
    }

    private Way way(Tally tally) {
        Tally.Key key = tally.key;
        Optional<ScenePath> shines = switch (key.source()) {
            case LIGHT -> Optional.of(ScenePath.light(key.number()));
            case SURFACE -> Optional.of(ScenePath.body(key.number()));
            case SKY, AMBIENT -> Optional.empty();
        };
        Optional<LinearRgb> halfWidth = sums.count() % PassSums.PASS == 0 ? Optional.of(tally.halfWidth(sums.weight, sums.negativeWeight, sampling.deviations())) : Optional.empty();
        return new Way(key.source(), shines.map(this::inScene), key.objects().stream().<InScene<? extends ScenePath>>map(object -> inScene(ScenePath.body(object))).toList(), key.isShortened(), tally.paths(),
                tally.light(sums.weight, sums.negativeWeight), halfWidth);
    }

    private InScene<? extends ScenePath> inScene(ScenePath place) {
        return new InScene<>(scene.scene(), place);
    }

    private List<Example> examples(List<Tally> brightest, Eye eye, int column, int row, BooleanSupplier stop) {
        // What the last ray meets still shines.
        RayBook book = new RayBook(scene, settings.maxDepth() + 1, stop);
        book.lookThrough(eye);
        Paths retracer = new Paths(scene, settings.maxDepth(), sampling, book);
        retracer.begin(stop);
        return IntStream.range(0, Math.min(MOST_EXAMPLES, brightest.size())).mapToObj(i -> {
            int sample = brightest.get(i).typical();
            retracer.traceAlone(eye, column, row, sample);
            return new Example(i, sample, book.trees().get(i), brightest.get(i).brought(sample).orElse(LinearRgb.BLACK));
        }).toList();
    }
}
