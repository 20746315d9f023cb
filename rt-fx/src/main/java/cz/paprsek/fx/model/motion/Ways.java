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
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
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
    /** Points of all ways together, as long as each has some. */
    private static final int ALL = 4000;
    /** Points of a way among however many. */
    private static final int FEWEST = 8;

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
        // The scene of a time is made once, for all that are anywhere then, and not kept.
        Map<Double, List<ScenePath>> going = new TreeMap<>();
        int share = Math.max(FEWEST, ALL / times.size());
        times.forEach((place, at) -> line(List.copyOf(at), share).forEach(t -> going.computeIfAbsent(t, none -> new ArrayList<>()).add(place)));
        Map<ScenePath, TreeMap<Double, Vec3>> points = new HashMap<>();
        DoubleFunction<Scene> moments = scene.moments();
        going.forEach((t, places) -> moment(moments, t).ifPresent(moment ->
                places.forEach(place -> at(moment, place).ifPresent(point -> points.computeIfAbsent(place, none -> new TreeMap<>()).put(t, point)))));
        return times.entrySet().stream().map(one -> way(one.getKey(), points.getOrDefault(one.getKey(), new TreeMap<>()), one.getValue())).toList();
    }

    private static Way way(ScenePath place, SortedMap<Double, Vec3> points, Set<Double> keys) {
        return new Way(place, List.copyOf(points.values()), points.entrySet().stream().filter(point -> keys.contains(point.getKey())).map(Map.Entry::getValue).toList());
    }

    /** The times of the points of a way, those of its keys among them. */
    private static List<Double> line(List<Double> keys, int share) {
        int pieces = Math.max(Math.min(LEAST, share) / keys.size(), Math.max(1, Math.min(PIECES, Math.min(MOST, share) / keys.size())));
        List<Double> line = new ArrayList<>();
        for (int i = 0; i + 1 < keys.size(); i++) {
            line.add(keys.get(i));
            for (int j = 1; j < pieces; j++) {
                line.add(keys.get(i) + (keys.get(i + 1) - keys.get(i)) * j / pieces);
            }
        }
        line.add(keys.get(keys.size() - 1));
        return line;
    }

    private static Optional<Scene> moment(DoubleFunction<Scene> moments, double t) {
        try {
            return Optional.of(moments.apply(t));
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
