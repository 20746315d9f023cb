package cz.paprsek.format.obj;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** The parts of a file: one for each group, and for each of its materials if it has several; each under a name of its own. */
final class Parts {
    private record Key(String group, String material) {}

    private final Map<Key, String> names = new HashMap<>();
    private final Set<String> taken = new HashSet<>();
    private final Map<String, String> materials = new HashMap<>();
    private String group = "";
    private String material = "";

    void group(String name) {
        group = name;
    }

    void material(String name) {
        material = name;
    }

    /** The name of the part that faces belong to now. */
    String current() {
        return names.computeIfAbsent(new Key(group, material), key -> {
            String wanted = taken.contains(key.group) || (key.group.isEmpty() && !key.material.isEmpty()) ? (key.group + " " + key.material).strip() : key.group;
            String name = wanted;
            for (int i = 2; !taken.add(name); i++) {
                name = wanted + " " + i;
            }
            if (!key.material.isEmpty()) {
                materials.put(name, key.material);
            }
            return name;
        });
    }

    Map<String, String> materials() {
        return materials;
    }
}
