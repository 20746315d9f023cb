package cz.paprsek.query;

import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.InScene;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.SpotLight;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/** The table of lights: a column for whatever one of the kinds has, empty for the others. */
final class LightTable {
    private LightTable() {}

    static Table<InScene<Light>> of() {
        Map<String, Column<InScene<Light>>> columns = new LinkedHashMap<>();
        columns.put("scene", Column.text("scene", row -> row.scene().name()));
        columns.put("name", Column.text("name", row -> row.part().name()));
        columns.put("kind", Column.text("kind", row -> row.part().kind()));
        columns.putAll(MaterialColumns.inline(Light.class, InScene::part));
        columns.put("direction", Column.vectors("direction", row -> direction(row.part())));
        columns.remove("size");
        columns.put("width", Column.numbers("width", row -> number(size(row.part()).map(AreaLight.Size::width))));
        columns.put("height", Column.numbers("height", row -> number(size(row.part()).map(AreaLight.Size::height))));
        return new Table<>("light", new ArrayList<>(columns.values()), List.of());
    }

    private static OptionalDouble number(Optional<?> value) {
        return value.isPresent() ? OptionalDouble.of(((Number) value.get()).doubleValue()) : OptionalDouble.empty();
    }

    /** The way its light goes, given or not. */
    private static Optional<Vec3> direction(Light light) {
        return light instanceof SpotLight spot ? Optional.of(spot.direction())
                : light instanceof AreaLight area ? Optional.of(area.direction())
                : MaterialColumns.inForce(light, "direction").map(Vec3.class::cast);
    }

    private static Optional<AreaLight.Size> size(Light light) {
        return light instanceof AreaLight area && area.form() instanceof AreaLight.Size size ? Optional.of(size) : Optional.empty();
    }
}
