package cz.paprsek.lesson;

import cz.paprsek.query.Column;
import cz.paprsek.query.Table;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.Encounter.Refraction;
import cz.paprsek.render.explain.LightTerm;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.TracedRay.Kind;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.LightAt;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.IntSupplier;
import java.util.stream.Stream;

/** What is to be seen of one pixel of a small picture. */
final class SeenPixel {
    /** As rows of a table, which filters ask for; every column here is explained in docs/lessons.md. */
    static final Table<SeenPixel> TABLE = new Table<>("pixel", List.of(
            Column.number("x", pixel -> pixel.x),
            Column.number("y", pixel -> pixel.y),
            Column.number("red", pixel -> pixel.color.getAsInt() >> 16 & 255),
            Column.number("green", pixel -> pixel.color.getAsInt() >> 8 & 255),
            Column.number("blue", pixel -> pixel.color.getAsInt() & 255),
            Column.texts("object", pixel -> pixel.objects),
            Column.numbers("distance", pixel -> pixel.distance),
            Column.texts("lit-by", pixel -> pixel.lights),
            Column.texts("shadow-of", pixel -> pixel.shadows),
            Column.texts("mirrored", pixel -> List.copyOf(pixel.mirrored)),
            Column.texts("refracted", pixel -> List.copyOf(pixel.refracted)),
            Column.number("rays", pixel -> pixel.rays),
            Column.number("total-reflections", pixel -> pixel.totals)), List.of());

    private final double x;
    private final double y;
    private final IntSupplier color;
    private final List<String> objects;
    private final OptionalDouble distance;
    private final List<String> lights;
    private final List<String> shadows;
    private final Set<String> mirrored = new LinkedHashSet<>();
    private final Set<String> refracted = new LinkedHashSet<>();
    private int rays;
    private int totals;

    private SeenPixel(double x, double y, TracedRay ray, IntSupplier color) {
        this.x = x;
        this.y = y;
        this.color = color;
        objects = hit(ray);
        distance = ray.encounter().map(met -> OptionalDouble.of(met.place().distance())).orElse(OptionalDouble.empty());
        List<LightTerm> terms = ray.encounter().map(Encounter::lights).orElse(List.of());
        lights = terms.stream().filter(term -> term.visibility() > 0).map(LightTerm::name).toList();
        shadows = terms.stream().flatMap(term -> term.rays().stream()).flatMap(shadow -> shadow.obstacles().stream())
                .flatMap(obstacle -> names(obstacle.surface()).stream()).distinct().toList();
        count(ray);
    }

    /**
     * Of the ray through its middle.
     *
     * @param x of the middle, 0 at the left of the picture to 1 at its right
     * @param y likewise from the top down
     * @param color as {@link cz.paprsek.image.Image#argb}
     */
    static SeenPixel of(double x, double y, TracedRay ray, IntSupplier color) {
        return new SeenPixel(x, y, ray, color);
    }

    private void count(TracedRay ray) {
        rays++;
        totals += ray.encounter().flatMap(Encounter::refraction).filter(Refraction::isTotal).isPresent() ? 1 : 0;
        if (ray.kind() != Kind.PRIMARY) {
            (ray.kind() == Kind.REFLECTED ? mirrored : refracted).addAll(hit(ray));
        }
        ray.children().forEach(this::count);
    }

    private static List<String> hit(TracedRay ray) {
        return ray.encounter().map(met -> names(met.place().surface())).orElse(List.of());
    }

    /** The names of a body and of the operations around it, or of a light. */
    private static List<String> names(InScene<? extends ScenePath> surface) {
        Scene scene = surface.scene();
        Stream<String> names = surface.part() instanceof BodyAt body ? body.way().map(step -> step.in(scene).name())
                : Stream.of(scene.lights().get(((LightAt) surface.part()).index()).name());
        return names.filter(name -> !name.isEmpty()).toList();
    }
}
