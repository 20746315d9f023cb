package cz.paprsek.fx.model.property;

import static java.util.Map.entry;

import cz.paprsek.fx.model.property.Trait.Kind;
import cz.paprsek.fx.model.property.Trait.Preset;
import cz.paprsek.fx.model.property.Trait.Unit;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.Pattern.Checkerboard;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.Placement;
import java.lang.reflect.RecordComponent;
import java.util.Map;
import java.util.Optional;

/** The table of traits: of a few components by name, of all others by their type. */
final class Traits {
    private static final Map<Component, Trait> BY_NAME = Map.ofEntries(
            entry(of(Material.class, "diffusion"), Trait.share()),
            entry(of(Material.class, "specular"), Trait.share()),
            entry(of(Material.class, "shininess"), Trait.of(Kind.NUMBER).range(0, 1e6).stepping(5)),
            entry(of(Material.class, "reflection"), Trait.share()),
            entry(of(Material.class, "transparency"), Trait.share()),
            entry(of(Material.class, "refractiveIndex"), Trait.of(Kind.NUMBER).range(0.01, 100).stepping(0.01).with(
                    new Preset("preset.vacuum", 1), new Preset("preset.ice", 1.31), new Preset("preset.water", 1.33),
                    new Preset("preset.glass", 1.5), new Preset("preset.sapphire", 1.77), new Preset("preset.diamond", 2.42))),
            entry(of(Checkerboard.class, "columns"), Trait.of(Kind.WHOLE).range(1, Checkerboard.MOST).stepping(1)),
            entry(of(Checkerboard.class, "rows"), Trait.of(Kind.WHOLE).range(1, Checkerboard.MOST).stepping(1)),
            entry(of(Placement.class, "rotation"), Trait.of(Kind.VECTOR).in(Unit.DEGREES).stepping(5)),
            entry(of(Placement.class, "scale"), Trait.of(Kind.FACTORS)),
            entry(of(Camera.class, "fovy"), Trait.of(Kind.NUMBER).in(Unit.DEGREES).range(1, 179).stepping(1)),
            entry(of(Light.class, "intensity"), Trait.of(Kind.NUMBER).range(0, Light.BRIGHTEST).stepping(0.1)),
            entry(of(RenderSettings.class, "width"), pixels()),
            entry(of(RenderSettings.class, "height"), pixels()),
            entry(of(RenderSettings.class, "maxDepth"), Trait.of(Kind.WHOLE).range(1, RenderSettings.DEEPEST).stepping(1)),
            entry(of(RenderSettings.class, "samples"), Trait.of(Kind.WHOLE).range(1, 16).stepping(1)),
            entry(of(Scene.class, "tags"), Trait.of(Kind.WORDS)));

    private static final Map<Class<?>, Kind> BY_TYPE = Map.of(
            double.class, Kind.NUMBER,
            int.class, Kind.WHOLE,
            Vec3.class, Kind.VECTOR,
            Rgb.class, Kind.COLOR,
            String.class, Kind.TEXT,
            MaterialSource.class, Kind.MATERIAL);

    private record Component(Class<?> owner, String name) {}

    private Traits() {}

    /** How a component is shown; empty if it is no single value, but a record of values or a list. */
    static Optional<Trait> of(RecordComponent component) {
        Trait named = BY_NAME.get(of(component.getDeclaringRecord(), component.getName()));
        return named != null ? Optional.of(named) : byType(component.getType());
    }

    private static Optional<Trait> byType(Class<?> type) {
        return Optional.ofNullable(BY_TYPE.get(type))
                .or(() -> type.isEnum() ? Optional.of(Kind.CONSTANT) : Optional.empty())
                .or(() -> Alternatives.exist(type) ? Optional.of(Kind.ALTERNATIVE) : Optional.empty())
                .map(Trait::of);
    }

    private static Component of(Class<?> owner, String name) {
        return new Component(owner, name);
    }

    private static Trait pixels() {
        return Trait.of(Kind.WHOLE).in(Unit.PIXELS).range(1, RenderSettings.LARGEST_SIDE).stepping(10);
    }
}
