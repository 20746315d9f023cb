package cz.paprsek.lesson;

import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.Encounter;
import cz.paprsek.render.explain.Encounter.Place;
import cz.paprsek.render.explain.Encounter.Refraction;
import cz.paprsek.render.explain.LightTerm.ShadowRay;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.TracedRay;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/** What a question may ask of a pixel: figures of its explanation. */
@SuppressWarnings("ImmutableEnumChecker") // The functions keep nothing.
public enum Figure {
    /** Red, green and blue as the picture shows them, 0–255. */
    COLOR(3),
    /** Red, green and blue of the pixel's light, linear. */
    LIGHT(3),
    /** The pixel's light by what eyes find bright, linear; of grey its one number. */
    BRIGHTNESS(1),
    /** d, of length 1. */
    DIRECTION(3, ray -> Optional.of(numbers(ray.direction()))),
    /** t, scene units. */
    DISTANCE(1, ray -> place(ray).map(place -> List.of(place.distance()))),
    /** P, world space. */
    POINT(3, ray -> place(ray).map(place -> numbers(place.point()))),
    /** N, of length 1, on the side the ray comes from. */
    NORMAL(3, ray -> place(ray).map(place -> numbers(place.towardsViewer()))),
    /** θ₁ between the ray and the normal, degrees. */
    ANGLE(1, ray -> place(ray).map(place -> List.of(place.angleDegrees()))),
    /** θ₂ of the ray that goes on beyond a transparent surface, degrees. */
    ANGLE_BEYOND(1, ray -> refraction(ray).filter(bent -> !bent.isTotal()).map(bent -> List.of(bent.angleBeyondDegrees()))),
    /** N·L. */
    FACING(ShadowRay::facing),
    /** R·L. */
    ALIGNMENT(ShadowRay::alignment),
    /** V, the share of the light that arrives. */
    VISIBILITY(ShadowRay::visibility);

    private final int numbers;
    private final Function<TracedRay, Optional<List<Double>>> ofRay;
    private final Optional<Function<ShadowRay, Double>> ofLight;

    Figure(int numbers) {
        this(numbers, ray -> Optional.empty(), Optional.empty());
    }

    Figure(int numbers, Function<TracedRay, Optional<List<Double>>> ofRay) {
        this(numbers, ofRay, Optional.empty());
    }

    Figure(Function<ShadowRay, Double> ofLight) {
        this(1, ray -> Optional.empty(), Optional.of(ofLight));
    }

    Figure(int numbers, Function<TracedRay, Optional<List<Double>>> ofRay, Optional<Function<ShadowRay, Double>> ofLight) {
        this.numbers = numbers;
        this.ofRay = ofRay;
        this.ofLight = ofLight;
    }

    /** Its name in files: {@code angle-beyond}. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The figure of that name in files. */
    static Optional<Figure> of(String name) {
        return Stream.of(values()).filter(one -> one.toString().equals(name)).findFirst();
    }

    /** How many numbers it is. */
    public int numbers() {
        return numbers;
    }

    /** Whether it is of the light of the whole pixel, whatever its rays. */
    boolean isOfPixel() {
        return this == COLOR || this == LIGHT || this == BRIGHTNESS;
    }

    /** Of a pixel's light, as it is and as it is shown. */
    List<Double> of(LinearRgb light, LinearRgb developed) {
        return switch (this) {
            case COLOR -> List.of(developed.shown().red(), developed.shown().green(), developed.shown().blue());
            case LIGHT -> List.of(light.red(), light.green(), light.blue());
            default -> List.of(0.2126 * light.red() + 0.7152 * light.green() + 0.0722 * light.blue());
        };
    }

    /**
     * Of a ray; empty if it has none.
     *
     * @param light number of a light, from 0
     */
    Optional<List<Double>> of(TracedRay ray, int light) {
        if (ofLight.isEmpty()) {
            return ofRay.apply(ray);
        }
        return ray.encounter().flatMap(met -> met.lights().stream().filter(term -> term.light() == light).findFirst()).map(term -> List.of(ofLight.get().apply(term.ray())));
    }

    private static Optional<Place> place(TracedRay ray) {
        return ray.encounter().map(Encounter::place);
    }

    private static Optional<Refraction> refraction(TracedRay ray) {
        return ray.encounter().flatMap(Encounter::refraction);
    }

    private static List<Double> numbers(Vec3 v) {
        return List.of(v.x(), v.y(), v.z());
    }
}
