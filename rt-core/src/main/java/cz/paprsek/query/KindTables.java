package cz.paprsek.query;

import cz.paprsek.attribute.Described;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePart;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Shape;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;

/** The tables of objects: one of all, and one for each kind of shape, whose columns are the components of its record. */
final class KindTables {
    private KindTables() {}

    /** All objects and operands. */
    static Table<ScenePart> all() {
        return new Table<>("object", columns(List.of(Column.text("kind", part -> part.shape().kind()))), List.of());
    }

    /** A table for each kind there is, in the order of {@link Shape}'s own list. */
    static List<Relation<Scene, ScenePart>> kinds() {
        List<Relation<Scene, ScenePart>> tables = new ArrayList<>();
        records(Shape.class).forEach(type -> {
            List<Column<ScenePart>> measures = Arrays.stream(type.getRecordComponents()).flatMap(component -> measure(component).stream()).toList();
            if (type == Csg.class) {
                for (Csg.Operation operation : Csg.Operation.values()) {
                    tables.add(kind(operation.name(), measures, shape -> shape instanceof Csg csg && csg.operation() == operation));
                }
            } else {
                tables.add(kind(type.getSimpleName(), measures, type::isInstance));
            }
        });
        return tables;
    }

    private static Relation<Scene, ScenePart> kind(String name, List<Column<ScenePart>> measures, Predicate<Shape> isOfKind) {
        Table<ScenePart> table = new Table<>(name.toLowerCase(Locale.ROOT), columns(measures), List.of());
        return new Relation<>(table, scene -> ScenePart.all(scene).filter(part -> isOfKind.test(part.shape())), true);
    }

    private static Stream<Class<?>> records(Class<?> type) {
        return type.isRecord() ? Stream.of(type) : Arrays.stream(type.getPermittedSubclasses()).flatMap(KindTables::records);
    }

    private static List<Column<ScenePart>> columns(List<Column<ScenePart>> own) {
        List<Column<ScenePart>> columns = new ArrayList<>(List.of(
                Column.text("scene", part -> part.scene().name()),
                Column.text("path", ScenePart::path),
                Column.text("name", ScenePart::name),
                Column.number("depth", ScenePart::depth)));
        columns.addAll(own);
        columns.addAll(List.of(
                Column.vector("position", part -> part.placement().position()),
                Column.vector("rotation", part -> part.placement().rotation()),
                Column.vector("scale", part -> part.placement().scale()),
                Column.text("material", ScenePart::materialName)));
        columns.addAll(MaterialColumns.of(ScenePart::material));
        return columns;
    }

    /** The column of a measure; a list of things is counted. */
    private static Optional<Column<ScenePart>> measure(RecordComponent component) {
        String name = Described.name(component);
        Method getter = component.getAccessor();
        Class<?> type = component.getType();
        return Optional.ofNullable(
                type == double.class || type == int.class ? Column.number(name, part -> ((Number) get(getter, part)).doubleValue())
                : type == Vec3.class ? Column.vector(name, part -> (Vec3) get(getter, part))
                : type == String.class ? Column.text(name, part -> (String) get(getter, part))
                : List.class.isAssignableFrom(type) ? Column.number(name, part -> ((List<?>) get(getter, part)).size())
                : null);
    }

    private static Object get(Method getter, ScenePart part) {
        try {
            return getter.invoke(part.shape());
        } catch (IllegalAccessException | InvocationTargetException e) {
            throw new IllegalStateException("a record of a shape does not give out what it has: " + getter, e);
        }
    }
}
