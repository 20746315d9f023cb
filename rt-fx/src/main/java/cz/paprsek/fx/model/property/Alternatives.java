package cz.paprsek.fx.model.property;

import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Bump;
import cz.paprsek.material.Material.Flat;
import cz.paprsek.material.Material.NormalMap;
import cz.paprsek.material.Material.Relief;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Pattern.Checker;
import cz.paprsek.material.Pattern.Checkerboard;
import cz.paprsek.material.Pattern.Lay;
import cz.paprsek.material.Pattern.Plain;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share;
import cz.paprsek.material.Share.ByPattern;
import cz.paprsek.material.Share.Even;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Camera.Aim;
import cz.paprsek.scene.Camera.Direction;
import cz.paprsek.scene.Camera.Target;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Placement.Pivot;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;

/** How a value of one kind becomes one of another kind that looks as much like it as can be. */
public final class Alternatives {
    private static final double AIM_DISTANCE = 5;
    private static final Rgb CONTRAST = new Rgb(40, 40, 40);

    /** A row of the table: the kind that comes out, and how it does, knowing the record that has the value. */
    private record Alternative(Class<?> kind, BiFunction<Record, Object, Object> convert) {}

    private static final Map<Class<?>, List<Alternative>> TABLE = Map.of(
            Pattern.class, List.of(
                    new Alternative(Plain.class, (owner, old) -> new Plain(color(old))),
                    new Alternative(Checkerboard.class, (owner, old) -> new Checkerboard(8, 8, color(old), contrast(old))),
                    new Alternative(Checker.class, (owner, old) -> new Checker(0.25, Vec3.ZERO, color(old), contrast(old))),
                    new Alternative(Pattern.Gradient.class, (owner, old) -> new Pattern.Gradient(colors(old), Lay.NONE)),
                    new Alternative(Pattern.Stripes.class, (owner, old) -> new Pattern.Stripes(0.25, color(old), contrast(old), Lay.NONE)),
                    new Alternative(Pattern.Brick.class, (owner, old) -> new Pattern.Brick(new Vec3(0.5, 0.25, 0.25), 0.03, color(old), contrast(old), Lay.NONE)),
                    new Alternative(Pattern.Marble.class, (owner, old) -> new Pattern.Marble(1, 1, 4, 0, colors(old), Lay.NONE)),
                    new Alternative(Pattern.Wood.class, (owner, old) -> new Pattern.Wood(8, 0.4, 2, 0, colors(old), Lay.NONE)),
                    new Alternative(Pattern.Granite.class, (owner, old) -> new Pattern.Granite(6, 0, colors(old), Lay.scaled(0.25))),
                    new Alternative(Pattern.Noise.class, (owner, old) -> new Pattern.Noise(4, 0, colors(old), Lay.scaled(0.5))),
                    new Alternative(Pattern.Picture.class, (owner, old) -> Pattern.Picture.of("picture.png"))),
            Sky.class, List.of(
                    new Alternative(Sky.None.class, (owner, old) -> Sky.NONE),
                    new Alternative(Sky.Gradient.class, (owner, old) -> Sky.Gradient.DEFAULT),
                    new Alternative(Sky.Picture.class, (owner, old) -> new Sky.Picture("sky.hdr", 0, 1))),
            Share.class, List.of(
                    new Alternative(Even.class, (owner, old) -> new Even()),
                    new Alternative(ByPattern.class, (owner, old) -> new ByPattern(new Checker(0.25, Vec3.ZERO, Rgb.WHITE, Rgb.BLACK)))),
            Relief.class, List.of(
                    new Alternative(Flat.class, (owner, old) -> Relief.FLAT),
                    new Alternative(Bump.class, (owner, old) -> new Bump(0.02, height(((Material) owner).pattern()))),
                    new Alternative(NormalMap.class, (owner, old) -> NormalMap.of("normals.png"))),
            Pattern.Colors.class, List.of(
                    new Alternative(Pattern.TwoColors.class, (owner, old) -> new Pattern.TwoColors(color(owner), contrast(owner))),
                    new Alternative(Pattern.Stops.class, (owner, old) -> new Pattern.Stops(((Pattern.Colors) old).stops()))),
            Aim.class, List.of(
                    new Alternative(Direction.class, (owner, old) -> new Direction(forward(owner))),
                    new Alternative(Target.class, (owner, old) -> new Target(inFront(owner)))),
            AreaLight.Form.class, List.of(
                    new Alternative(AreaLight.Size.class, (owner, old) -> new AreaLight.Size(2 * radius(old), 2 * radius(old))),
                    new Alternative(AreaLight.Radius.class, (owner, old) -> new AreaLight.Radius(radius(old)))),
            Pivot.class, List.of(
                    new Alternative(Placement.Middle.class, (owner, old) -> Placement.MIDDLE),
                    new Alternative(Placement.Point.class, (owner, old) -> new Placement.Point(((Pivot) old).of(((Body) owner).shape())))),
            Lens.class, List.of(
                    new Alternative(Lens.Perspective.class, (owner, old) -> Lens.Perspective.DEFAULT.withFovy(fovy((Camera) owner))),
                    new Alternative(Lens.Orthographic.class, (owner, old) -> new Lens.Orthographic(height((Camera) owner))),
                    new Alternative(Lens.Spherical.class, (owner, old) -> new Lens.Spherical()),
                    new Alternative(Lens.Fisheye.class, (owner, old) -> Lens.Fisheye.DEFAULT)));

    private Alternatives() {}

    /** Whether the values of a type are of kinds that one chooses from. */
    static boolean exist(Class<?> type) {
        return TABLE.containsKey(type);
    }

    /** The kinds to choose from. */
    public static List<Class<?>> of(Class<?> type) {
        return rows(type).stream().<Class<?>>map(Alternative::kind).toList();
    }

    /** The scene with a property's values made of another kind. */
    public static Scene choose(Property property, Scene scene, Class<?> kind) {
        Alternative row = rows(property.type()).stream().filter(r -> r.kind() == kind).findFirst().orElseThrow();
        return property.changeKnowing(scene, (owner, old) -> kind.isInstance(old) ? old : row.convert().apply(owner, old));
    }

    private static List<Alternative> rows(Class<?> type) {
        return TABLE.getOrDefault(type, List.of());
    }

    private static Rgb color(Object pattern) {
        List<Rgb> palette = ((Pattern) pattern).palette();
        return palette.isEmpty() ? Rgb.WHITE : palette.get(0);
    }

    private static Rgb contrast(Object pattern) {
        List<Rgb> palette = ((Pattern) pattern).palette();
        return pattern instanceof Plain ? CONTRAST : palette.isEmpty() ? Rgb.BLACK : palette.get(palette.size() - 1);
    }

    /** Bumps where a pattern has its colours: bricks are higher than mortar. */
    private static Pattern height(Pattern pattern) {
        return pattern instanceof Pattern.Brick brick ? new Pattern.Brick(brick.size(), brick.mortar(), Rgb.WHITE, Rgb.BLACK, brick.lay())
                : pattern instanceof Plain ? new Pattern.Noise(4, 0, Pattern.Colors.DEFAULT, Lay.scaled(0.25)) : pattern;
    }

    /** The stops there are, or the two colours. */
    private static Pattern.Colors colors(Object pattern) {
        return pattern instanceof Pattern had && had.colors() instanceof Pattern.Stops stops ? stops : new Pattern.TwoColors(color(pattern), contrast(pattern));
    }

    private static Vec3 forward(Record owner) {
        return owner instanceof SpotLight spot ? spot.direction() : ((Camera) owner).forward();
    }

    private static Vec3 inFront(Record owner) {
        Vec3 position = owner instanceof SpotLight spot ? spot.position() : ((Camera) owner).position();
        return position.plus(forward(owner).times(AIM_DISTANCE));
    }

    private static double radius(Object form) {
        return form instanceof AreaLight.Size size ? Math.min(size.width(), size.height()) / 2 : ((AreaLight.Radius) form).radius();
    }

    /** What shows as much of what is looked at, in whole degrees. */
    private static double fovy(Camera camera) {
        return camera.lens() instanceof Lens.Orthographic lens
                ? Math.max(1, Math.rint(Math.toDegrees(2 * Math.atan(lens.height() / 2 / distance(camera))))) : Lens.Perspective.DEFAULT.fovy();
    }

    private static double height(Camera camera) {
        double height = new Lens.Perspective(camera.lens() instanceof Lens.Perspective lens ? lens.fovy() : 45, 0, 0).heightAt(distance(camera));
        return new BigDecimal(height).round(new MathContext(3)).doubleValue();
    }

    private static double distance(Camera camera) {
        return camera.aim() instanceof Target target ? target.point().minus(camera.position()).length() : AIM_DISTANCE;
    }
}
