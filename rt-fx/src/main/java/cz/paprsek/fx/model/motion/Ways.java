package cz.paprsek.fx.model.motion;

import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PlacedLight;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.DoubleFunction;

/** The ways that animated bodies, cameras and lights go through the world: by their own animations and those of the operations they are in, not by formulas. */
public final class Ways {
    /** Points from key to key. */
    private static final int PIECES = 12;
    /** Points of a way with few keys, which may go along a curve. */
    private static final int LEAST = 128;
    /** Points of all keys of a way; more keys share them. */
    private static final int MOST = 600;

    private Ways() {}

    /**
     * A way.
     *
     * @param place what goes it
     * @param line from the first to the last key
     * @param keys where it is at its keys
     */
    public record Way(ScenePath place, List<Vec3> line, List<Vec3> keys) {
        public Way {
            line = List.copyOf(line);
            keys = List.copyOf(keys);
        }
    }

    /** All ways of a scene on which something gets anywhere. */
    public static List<Way> of(Scene scene) {
        Map<ScenePath, TreeSet<Double>> times = new LinkedHashMap<>();
        for (int i = 0; i < scene.animations().size(); i++) {
            Animation one = scene.animations().get(i);
            if (one.attribute().equals("position") && one.keys().size() > 1) {
                Keys.place(scene, i).ifPresent(at -> one.keys().forEach(key -> times.computeIfAbsent(at, none -> new TreeSet<>()).add(key.t())));
            }
        }
        if (times.isEmpty()) {
            return List.of();
        }
        DoubleFunction<Scene> moments = scene.moments();
        List<Way> ways = new ArrayList<>();
        times.forEach((place, at) -> ways.add(way(moments, place, List.copyOf(at))));
        return ways;
    }

    private static Way way(DoubleFunction<Scene> moments, ScenePath place, List<Double> times) {
        int pieces = Math.max(LEAST / times.size(), Math.max(1, Math.min(PIECES, MOST / times.size())));
        List<Vec3> line = new ArrayList<>();
        List<Vec3> keys = new ArrayList<>();
        for (int i = 0; i < times.size(); i++) {
            for (int j = 0; j < (i + 1 < times.size() ? pieces : 1); j++) {
                double t = i + 1 < times.size() ? times.get(i) + (times.get(i + 1) - times.get(i)) * j / pieces : times.get(i);
                Optional<Vec3> point = at(moments, place, t);
                point.ifPresent(line::add);
                if (j == 0) {
                    point.ifPresent(keys::add);
                }
            }
        }
        return new Way(place, line, keys);
    }

    private static Optional<Vec3> at(DoubleFunction<Scene> moments, ScenePath place, double t) {
        try {
            return at(moments.apply(t), place);
        } catch (IllegalArgumentException noScene) {
            return Optional.empty();
        }
    }

    /** Where in the world something stands in a scene; empty of what has no place. */
    public static Optional<Vec3> at(Scene scene, ScenePath place) {
        if (!place.isIn(scene)) {
            return Optional.empty();
        }
        if (place instanceof BodyAt at) {
            return Optional.of(at.parentToWorld(scene).point(at.in(scene).placement().position()));
        }
        if (place instanceof CameraAt at) {
            return Optional.of(scene.cameras().get(at.index()).position());
        }
        Light light = place instanceof LightAt at ? scene.lights().get(at.index()) : null;
        return light instanceof PlacedLight placed ? Optional.of(placed.position()) : Optional.empty();
    }
}
