package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.Copies;
import cz.paprsek.fx.model.edit.Cameras;
import cz.paprsek.fx.model.edit.LightMoves;
import cz.paprsek.fx.model.edit.Pivots;
import cz.paprsek.fx.model.edit.Rounds;
import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;

/** What the lights and cameras of a scene are grabbed by in a projection. */
final class Grips {
    /** Dots keep this far from what they would lie on otherwise, pixels. */
    private static final double APART = 18;
    /** What is so much shorter in the projection than in the world is seen from its end, and cannot be pulled there. */
    private static final double END_ON = 0.1;
    private static final double NARROWEST = 0.5;
    private static final double WIDEST_VIEW = 179.5;

    /** What a light or camera is grabbed by to change it, beside its own place. */
    sealed interface Grip {
        /** Whose it is. */
        ScenePath item();

        /** World space. */
        Vec3 place();

        /**
         * What something looks or shines at.
         *
         * @param turned the scene when it looks at another point
         */
        record Aim(ScenePath item, Vec3 place, BiFunction<Scene, Vec3, Scene> turned) implements Grip {}

        /**
         * A number to be pulled.
         *
         * @param text the key of what says it
         * @param value what it is now, degrees or scene units
         * @param isAngle whether it is one; else it is a length, and put on the grid
         * @param read about the number that a point stands for: what counts is how it changes, so that nothing jumps where a place is only near the true one
         * @param changed the scene with another number
         */
        record Dial(ScenePath item, Vec3 place, String text, double value, boolean isAngle, double least, double most, ToDoubleFunction<Vec3> read,
                BiFunction<Scene, Double, Scene> changed) implements Grip {

            /** The number at a point, a multiple of a step, within the limits; of a length, a step at least. */
            double at(Vec3 point, double step) {
                double pulled = value + read.applyAsDouble(point) - read.applyAsDouble(place);
                return Math.max(isAngle ? least : step, Math.min(most, Rounds.toGrid(pulled, step)));
            }
        }

        /**
         * How many copies there are.
         *
         * @param read by how many a movement changes that
         * @param changed the scene with another number of them
         */
        record Count(ScenePath item, Vec3 place, int value, ToDoubleFunction<Vec3> read, BiFunction<Scene, Integer, Scene> changed) implements Grip {
            private static final int MOST = 10_000;

            /** How many there are after a movement, two at least: of one nobody sees where the next would be. */
            int at(Vec3 movement) {
                return (int) Math.max(2, Math.min(MOST, value + Math.rint(read.applyAsDouble(movement))));
            }
        }
    }

    private final Scene scene;
    private final Axes axes;
    private final double apart;
    private final Copies copies;

    Grips(Scene scene, Axes axes, Viewport view, Copies copies) {
        this.copies = copies;
        this.scene = scene;
        this.axes = axes;
        this.apart = APART / view.scale();
    }

    List<Grip> of(ScenePath item) {
        return item instanceof LightAt at && at.isIn(scene) ? of(at, scene.lights().get(at.index()))
                : item instanceof CameraAt at && at.isIn(scene) ? of(at, scene.cameras().get(at.index()))
                : item instanceof BodyAt at && at.isIn(scene) ? of(at) : List.of();
    }

    /** By what it is repeated, and by its pivot if that has been put somewhere: in its middle it would lie on the body's own place. */
    private List<Grip> of(BodyAt at) {
        List<Grip> grips = new ArrayList<>(copies.isNone() ? List.of() : new RepeatGrips(scene, axes).of(at, copies));
        Pivots.given(scene, at).ifPresent(pivot -> grips.add(new Grip.Aim(at, pivot, (start, point) -> Pivots.put(start, at, point))));
        return grips;
    }

    private List<Grip> of(LightAt at, Light light) {
        List<Grip> grips = new ArrayList<>();
        LightSketch.of(light, axes).aim().ifPresent(aim -> grips.add(new Grip.Aim(at, aim, (start, point) -> changed(start, at, old -> LightMoves.shiningAt(old, point)))));
        if (light instanceof SpotLight spot) {
            Vec3 from = spot.position();
            Vec3 aim = LightSketch.aim(spot);
            double full = spot.fullAngle();
            double outer = spot.outerAngle();
            grips.add(rim(at, "figure.outer-angle", from, aim, 1, outer, 1, NARROWEST, 90, (old, wide) -> LightMoves.widened((SpotLight) old, wide)));
            grips.add(rim(at, "figure.inner-angle", from, aim, -1, full, 1, 0, outer, (old, wide) -> ((SpotLight) old).withAngles(wide, outer)));
        } else if (light instanceof SunLight sun) {
            grips.add(rim(at, "figure.disc", Vec3.ZERO, LightMoves.place(sun), 1, sun.angle() / 2, 2, 0, 180, (old, wide) -> ((SunLight) old).withDisc(wide, sun.visible())));
        }
        return grips;
    }

    private interface Widening {
        Light with(Light old, double degrees);
    }

    /**
     * A dot on the rim of a cone.
     *
     * @param sign on which side of its middle: 1 or −1
     * @param half from the middle to the rim, degrees
     * @param parts of such angles there are in the one that is told: 1 or 2
     */
    private Grip rim(LightAt at, String text, Vec3 from, Vec3 middle, int sign, double half, int parts, double least, double most, Widening widening) {
        Vec3 axis = middle.minus(from);
        Vec3 side = LightSketch.side(axis, axes).times(sign);
        Vec3 place = middle.plus(side.times(Math.max(apart, LightSketch.width(axis, half))));
        ToDoubleFunction<Vec3> read = point -> parts * degrees(point.minus(from), side, axis.normalized());
        return new Grip.Dial(at, place, text, parts * half, true, least, most, read, (start, wide) -> changed(start, at, old -> widening.with(old, wide)));
    }

    private List<Grip> of(CameraAt at, Camera camera) {
        List<Grip> grips = new ArrayList<>();
        CameraSketch sketch = CameraSketch.of(scene, at.index());
        grips.add(new Grip.Aim(at, sketch.aim(), (start, point) -> Cameras.changed(start, at.index(), old -> Cameras.lookingAt(old, point))));
        double distance = sketch.aim().minus(camera.position()).length();
        double aspect = (double) scene.settings().width() / scene.settings().height();
        boolean isTall = length(camera.trueUp()) >= length(camera.right());
        Vec3 across = isTall ? camera.trueUp() : camera.right();
        double ratio = isTall ? 1 : aspect;
        double half = ratio * camera.lens().heightAt(distance) / 2;
        Vec3 edge = sketch.aim().plus(across.times(Math.max(half, apart)));
        ToDoubleFunction<Vec3> height = point -> 2 * Math.max(0, half + along(point.minus(edge), across)) / ratio;
        if (camera.lens() instanceof Lens.Perspective lens) {
            grips.add(dial(at, edge, "figure.fovy", lens.fovy(), true, NARROWEST, WIDEST_VIEW, point -> 2 * Math.toDegrees(Math.atan(height.applyAsDouble(point) / 2 / distance)),
                    (old, degrees) -> ((Lens.Perspective) old).withFovy(degrees)));
            Vec3 way = camera.forward().minus(across.times(Math.max(half / distance, apart / camera.focus())));
            if (lens.aperture() > 0 && length(way) > END_ON) {
                grips.add(dial(at, camera.position().plus(way.times(camera.focus())), "figure.focus", camera.focus(), false, 0, Double.MAX_VALUE,
                        point -> along(point.minus(camera.position()), way), (old, focus) -> ((Lens.Perspective) old).withFocus(focus)));
            }
        } else if (camera.lens() instanceof Lens.Orthographic lens) {
            grips.add(dial(at, edge, "figure.height", lens.height(), false, 0, Double.MAX_VALUE, height, (old, high) -> new Lens.Orthographic(high)));
        } else if (camera.lens() instanceof Lens.Fisheye lens && length(camera.forward()) > END_ON) {
            Vec3 rim = camera.forward().times(Angles.cos(lens.angle() / 2)).plus(across.times(Angles.sin(lens.angle() / 2)));
            grips.add(dial(at, camera.position().plus(rim.times(distance)), "figure.angle", lens.angle(), true, NARROWEST, 360,
                    point -> 2 * degrees(point.minus(camera.position()), across, camera.forward()), (old, degrees) -> new Lens.Fisheye(degrees)));
        }
        return grips;
    }

    private interface Bending {
        Lens with(Lens old, double value);
    }

    private static Grip dial(CameraAt at, Vec3 place, String text, double value, boolean isAngle, double least, double most, ToDoubleFunction<Vec3> read, Bending bending) {
        return new Grip.Dial(at, place, text, value, isAngle, least, most, read,
                (start, number) -> Cameras.changed(start, at.index(), old -> old.withLens(bending.with(old.lens(), number))));
    }

    private static Scene changed(Scene start, LightAt at, UnaryOperator<Light> change) {
        List<Light> lights = new ArrayList<>(start.lights());
        lights.set(at.index(), change.apply(lights.get(at.index())));
        return start.withLights(lights);
    }

    /** From an axis to a point, on one side of it; both of length 1. */
    private static double degrees(Vec3 point, Vec3 side, Vec3 axis) {
        return Math.toDegrees(Math.atan2(Math.max(0, point.dot(side)), point.dot(axis)));
    }

    /** How far along a way one goes that follows a movement in the projection, in lengths of the way. */
    private double along(Vec3 movement, Vec3 way) {
        return (axes.u(movement) * axes.u(way) + axes.v(movement) * axes.v(way)) / (length(way) * length(way));
    }

    /** As it is seen in the projection. */
    private double length(Vec3 v) {
        return Math.hypot(axes.u(v), axes.v(v));
    }
}
