package cz.paprsek.fx.model.property;

import cz.paprsek.formula.Written;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.xml.SceneFiles;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;

/**
 * Something about one or several things that can be seen and changed.
 *
 * @param target the things
 * @param path the component, within components, within the things' records
 * @param type what its values are
 * @param trait how it is shown
 */
public record Property(Target target, List<String> path, Class<?> type, Trait trait) {

    public Property {
        path = List.copyOf(path);
    }

    /** The component's name. */
    public String name() {
        return path.get(path.size() - 1);
    }

    /** The key of its label: the component's name, unless there is another of that name beside it. */
    public String label() {
        return (type == Share.class ? "field.shares." : "field.") + name();
    }

    /** A component of its value that is a number. */
    public Property part(String component) {
        List<String> longer = new ArrayList<>(path);
        longer.add(component);
        return new Property(target, longer, double.class, trait);
    }

    /** The value that all the things have in common, as it counts; empty if they differ. */
    public Optional<Object> read(Scene scene) {
        Optional<Object> common = Optional.empty();
        Object[] way = new Object[path.size() - 1];
        for (Record record : target.read(scene)) {
            if (!isAsBefore(record, way)) {
                Optional<Object> value = value(record, path);
                if (value.isEmpty() || (common.isPresent() && !common.equals(value))) {
                    return Optional.empty();
                }
                common = value;
            }
        }
        return common;
    }

    /**
     * Whether something on the way to its value is the very same as on the way of the record before: of a hundred thousand things that are not turned, all have the
     * same rotation, of which no number need be read.
     *
     * @param way what there was, and is from now on
     */
    private boolean isAsBefore(Record record, Object[] way) {
        Object owner = record;
        for (int i = 0; i < path.size() - 1; i++) {
            Optional<Object> next = value((Record) owner, path.get(i));
            if (next.isEmpty() || next.get() == way[i]) {
                return next.isPresent();
            }
            owner = next.get();
            way[i] = owner;
        }
        return false;
    }

    /**
     * The formula that its value is made of; empty if it is a number as it is, or of several things.
     *
     * @param formulas those of the scene, as {@link SceneFiles#formulas} has them
     */
    public Optional<String> formula(Scene scene, Map<Optional<ScenePath>, List<Written>> formulas) {
        if (formulas.isEmpty()) {
            return Optional.empty();
        }
        Optional<Object> value = read(scene);
        return target.spot(scene).flatMap(spot -> formulas.getOrDefault(spot.place(), List.of()).stream()
                .filter(one -> spot.isOf(one, path) && value.filter(number -> isSame(number, one.value())).isPresent()).map(Written::formula).findFirst());
    }

    /** Not where it has been changed since. */
    private static boolean isSame(Object number, String written) {
        try {
            return ((Number) number).doubleValue() == Double.parseDouble(written);
        } catch (NumberFormatException word) {
            return false;
        }
    }

    /** The kind of record that all values are of; empty if they differ in it. */
    public Optional<Class<?>> kind(Scene scene) {
        List<Class<?>> kinds = target.read(scene).stream().flatMap(record -> value(record, path).stream())
                .<Class<?>>map(Object::getClass).distinct().limit(2).toList();
        return kinds.size() == 1 ? Optional.of(kinds.get(0)) : Optional.empty();
    }

    /**
     * The scene with all the things given the same value.
     *
     * @throws IllegalArgumentException with the sentence of the record that refuses it
     */
    public Scene write(Scene scene, Object value) {
        return change(scene, old -> value);
    }

    /**
     * The scene with each value changed from what counts.
     *
     * @throws IllegalArgumentException with the sentence of the record that refuses it
     */
    public Scene change(Scene scene, UnaryOperator<Object> change) {
        return changeKnowing(scene, (owner, old) -> change.apply(old));
    }

    /** As {@link #change}, for changes that depend on the record that has the value. */
    Scene changeKnowing(Scene scene, BiFunction<Record, Object, Object> change) {
        return target.change(scene, record -> changed(record, path, change));
    }

    private static Record changed(Record record, List<String> path, BiFunction<Record, Object, Object> change) {
        String name = path.get(0);
        Optional<RecordComponent> component = Records.component(record.getClass(), name);
        if (component.isEmpty()) {
            return record;
        }
        Object old = Records.counting(record, component.get());
        Object fresh = path.size() == 1 ? change.apply(record, old) : changed((Record) old, path.subList(1, path.size()), change);
        if (record instanceof Scene scene && fresh instanceof Scene.Sky sky) {
            return scene.withSky(sky);
        } else if (record instanceof Scene scene && name.equals("background")) {
            return scene.withBackground((Rgb) fresh);
        } else if (record instanceof RenderSettings settings && fresh instanceof Integrator kind) {
            return settings.withIntegrator(kind);
        }
        return fresh == old || fresh.equals(Records.get(record, component.get())) ? record : Records.with(record, name, fresh);
    }

    private static Optional<Object> value(Record record, List<String> path) {
        Object value = record;
        for (String name : path) {
            Optional<Object> next = value((Record) value, name);
            if (next.isEmpty()) {
                return next;
            }
            value = next.get();
        }
        return Optional.of(value);
    }

    /** As it counts: what is seen is what changes begin with. */
    private static Optional<Object> value(Record owner, String name) {
        return Records.component(owner.getClass(), name).map(component -> Records.counting(owner, component));
    }
}
