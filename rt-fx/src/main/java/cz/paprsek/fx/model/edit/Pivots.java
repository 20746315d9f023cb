package cz.paprsek.fx.model.edit;

import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Placement;
import cz.paprsek.xml.SceneFiles;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/** What bodies are turned and scaled about by hand. */
public final class Pivots {
    private Pivots() {}

    /** Where the pivot of a body is in the world. */
    public static Vec3 of(Scene scene, BodyAt at) {
        Body body = at.in(scene);
        return at.toWorld(scene).point(body.pivot().of(body.shape()));
    }

    /** The pivot of a body, in the world, if it has been put somewhere. */
    public static Optional<Vec3> given(Scene scene, BodyAt at) {
        return at.in(scene).pivot() instanceof Placement.Point ? Optional.of(of(scene, at)) : Optional.empty();
    }

    /** Puts the pivot of a body somewhere in the world; nothing else is moved. */
    public static Scene put(Scene scene, BodyAt at, Vec3 point) {
        Vec3 own = at.toWorld(scene).inverse().point(point);
        return scene.with(at, body -> body.turnedAbout(new Placement.Point(new Vec3(readable(own.x()), readable(own.y()), readable(own.z())))));
    }

    /** As exactly as hands are. */
    private static double readable(double value) {
        return Math.rint(value * 1e4) / 1e4 + 0.0;
    }

    /** Gives bodies a pivot of their own, where it is already, to be moved; or takes it away. */
    public static Scene given(Scene scene, Collection<BodyAt> bodies, boolean isOwn) {
        return scene.with(bodies, (at, body) -> body.turnedAbout(isOwn ? new Placement.Point(body.pivot().of(body.shape())) : Placement.MIDDLE));
    }

    /**
     * What becomes of a body when numbers of its placement are changed by hand: turned or scaled anew, it stays where its pivot is. Not where a formula
     * says its position.
     */
    public static Body kept(Scene scene, BodyAt at, Body old, Body fresh) {
        Placement before = old.placement();
        Placement after = fresh.placement();
        boolean isTurned = before.position().equals(after.position()) && !before.equals(after) && old.shape().equals(fresh.shape());
        Vec3 pivot = isTurned ? old.pivot().of(old.shape()) : Vec3.ZERO;
        if (pivot.equals(Vec3.ZERO) || isSaidByFormula(scene, at)) {
            return fresh;
        }
        Vec3 by = before.toParent().point(pivot).minus(after.toParent().point(pivot));
        return fresh.placed(after.withPosition(Moves.rounded(after.position().plus(by))));
    }

    private static boolean isSaidByFormula(Scene scene, BodyAt at) {
        return !scene.recipe().isNone() && SceneFiles.formulas(scene).getOrDefault(Optional.of(at), List.of()).stream()
                .anyMatch(one -> one.elements().isEmpty() && one.attribute().equals("position"));
    }
}
