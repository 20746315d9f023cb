package cz.paprsek.fx.view.projection;

import cz.paprsek.formula.Maker;
import cz.paprsek.fx.model.Copies;
import cz.paprsek.fx.view.projection.Grips.Grip;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.text.Numbers;
import cz.paprsek.xml.SceneFiles;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What a repeat is grabbed by: how far its copies are from each other, or by how much they are turned, and how many they are. */
final class RepeatGrips {
    private static final double DIGITS = 1e6;
    private static final double NARROWEST = 0.5;

    private final Scene scene;
    private final Axes axes;

    RepeatGrips(Scene scene, Axes axes) {
        this.scene = scene;
        this.axes = axes;
    }

    List<Grip> of(BodyAt item, Copies copies) {
        Optional<Maker> found = copies.repeat(item).filter(maker -> maker.copies().size() > maker.originals().size());
        if (found.isEmpty()) {
            return List.of();
        }
        Maker maker = found.get();
        BodyAt first = new BodyAt(maker.originals().get(0));
        BodyAt second = new BodyAt(maker.copies().get(maker.originals().size()));
        Affine toWorld = first.parentToWorld(scene);
        Body from = first.in(scene);
        Body to = second.in(scene);
        return maker.attribute("rotation").isEmpty() && maker.attribute("scale").isEmpty()
                ? inARow(item, maker, toWorld, middle(from), to.placement().position().minus(from.placement().position()))
                : maker.attribute("position").isEmpty() && maker.attribute("scale").isEmpty()
                ? around(item, maker, toWorld, middle(from), to.placement().rotation().minus(from.placement().rotation())) : List.of();
    }

    private List<Grip> inARow(BodyAt item, Maker maker, Affine toWorld, Vec3 from, Vec3 step) {
        Vec3 way = toWorld.direction(step);
        List<Grip> grips = new ArrayList<>();
        grips.add(new Grip.Aim(item, toWorld.point(from.plus(step)), (start, point) ->
                SceneFiles.withMaker(start, maker.number(), "position", text(maker, step, toWorld.inverse().point(point).minus(from)))));
        double seen = axes.u(way) * axes.u(way) + axes.v(way) * axes.v(way);
        if (seen > 0) {
            // Beyond the last copy, where none would be hidden by it.
            Vec3 place = toWorld.point(from.plus(step.times(maker.count() - 0.5)));
            grips.add(new Grip.Count(item, place, maker.count(), movement -> (axes.u(movement) * axes.u(way) + axes.v(movement) * axes.v(way)) / seen,
                    (start, count) -> SceneFiles.withMaker(start, maker.number(), "count", Integer.toString(count))));
        }
        return grips;
    }

    /** The numbers that have stayed as they are written, with their formulas. */
    private static String text(Maker maker, Vec3 old, Vec3 now) {
        String[] written = maker.attribute("position").strip().split("\\s+(?![^{]*})", -1);
        double[] before = {old.x(), old.y(), old.z()};
        double[] after = {now.x(), now.y(), now.z()};
        List<String> all = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            boolean isSame = Math.abs(before[i] - after[i]) < 1 / DIGITS && written.length == 3;
            all.add(isSame ? written[i] : Numbers.text(Math.rint(after[i] * DIGITS) / DIGITS + 0.0));
        }
        return String.join(" ", all);
    }

    private List<Grip> around(BodyAt item, Maker maker, Affine toWorld, Vec3 from, Vec3 turn) {
        Vec3 axis = turn.y() != 0 && turn.x() == 0 && turn.z() == 0 ? Vec3.Y : turn.z() != 0 && turn.x() == 0 && turn.y() == 0 ? Vec3.Z
                : turn.x() != 0 && turn.y() == 0 && turn.z() == 0 ? Vec3.X : Vec3.ZERO;
        double degrees = turn.dot(axis);
        Vec3 center = toWorld.point(Vec3.ZERO);
        Vec3 start = toWorld.direction(from.minus(axis.times(from.dot(axis))));
        // Seen from its side a ring is a line, along which nothing turns.
        boolean isSeen = !axis.equals(Vec3.ZERO) && degrees > 0 && start.length() > 1e-9 && Math.abs(axes.u(toWorld.direction(axis))) + Math.abs(axes.v(toWorld.direction(axis))) < 1e-6;
        if (!isSeen) {
            return List.of();
        }
        Vec3 side = toWorld.direction(axis).normalized().cross(start);
        Vec3 place = toWorld.point(Affine.rotation(axis.times(degrees)).point(from));
        return List.of(new Grip.Dial(item, place, "figure.angle", degrees, true, NARROWEST, 359.5, point -> {
            Vec3 arm = point.minus(center);
            double angle = Math.toDegrees(Math.atan2(arm.dot(side), arm.dot(start)));
            return angle < 0 ? angle + 360 : angle;
        }, (now, angle) -> SceneFiles.withMaker(now, maker.number(), "rotation", Numbers.text(axis.times(angle)))));
    }

    /** Of a body, in the space that it is placed in; of one without end its own place. */
    private static Vec3 middle(Body body) {
        Bounds box = body.shape().bounds().transformed(body.placement().toParent());
        return box.isEmpty() || !box.isFinite() ? body.placement().position()
                : new Vec3((box.minX() + box.maxX()) / 2, (box.minY() + box.maxY()) / 2, (box.minZ() + box.maxZ()) / 2);
    }
}
