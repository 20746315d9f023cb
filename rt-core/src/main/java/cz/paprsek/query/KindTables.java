package cz.paprsek.query;

import cz.paprsek.attribute.ElementTable;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Shape;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The tables of objects: one of all, and one for each kind of shape, whose columns are the attributes of its record. */
final class KindTables {
    private KindTables() {}

    /** All objects and operands of a scene. */
    static Stream<InScene<BodyAt>> rows(Scene scene) {
        return ScenePath.bodies(scene).map(at -> new InScene<>(scene, at));
    }

    private static Body body(InScene<BodyAt> row) {
        return row.part().in(row.scene());
    }

    /** All objects and operands. */
    static Table<InScene<BodyAt>> all() {
        return new Table<>("object", columns(List.of(Column.text("kind", row -> body(row).shape().kind()))), List.of());
    }

    /** A table for each kind there is, in the order of {@link Shape}'s own list. */
    static List<Relation<Scene, InScene<BodyAt>>> kinds() {
        List<Relation<Scene, InScene<BodyAt>>> tables = new ArrayList<>();
        ElementTable.of(Shape.class).forEach(type -> {
            List<Column<InScene<BodyAt>>> measures = MaterialColumns.attributes(type, row -> body(row).shape());
            if (type == Csg.class) {
                measures = List.of(Column.number("operands", row -> ((Csg) body(row).shape()).operands().size()));
                for (Csg.Operation operation : Csg.Operation.values()) {
                    tables.add(kind(operation.name(), measures, shape -> shape instanceof Csg csg && csg.operation() == operation));
                }
            } else {
                tables.add(kind(ElementTable.name(type), measures, type::isInstance));
            }
        });
        return tables;
    }

    /** A measure that is called as a column of all bodies has its kind before it: of letters {@code depth} is how deep they are within others, {@code text-depth} how thick. */
    private static Relation<Scene, InScene<BodyAt>> kind(String name, List<Column<InScene<BodyAt>>> measures, Predicate<Shape> isOfKind) {
        String word = name.toLowerCase(Locale.ROOT);
        Set<String> common = columns(List.of()).stream().map(Column::name).collect(Collectors.toSet());
        List<Column<InScene<BodyAt>>> own = measures.stream().map(column -> common.contains(column.name()) ? column.named(word + "-" + column.name()) : column).toList();
        Table<InScene<BodyAt>> table = new Table<>(word, columns(own), List.of());
        return new Relation<>(table, scene -> rows(scene).filter(row -> isOfKind.test(body(row).shape())), true);
    }

    private static List<Column<InScene<BodyAt>>> columns(List<Column<InScene<BodyAt>>> own) {
        List<Column<InScene<BodyAt>>> columns = new ArrayList<>(List.of(
                Column.text("scene", row -> row.scene().name()),
                Column.text("path", row -> row.part().text(row.scene())),
                Column.text("name", row -> body(row).name()),
                Column.number("depth", row -> row.part().depth())));
        columns.addAll(own);
        columns.addAll(List.of(
                Column.vector("position", row -> body(row).placement().position()),
                Column.vector("rotation", row -> body(row).placement().rotation()),
                Column.vector("scale", row -> body(row).placement().scale()),
                Column.vectors("pivot", row -> body(row).pivot() instanceof Placement.Point given ? Optional.of(given.pivot()) : Optional.empty()),
                Column.text("hidden", row -> String.valueOf(body(row).hidden())),
                Column.text("material", row -> row.part().materialName(row.scene()))));
        columns.addAll(MaterialColumns.of(row -> row.part().material(row.scene())));
        return columns;
    }
}
