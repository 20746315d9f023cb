package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PlacedLight;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.scene.ScenePath.MaterialAt;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import cz.paprsek.warning.SceneWarning;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;

/** What can be done about things in a scene that are hardly meant, with one click. */
public final class Mends {
    /** As far as the sun's disc is across, degrees. */
    private static final double SUN = 0.53;
    /** How far out of a body something is put, in parts of its size, and beside one without end, scene units. */
    private static final double AWAY = 0.1;
    private static final int SAMPLES = 4;

    /** Of each kind of warning what is done, and what that is called. */
    private static final Map<String, Mend> TABLE = Map.of(
            "camera-inside", new Mend("mend.camera-out", Mends::cameraOut),
            "light-inside", new Mend("mend.light-out", Mends::lightOut),
            "sun-without-disc", new Mend("mend.disc", Mends::disc),
            "lens-samples", new Mend("mend.samples", Mends::samples),
            "unused", new Mend("mend.remove", Mends::unused),
            "operand", new Mend("mend.remove", (state, warning) -> warning.place().map(place -> Structure.delete(state, Set.of(place)))),
            "energy", new Mend("mend.shares", (state, warning) -> material(state, warning, Mends::lessThanAll)),
            "milk", new Mend("mend.black", (state, warning) -> material(state, warning, material -> material.withPattern(new Pattern.Plain(Rgb.BLACK)))),
            "color", new Mend("mend.color", Mends::brighter),
            "dark", new Mend("mend.light", (state, warning) -> Optional.of(Adding.light(state, Adding.LIGHTS.get(0), "", Sight.of(state)))));

    private Mends() {}

    private record Mend(String key, BiFunction<EditorState, SceneWarning, Optional<EditorState>> change) {}

    /**
     * What can be done about a warning.
     *
     * @param key the key of what it is called
     * @param result the state then
     */
    public record Mended(String key, EditorState result) {}

    /** Empty if only the author knows, or if what would change is locked. */
    public static Optional<Mended> of(EditorState state, SceneWarning warning) {
        // Of a camera that is inside of something, the place is that of the thing.
        Optional<ScenePath> changed = warning.kind().equals("camera-inside") ? Optional.of(ScenePath.camera(state.eye())) : warning.place();
        boolean isLocked = changed.filter(place -> state.isLocked(place) || state.locked().stream().anyMatch(locked -> isWithin(locked, place))).isPresent();
        return isLocked ? Optional.empty() : Optional.ofNullable(TABLE.get(warning.kind())).flatMap(mend -> {
            try {
                return mend.change().apply(state, warning).filter(after -> !after.scene().equals(state.scene())).map(after -> new Mended(mend.key(), after));
            } catch (IllegalArgumentException cannotBe) {
                return Optional.empty();
            }
        });
    }

    private static boolean isWithin(ScenePath inner, ScenePath outer) {
        return inner instanceof BodyAt body && outer instanceof BodyAt around && around.holds(body);
    }

    /** The camera that is looked through goes back, or up, or aside, until it is out. */
    private static Optional<EditorState> cameraOut(EditorState state, SceneWarning warning) {
        Camera camera = state.camera();
        List<Vec3> ways = List.of(camera.forward().negated(), Vec3.Y, camera.right(), camera.right().negated(), camera.forward());
        return warning.place().flatMap(place -> out(state.scene(), place, camera.position(), ways))
                .map(point -> state.withScene(Cameras.changed(state.scene(), state.eye(), old -> old.withPosition(point))));
    }

    /** A lamp goes up until it is out of all that it is in, or aside. */
    private static Optional<EditorState> lightOut(EditorState state, SceneWarning warning) {
        Scene scene = state.scene();
        return light(state, warning, light -> light instanceof PlacedLight lamp
                ? ScenePath.bodies(scene).filter(at -> at.depth() == 0 && at.contains(scene, lamp.position()))
                        .flatMap(at -> out(scene, at, lamp.position(), List.of(Vec3.Y, Vec3.X, Vec3.Z)).stream()).findFirst().<Light>map(lamp::withPosition).orElse(light)
                : light);
    }

    private static Optional<Vec3> out(Scene scene, ScenePath place, Vec3 from, List<Vec3> ways) {
        if (place instanceof LightAt at && scene.lights().get(at.index()) instanceof SphereLight ball) {
            Vec3 away = from.minus(ball.position());
            Vec3 way = away.length() > 0 ? away.normalized() : ways.get(0);
            return Optional.of(rounded(ball.position().plus(way.times(ball.radius() * (1 + 2 * AWAY)))));
        }
        return place instanceof BodyAt at ? ways.stream().flatMap(way -> out(at.placed(scene), from, way).stream()).findFirst() : Optional.empty();
    }

    /** The first point along a way that is outside, and a little further. */
    private static Optional<Vec3> out(Surface body, Vec3 from, Vec3 way) {
        Spans spans = new Spans();
        Ray ray = new Ray(spans);
        ray.start(from.x(), from.y(), from.z(), way.x(), way.y(), way.z());
        body.crossings(ray, spans);
        Bounds box = body.bounds();
        double margin = AWAY * (box.isFinite() && !box.isEmpty() ? Math.max(box.maxX() - box.minX(), Math.max(box.maxY() - box.minY(), box.maxZ() - box.minZ())) : 1);
        for (int i = 0; i < spans.size(); i++) {
            Vec3 point = Double.isFinite(spans.t(i)) ? rounded(from.plus(way.times(spans.t(i) + margin))) : from;
            if (!body.contains(point)) {
                return Optional.of(point);
            }
        }
        return Optional.empty();
    }

    private static Vec3 rounded(Vec3 point) {
        return new Vec3(Math.rint(point.x() * 1e3) / 1e3 + 0.0, Math.rint(point.y() * 1e3) / 1e3 + 0.0, Math.rint(point.z() * 1e3) / 1e3 + 0.0);
    }

    private static Optional<EditorState> disc(EditorState state, SceneWarning warning) {
        return light(state, warning, light -> light instanceof SunLight sun ? sun.withDisc(SUN, sun.visible()) : light);
    }

    private static Optional<EditorState> light(EditorState state, SceneWarning warning, UnaryOperator<Light> change) {
        return warning.place().filter(LightAt.class::isInstance).map(LightAt.class::cast).map(at -> {
            List<Light> lights = new ArrayList<>(state.scene().lights());
            lights.set(at.index(), change.apply(lights.get(at.index())));
            return state.withScene(state.scene().withLights(lights));
        });
    }

    private static Optional<EditorState> samples(EditorState state, SceneWarning warning) {
        RenderSettings settings = state.scene().settings();
        return Optional.of(state.withScene(state.scene().withSettings(settings.withSamples(settings.isPath() ? RenderSettings.USUAL_PATHS : SAMPLES))));
    }

    private static Optional<EditorState> unused(EditorState state, SceneWarning warning) {
        return warning.place().filter(MaterialAt.class::isInstance).map(MaterialAt.class::cast).map(at -> state.withScene(Materials.delete(state.scene(), at.name())));
    }

    /** A named material, or that of a body. */
    private static Optional<EditorState> material(EditorState state, SceneWarning warning, UnaryOperator<Material> change) {
        Scene scene = state.scene();
        return warning.place().flatMap(place -> place instanceof MaterialAt at && scene.materials().containsKey(at.name())
                ? Optional.of(state.withScene(scene.plus(at.name(), change.apply(scene.materials().getOrDefault(at.name(), Material.DEFAULT)))))
                : place instanceof BodyAt at && at.in(scene).material() != Inherited.INHERITED
                ? Optional.of(state.withScene(scene.with(at, body -> body.material() instanceof Material own ? body.madeOf(change.apply(own)) : body))) : Optional.empty());
    }

    /** The shares in proportion, so that together they are all light. */
    private static Material lessThanAll(Material material) {
        boolean isGlass = material.fresnel() == Material.Fresnel.TRUE;
        double sum = material.diffusion() + (isGlass ? Math.max(material.reflection(), material.transparency()) : material.reflection() + material.transparency());
        if (sum <= 1 || !material.shares().isEven()) {
            return material;
        }
        return material.withDiffusion(down(material.diffusion() / sum)).withReflection(down(material.reflection() / sum))
                .withTransparency(down(material.transparency() / sum), material.refractiveIndex());
    }

    private static double down(double share) {
        return Math.floor(share * 1e3) / 1e3;
    }

    /** Colours as other formats have them, up to 1. */
    private static Optional<EditorState> brighter(EditorState state, SceneWarning warning) {
        return warning.place().filter(LightAt.class::isInstance).isPresent() ? Optional.empty()
                : material(state, warning, material -> material.pattern() instanceof Pattern.Plain plain ? material.withPattern(new Pattern.Plain(times255(plain.color()))) : material);
    }

    private static Rgb times255(Rgb color) {
        return new Rgb(Math.rint(color.red() * 255), Math.rint(color.green() * 255), Math.rint(color.blue() * 255));
    }
}
