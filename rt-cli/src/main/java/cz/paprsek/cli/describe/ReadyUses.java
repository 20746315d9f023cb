package cz.paprsek.cli.describe;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** The materials that every scene knows, and a scene uses. */
final class ReadyUses {
    private ReadyUses() {}

    /** By name. */
    static Map<String, Material> of(Scene scene) {
        Map<String, Material> used = new TreeMap<>();
        ScenePath.bodies(scene).forEach(body -> {
            if (body.in(scene).material() instanceof MaterialName reference && !scene.materials().containsKey(reference.name())) {
                Optional.ofNullable(Material.ready().get(reference.name())).ifPresent(material -> used.put(reference.name(), material));
            }
        });
        return used;
    }
}
