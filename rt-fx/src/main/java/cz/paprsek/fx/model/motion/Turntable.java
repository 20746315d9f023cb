package cz.paprsek.fx.model.motion;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.Cameras;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.fx.model.edit.Pivots;
import cz.paprsek.fx.model.edit.Sight;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Animation.Ease;
import cz.paprsek.scene.Animation.Turning;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Placement;
import cz.paprsek.text.Numbers;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/** Once around: bodies about the vertical through their pivots, or a camera about that of what it looks at. */
public final class Turntable {
    /** Of one turn; the next one would begin as this one did. */
    public static final int FRAMES = 100;
    /** Keys of a turn on a curve: nowhere farther from the circle than 1/50000 of its radius, nor from where it should be on that than 1/10000. */
    private static final int PIECES = 40;

    private Turntable() {}

    /** Turns bodies once around, counter-clockwise as seen from above. */
    public static Scene bodies(Scene scene, Collection<BodyAt> bodies) {
        Scene result = scene;
        for (BodyAt at : bodies) {
            result = body(result, at);
        }
        return result;
    }

    private static Scene body(Scene scene, BodyAt at) {
        Placement placement = at.in(scene).placement();
        Vec3 pivot = Pivots.of(scene, at);
        Vec3 place = at.parentToWorld(scene).point(placement.position());
        boolean isCentred = Math.hypot(place.x() - pivot.x(), place.z() - pivot.z()) < 1e-9 * (1 + place.length());
        boolean isUpright = at.depth() == 0 && placement.rotation().z() == 0;
        Scene turned = scene;
        if (isCentred && isUpright) {
            Vec3 turn = placement.rotation();
            turned = with(turned, at, "rotation", Turning.ANGLES, List.of(key(turned, 0, turn, Ease.LINEAR), key(turned, FRAMES, turn.plus(new Vec3(0, 360, 0)), Ease.LINEAR)));
        } else {
            IntFunction<Placement> placed = i -> at.in(Moves.rotated(scene, List.of(at), pivot, new Vec3(0, 360.0 * i / PIECES, 0))).placement();
            turned = with(turned, at, "rotation", Turning.SHORTEST, IntStream.rangeClosed(0, PIECES).mapToObj(i -> key(scene, (double) FRAMES * i / PIECES, placed.apply(i % PIECES).rotation(), Ease.LINEAR)).toList());
            turned = isCentred ? turned : with(turned, at, "position", Turning.ANGLES, curve(scene, i -> placed.apply(i).position()));
        }
        return turned;
    }

    /** Takes the camera that is looked through once around what it looks at, to its right. */
    public static EditorState camera(EditorState state) {
        Camera camera = state.camera();
        Vec3 pivot = camera.aim() instanceof Camera.Target target ? target.point() : ahead(state, camera);
        Scene aimed = Cameras.changed(state.scene(), state.eye(), old -> new Camera(old.name(), old.position(), new Camera.Target(pivot), old.up(), old.lens()));
        Vec3 up = camera.up().normalized();
        Vec3 arm = camera.position().minus(pivot);
        Vec3 axial = up.times(arm.dot(up));
        Vec3 radius = arm.minus(axial);
        Vec3 side = up.cross(radius);
        return state.withScene(with(aimed, ScenePath.camera(state.eye()), "position", Turning.ANGLES, curve(aimed, i -> {
            double angle = 2 * Math.PI * i / PIECES;
            return i % PIECES == 0 ? camera.position() : pivot.plus(axial).plus(radius.times(Math.cos(angle))).plus(side.times(Math.sin(angle)));
        })));
    }

    private static Vec3 ahead(EditorState state, Camera camera) {
        Vec3 middle = Sight.of(state).point();
        return camera.position().plus(camera.forward().times(Math.max(1e-3, middle.minus(camera.position()).dot(camera.forward()))));
    }

    /** With a key before the first and one behind the last, so that the curve is the same at both. */
    private static List<Animation.Key> curve(Scene scene, IntFunction<Vec3> place) {
        return IntStream.rangeClosed(-1, PIECES + 1).mapToObj(i -> key(scene, (double) FRAMES * i / PIECES, place.apply(Math.floorMod(i, PIECES)), Ease.CATMULL_ROM)).toList();
    }

    private static Animation.Key key(Scene scene, double frames, Vec3 value, Ease ease) {
        return new Animation.Key(rounded(frames / scene.settings().fps()), Numbers.text(new Vec3(rounded(value.x()), rounded(value.y()), rounded(value.z()))), ease);
    }

    private static double rounded(double value) {
        return Math.rint(value * 1e6) / 1e6 + 0.0;
    }

    /** With one animation in the place of the one that there may be of the same. */
    private static Scene with(Scene scene, ScenePath place, String attribute, Turning turning, List<Animation.Key> keys) {
        Animation fresh = new Animation(place.text(scene), attribute, turning, keys);
        List<Animation> all = new ArrayList<>(scene.animations());
        Keys.of(scene, place, attribute).ifPresentOrElse(i -> all.set(i, fresh), () -> all.add(fresh));
        return scene.withAnimations(all);
    }
}
