package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.Places;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.shape.Placement;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;

/** Moves, turns and stretches items in world space. Of items within each other, the outer one is moved. */
public final class Moves {
    private Moves() {}

    /** Places moved by a vector in world space. A camera that keeps a target goes on looking at it. */
    public static Scene translated(Scene scene, Collection<? extends ScenePath> items, Vec3 by) {
        return by.equals(Vec3.ZERO) ? scene : changed(scene, items, position -> position.plus(by), light -> LightMoves.moved(light, position -> position.plus(by)), (toParent, placement) ->
                placement.withPosition(placement.position().plus(toParent.inverse().direction(by))));
    }

    /**
     * Places turned about a pivot.
     *
     * @param degrees about the world's x, y or z axis: two of the three are 0
     */
    public static Scene rotated(Scene scene, Collection<? extends ScenePath> items, Vec3 pivot, Vec3 degrees) {
        Affine turn = about(pivot, Affine.rotation(degrees));
        return changed(scene, items, turn::point, light -> LightMoves.turned(light, turn), (toParent, placement) -> {
            Affine local = toParent.inverse().after(turn).after(toParent);
            // The scale is left out of the sums, and so stays what it was to the last digit.
            Affine rotation = new Placement(Vec3.ZERO, placement.rotation(), Vec3.ONE).toParent();
            Affine turned = linear(local).after(rotation);
            return Placements.of(turned)
                    .map(fresh -> placement.withRotation(fresh.rotation()).withPosition(rounded(local.point(placement.position()))))
                    .orElse(placement);
        });
    }

    /** Places stretched from a pivot along the world's axes; those that stand askew are stretched alike in all directions, by the largest change. */
    public static Scene scaled(Scene scene, Collection<? extends ScenePath> items, Vec3 pivot, Vec3 factors) {
        Affine stretch = about(pivot, Affine.scaling(factors));
        double even = largestChange(factors);
        Affine evenly = about(pivot, Affine.scaling(new Vec3(even, even, even)));
        return changed(scene, items, stretch::point, light -> LightMoves.stretched(light, stretch, factors, even), (toParent, placement) -> {
            Affine own = toParent.after(placement.toParent());
            Affine map = own.keepsAxes() ? stretch : evenly;
            Vec3 along = own.keepsAxes() ? ownFactors(own, factors) : new Vec3(even, even, even);
            Vec3 position = toParent.inverse().after(map).after(toParent).point(placement.position());
            Vec3 scale = placement.scale();
            return new Placement(rounded(position), placement.rotation(),
                    rounded(new Vec3(scale.x() * along.x(), scale.y() * along.y(), scale.z() * along.z())));
        });
    }

    /** How a placement changes, knowing the map from the space it is in to the world. */
    @FunctionalInterface
    private interface Replacing {
        Placement apply(Affine parentToWorld, Placement placement);
    }

    private static Scene changed(Scene scene, Collection<? extends ScenePath> items, UnaryOperator<Vec3> point, UnaryOperator<Light> light,
            Replacing replacing) {
        Scene result = scene;
        Map<BodyAt, Affine> spaces = new HashMap<>();
        List<BodyAt> bodies = Places.outermost(items);
        bodies.stream().filter(at -> at.depth() > 0).forEach(at -> spaces.put(at, at.parentToWorld(scene)));
        result = result.with(bodies, (at, body) ->
                body.placed(replacing.apply(at.depth() == 0 ? Affine.IDENTITY : spaces.getOrDefault(at, Affine.IDENTITY), body.placement())));
        List<LightAt> lights = Places.lights(items);
        if (!lights.isEmpty()) {
            List<Light> moved = new ArrayList<>(scene.lights());
            lights.forEach(at -> moved.set(at.index(), light.apply(moved.get(at.index()))));
            result = result.withLights(moved);
        }
        List<CameraAt> cameras = Places.cameras(items);
        if (!cameras.isEmpty()) {
            List<Camera> moved = new ArrayList<>(scene.cameras());
            cameras.forEach(at -> moved.set(at.index(), moved.get(at.index()).withPosition(point.apply(moved.get(at.index()).position()))));
            result = result.withCameras(moved);
        }
        return result;
    }

    private static Affine about(Vec3 pivot, Affine map) {
        return Affine.translation(pivot).after(map).after(Affine.translation(pivot.negated()));
    }

    static Affine linear(Affine map) {
        return new Affine(map.xx(), map.xy(), map.xz(), 0, map.yx(), map.yy(), map.yz(), 0, map.zx(), map.zy(), map.zz(), 0);
    }

    /** Factors along the world's axes as factors along a body's own, for a body whose axes are the world's in some order. */
    static Vec3 ownFactors(Affine own, Vec3 factors) {
        return new Vec3(
                factorAlong(own.xx(), own.yx(), factors), factorAlong(own.xy(), own.yy(), factors), factorAlong(own.xz(), own.yz(), factors));
    }

    private static double factorAlong(double x, double y, Vec3 factors) {
        return x != 0 ? factors.x() : y != 0 ? factors.y() : factors.z();
    }

    private static double largestChange(Vec3 factors) {
        double even = factors.x();
        for (double factor : new double[] {factors.y(), factors.z()}) {
            even = Math.abs(factor - 1) > Math.abs(even - 1) ? factor : even;
        }
        return even;
    }

    static Vec3 rounded(Vec3 v) {
        return new Vec3(rounded(v.x()), rounded(v.y()), rounded(v.z()));
    }

    static double rounded(double value) {
        return value == 0 ? 0 : Placements.round(value, Math.abs(value));
    }
}
