package cz.paprsek.scene;

import cz.paprsek.material.Material;
import java.util.AbstractMap;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** The named materials of a scene, in the order of the file; checked by {@link SceneRules} when it was made. Immutable. */
final class Palette extends AbstractMap<String, Material> {
    private final Map<String, Material> all;

    Palette(Map<String, Material> materials) {
        all = Collections.unmodifiableMap(new LinkedHashMap<>(materials));
        SceneRules.checkMaterials(all, SceneRules.REFUSE);
    }

    @Override
    public boolean containsKey(Object name) {
        return all.containsKey(name);
    }

    @Override
    public @Nullable Material get(Object name) {
        return all.get(name);
    }

    @Override
    public Set<String> keySet() {
        return all.keySet();
    }

    @Override
    public Set<Entry<String, Material>> entrySet() {
        return all.entrySet();
    }
}
