package cz.paprsek.fx.model.property;

import static cz.paprsek.attribute.Kind.CONE_ANGLE;
import static cz.paprsek.attribute.Kind.CONFIDENCE;
import static cz.paprsek.attribute.Kind.DEPTH;
import static cz.paprsek.attribute.Kind.DISC_ANGLE;
import static cz.paprsek.attribute.Kind.EXPONENT;
import static cz.paprsek.attribute.Kind.FILE;
import static cz.paprsek.attribute.Kind.FISHEYE;
import static cz.paprsek.attribute.Kind.FONT;
import static cz.paprsek.attribute.Kind.FOVY;
import static cz.paprsek.attribute.Kind.INTENSITY;
import static cz.paprsek.attribute.Kind.LIGHT_SAMPLES;
import static cz.paprsek.attribute.Kind.MOST_SAMPLES;
import static cz.paprsek.attribute.Kind.OCTAVES;
import static cz.paprsek.attribute.Kind.PIXELS;
import static cz.paprsek.attribute.Kind.POSITIVE_SCALE;
import static cz.paprsek.attribute.Kind.REFRACTIVE_INDEX;
import static cz.paprsek.attribute.Kind.ROTATION;
import static cz.paprsek.attribute.Kind.SAMPLES;
import static cz.paprsek.attribute.Kind.SCALE;
import static cz.paprsek.attribute.Kind.SEED;
import static cz.paprsek.attribute.Kind.SHARE;
import static cz.paprsek.attribute.Kind.SQUARES;
import static cz.paprsek.attribute.Kind.STOPS;
import static java.util.Map.entry;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.fx.model.property.Trait.Kind;
import cz.paprsek.fx.model.property.Trait.Preset;
import cz.paprsek.fx.model.property.Trait.Unit;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import java.lang.reflect.RecordComponent;
import java.util.Map;
import java.util.Optional;

/** The table of traits: of attributes by their kind, of all other components by their type. */
final class Traits {
    private static final Map<cz.paprsek.attribute.Kind, Trait> BY_KIND = Map.ofEntries(
            entry(SHARE, Trait.share()),
            entry(EXPONENT, Trait.of(Kind.NUMBER).range(0, EXPONENT.most()).stepping(5)),
            entry(REFRACTIVE_INDEX, Trait.of(Kind.NUMBER).range(0.01, REFRACTIVE_INDEX.most()).stepping(0.01).with(
                    new Preset("preset.vacuum", 1), new Preset("preset.ice", 1.31), new Preset("preset.water", 1.33),
                    new Preset("preset.glass", 1.5), new Preset("preset.sapphire", 1.77), new Preset("preset.diamond", 2.42))),
            entry(SQUARES, whole(SQUARES)),
            entry(OCTAVES, whole(OCTAVES)),
            entry(SEED, whole(SEED)),
            entry(FILE, Trait.of(Kind.FILE)),
            entry(FONT, Trait.of(Kind.FONT)),
            entry(STOPS, Trait.of(Kind.NUMBER).range(-STOPS.most(), STOPS.most()).stepping(0.5)),
            entry(POSITIVE_SCALE, Trait.of(Kind.FACTORS)),
            entry(ROTATION, Trait.of(Kind.VECTOR).in(Unit.DEGREES).stepping(5)),
            entry(SCALE, Trait.of(Kind.FACTORS)),
            entry(FOVY, Trait.of(Kind.NUMBER).in(Unit.DEGREES).range(1, 179).stepping(1)),
            entry(CONE_ANGLE, Trait.of(Kind.NUMBER).in(Unit.DEGREES).range(0, CONE_ANGLE.most()).stepping(1)),
            entry(DISC_ANGLE, Trait.of(Kind.NUMBER).in(Unit.DEGREES).range(0, DISC_ANGLE.most()).stepping(0.5)),
            entry(LIGHT_SAMPLES, whole(LIGHT_SAMPLES)),
            entry(FISHEYE, Trait.of(Kind.NUMBER).in(Unit.DEGREES).range(1, 360).stepping(5)),
            entry(INTENSITY, Trait.of(Kind.NUMBER).range(0, INTENSITY.most()).stepping(0.1)),
            entry(PIXELS, whole(PIXELS).in(Unit.PIXELS).stepping(10)),
            entry(DEPTH, whole(DEPTH)),
            entry(SAMPLES, whole(SAMPLES)),
            entry(MOST_SAMPLES, whole(MOST_SAMPLES)),
            entry(CONFIDENCE, Trait.of(Kind.NUMBER).range(0.5, 0.999).stepping(0.01)));

    private static final Map<Class<?>, Kind> BY_TYPE = Map.of(
            double.class, Kind.NUMBER,
            int.class, Kind.WHOLE,
            boolean.class, Kind.FLAG,
            Vec3.class, Kind.VECTOR,
            Rgb.class, Kind.COLOR,
            String.class, Kind.TEXT,
            MaterialSource.class, Kind.MATERIAL);

    private Traits() {}

    /** How a component is shown; empty if it is no single value, but a record of values or a list. */
    static Optional<Trait> of(RecordComponent component) {
        if (component.getDeclaringRecord() == Scene.class && component.getName().equals("tags")) {
            return Optional.of(Trait.of(Kind.WORDS));
        }
        if (component.getDeclaringRecord() == Pattern.Stops.class) {
            return Optional.of(Trait.of(Kind.STOPS));
        }
        return Optional.ofNullable(component.getAnnotation(Attribute.class)).map(says -> BY_KIND.get(says.value())).or(() -> byType(component.getType()));
    }

    private static Optional<Trait> byType(Class<?> type) {
        return Optional.ofNullable(BY_TYPE.get(type))
                .or(() -> type.isEnum() ? Optional.of(Kind.CONSTANT) : Optional.empty())
                .or(() -> Alternatives.exist(type) ? Optional.of(Kind.ALTERNATIVE) : Optional.empty())
                .map(Trait::of);
    }

    private static Trait whole(cz.paprsek.attribute.Kind kind) {
        return Trait.of(Kind.WHOLE).range(kind.least(), kind.most()).stepping(1);
    }
}
