package cz.paprsek.scene;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Material;
import cz.paprsek.math.Require;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.scene.ScenePath.MaterialAt;
import cz.paprsek.scene.motion.RecordValues;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.outline.Way;
import cz.paprsek.text.Similar;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;

/** Scenes at a time: what is animated in them is put in place of what is written. */
final class Animations {
    private Animations() {}

    /** The records that what stands at a place has attributes in. */
    private static List<Record> records(Scene scene, ScenePath place) {
        if (place instanceof BodyAt at) {
            Body body = at.in(scene);
            return Stream.of(body.placement(), body.shape(), body.material()).filter(Record.class::isInstance).map(Record.class::cast)
                    .filter(record -> record instanceof Placement || record instanceof Shape || record instanceof Material).toList();
        }
        if (place instanceof LightAt at) {
            // One that is made in code need not be a record.
            return scene.lights().get(at.index()) instanceof Record light ? List.of(light) : List.of();
        }
        return List.of(place instanceof CameraAt at ? scene.cameras().get(at.index()) : ((MaterialAt) place).in(scene));
    }

    /** As {@link Animation#values}. */
    static Map<String, String> values(Scene scene, ScenePath place) {
        Map<String, String> values = new LinkedHashMap<>();
        for (Record record : records(scene, place)) {
            Described.inline(record.getClass()).stream().filter(each -> each.isOf(record) && isNumbers(each))
                    .forEach(each -> RecordValues.text(each.value(record)).ifPresent(text -> values.putIfAbsent(each.name(), text)));
        }
        return values;
    }

    /**
     * Checks animations of a scene.
     *
     * @param report hears the animation, and which of its attributes is at fault
     */
    static void check(Scene scene, List<Animation> animations, SceneRules.Report report) {
        Map<String, Animation> seen = new LinkedHashMap<>();
        for (Animation one : animations) {
            if (one.isOfParameter()) {
                check(one, "attribute", one.attribute().equals("value"), "of a parameter, its value is animated, not \"" + one.attribute() + "\"", report);
                checkTwice(one, one.target(), seen, report);
                continue;
            }
            ScenePath place;
            try {
                place = ScenePath.parse(scene, one.target());
            } catch (IllegalArgumentException unknown) {
                report.broken(one, "target", String.valueOf(unknown.getMessage()));
                continue;
            }
            checkTwice(one, place + " " + one.attribute(), seen, report);
            try {
                checkValues(scene, place, one);
            } catch (IllegalArgumentException refused) {
                report.broken(one, "attribute", String.valueOf(refused.getMessage()));
            }
        }
    }

    private static void checkTwice(Animation one, String what, Map<String, Animation> seen, SceneRules.Report report) {
        check(one, "attribute", seen.put(what, one) == null, "there is an animation of " + one.attribute() + " of \"" + one.target() + "\" already; put the keys of both into one", report);
    }

    private static void check(Animation one, String attribute, boolean holds, String sentence, SceneRules.Report report) {
        if (!holds) {
            report.broken(one, attribute, sentence);
        }
    }

    /** Whatever a record says of values outside of its ranges, it says of those at the keys. */
    private static void checkValues(Scene scene, ScenePath place, Animation one) {
        Part part = part(scene, place, one);
        UnaryOperator<double[]> along = along(part, one);
        for (Animation.Key key : one.keys()) {
            with(part.record, Map.of(part.attribute, along.apply(key.numbers())));
        }
    }

    /** A record of what stands at a place, and one of its attributes. */
    private record Part(int number, Record record, Described attribute) {}

    private static Part part(Scene scene, ScenePath place, Animation one) {
        List<Record> records = records(scene, place);
        for (int i = 0; i < records.size(); i++) {
            Record record = records.get(i);
            Optional<Described> found = Described.inline(record.getClass()).stream().filter(known -> known.name().equals(one.attribute()) && known.isOf(record)).findFirst();
            if (found.isPresent()) {
                checkForm(found.get(), one);
                return new Part(i, record, found.get());
            }
        }
        List<String> known = records.stream().flatMap(record -> Described.inline(record.getClass()).stream().filter(each -> each.isOf(record) && isNumbers(each)))
                .map(Described::name).distinct().toList();
        throw new IllegalArgumentException("\"" + one.target() + "\", " + kind(scene, place) + ", has no attribute \"" + one.attribute() + "\""
                + (Similar.nearest(one.attribute(), known).isEmpty() ? " that can be animated; there are " + String.join(", ", known) : Similar.suggestion(one.attribute(), known)));
    }

    private static String kind(Scene scene, ScenePath place) {
        String kind = place instanceof BodyAt at ? at.in(scene).shape().kind() : place instanceof LightAt at ? scene.lights().get(at.index()).kind()
                : place instanceof CameraAt ? "camera" : "material";
        return (kind.matches("[aeio].*") ? "an " : "a ") + kind;
    }

    private static boolean isNumbers(Described one) {
        return switch (one.says().value().form()) {
            case NUMBER, WHOLE, VECTOR, PAIR, SCALE, COLOR -> true;
            case FROM_TO, TEXT, WORDS, FLAG, WORD -> false;
        };
    }

    private static void checkForm(Described attribute, Animation one) {
        Kind kind = attribute.says().value();
        Require.that(isNumbers(attribute), one.attribute() + " is no number, vector or colour, so that it cannot be animated");
        int count = one.keys().get(0).numbers().length;
        if (!one.path().isBlank()) {
            Require.that(kind.form() == Kind.Form.VECTOR, "only what has three numbers goes along a path, not " + one.attribute());
            Require.that(count == 1 || !leads(attribute), "of " + one.attribute() + ", keys along a path say only how far, one number, but have " + count);
            return;
        }
        boolean isRight = switch (kind.form()) {
            case NUMBER, WHOLE -> count == 1;
            case PAIR -> count == 2;
            case SCALE -> count == 1 || count == 3;
            default -> count == 3;
        };
        Require.that(isRight, one.attribute() + " must be " + kind.words() + ", but its keys have " + count + (count == 1 ? " number" : " numbers"));
        Require.that(one.turn() == Animation.Turning.ANGLES || kind == Kind.ROTATION, "turn is for rotations, not for " + one.attribute());
    }

    /** Whether it is a way to look rather than a place. */
    private static boolean leads(Described attribute) {
        return attribute.says().value() == Kind.ROTATION || attribute.name().equals("direction");
    }

    /** From what keys say to values: along a path, places on it, the direction it has there, or the turn that takes +z there. */
    private static UnaryOperator<double[]> along(Part part, Animation one) {
        if (one.path().isBlank()) {
            return numbers -> numbers;
        }
        Way way = Way.of("animate", one.path());
        boolean isRotation = part.attribute.says().value() == Kind.ROTATION;
        boolean leads = leads(part.attribute);
        return numbers -> {
            double[] at = way.at(numbers[0]);
            return isRotation ? new double[] {0, StrictMath.toDegrees(StrictMath.atan2(at[2], at[3])), 0}
                    : leads ? new double[] {at[2], 0, at[3]} : new double[] {at[0], numbers.length > 1 ? numbers[1] : 0, at[1]};
        };
    }

    /** What is animated, looked up in its scene. */
    private record Moving(ScenePath place, Part part, DoubleFunction<double[]> values) {
        static Moving of(Scene scene, Animation one) {
            ScenePath place = ScenePath.parse(scene, one.target());
            Part part = Animations.part(scene, place, one);
            UnaryOperator<double[]> along = along(part, one);
            DoubleFunction<double[]> keys = one.moments();
            return new Moving(place, part, t -> along.apply(keys.apply(t)));
        }
    }

    /** The scene with all values as they are at a time, but for those of parameters, and without animations; for any time. */
    static DoubleFunction<Scene> of(Scene scene) {
        List<Moving> moving = scene.animations().stream().filter(one -> !one.isOfParameter()).map(one -> Moving.of(scene, one)).toList();
        return t -> at(scene, moving, t);
    }

    private static Scene at(Scene scene, List<Moving> moving, double t) {
        Map<ScenePath, Map<Integer, Map<Described, double[]>>> all = new LinkedHashMap<>();
        moving.forEach(one -> all.computeIfAbsent(one.place, at -> new LinkedHashMap<>()).computeIfAbsent(one.part.number, number -> new LinkedHashMap<>())
                .put(one.part.attribute, one.values.apply(t)));
        Scene still = scene.withAnimations(List.of());
        List<Camera> cameras = new ArrayList<>(still.cameras());
        List<Light> lights = new ArrayList<>(still.lights());
        Map<String, Material> materials = new LinkedHashMap<>(still.materials());
        all.forEach((place, values) -> {
            if (place instanceof CameraAt camera) {
                cameras.set(camera.index(), (Camera) with(cameras.get(camera.index()), only(values)));
            } else if (place instanceof LightAt light) {
                lights.set(light.index(), (Light) with((Record) lights.get(light.index()), only(values)));
            } else if (place instanceof MaterialAt material) {
                materials.computeIfPresent(material.name(), (name, old) -> (Material) with(old, only(values)));
            }
        });
        List<BodyAt> bodies = all.keySet().stream().filter(BodyAt.class::isInstance).map(BodyAt.class::cast).toList();
        Scene moved = still.with(bodies, (at, body) -> body(scene, at, body, all.getOrDefault(at, Map.of())));
        moved = cameras.equals(moved.cameras()) ? moved : moved.withCameras(cameras);
        moved = lights.equals(moved.lights()) ? moved : moved.withLights(lights);
        return materials.equals(moved.materials()) ? moved : moved.withMaterials(materials);
    }

    private static Map<Described, double[]> only(Map<Integer, Map<Described, double[]>> values) {
        return values.getOrDefault(0, Map.of());
    }

    private static Body body(Scene scene, BodyAt at, Body body, Map<Integer, Map<Described, double[]>> values) {
        Body result = body;
        List<Record> records = records(scene, at);
        for (Map.Entry<Integer, Map<Described, double[]>> entry : values.entrySet()) {
            Record changed = with(records.get(entry.getKey()), entry.getValue());
            result = changed instanceof Placement placement ? result.placed(placement) : changed instanceof Shape shape ? result.withShape(shape) : result.madeOf((Material) changed);
        }
        return result;
    }

    private static Record with(Record record, Map<Described, double[]> values) {
        return RecordValues.with(record, values);
    }

    /** As {@link Scene#changed}. */
    static Scene following(Scene scene, UnaryOperator<Scene> change, Function<ScenePath, Optional<ScenePath>> place) {
        if (scene.animations().isEmpty()) {
            return change.apply(scene);
        }
        // Meanwhile nothing is animated: between the steps of a change there may be nothing of that name.
        Scene changed = change.apply(scene.withAnimations(List.of()));
        return changed.withAnimations(scene.animations().stream().flatMap(one -> (one.isOfParameter() ? Optional.of(one)
                : place.apply(ScenePath.parse(scene, one.target())).filter(now -> now.isIn(changed)).map(now -> of(changed, now, one))).stream()).toList());
    }

    /** With the target as it is written, as long as that leads there. */
    private static Animation of(Scene scene, ScenePath place, Animation one) {
        return leadsTo(scene, place, one.target()) ? one : one.of(place.text(scene));
    }

    private static boolean leadsTo(Scene scene, ScenePath place, String target) {
        try {
            return ScenePath.parse(scene, target).equals(place);
        } catch (IllegalArgumentException nowhere) {
            return false;
        }
    }
}
