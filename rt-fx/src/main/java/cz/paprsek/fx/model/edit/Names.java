package cz.paprsek.fx.model.edit;

import cz.paprsek.scene.SceneRules;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;

/** Makes names unique among siblings. */
public final class Names {
    private final Set<String> taken;
    /** The first number that may be free, where others have been tried. */
    private final Map<String, Integer> next = new HashMap<>();

    /** @param taken which somebody has; those that are taken here are added */
    Names(Set<String> taken) {
        this.taken = taken;
    }

    /** As {@link #free}; from now on somebody has it. */
    String take(String name) {
        String free = free(name);
        taken.add(free);
        return free;
    }

    /** The name itself if nobody has it or it is empty, else with the first free number: "ball" becomes "ball 2", "ball 2" becomes "ball 3". */
    public static String free(String name, Set<String> taken) {
        return new Names(taken).free(name);
    }

    private String free(String name) {
        if (name.isEmpty() || !taken.contains(name)) {
            return name;
        }
        String stem = name.replaceFirst(" \\d{1,9}$", "");
        for (int number = next.getOrDefault(stem, 2); ; number++) {
            String suffix = " " + number;
            String candidate = stem.substring(0, Math.min(stem.length(), SceneRules.LONGEST_NAME - suffix.length())) + suffix;
            if (!taken.contains(candidate)) {
                next.put(stem, number);
                return candidate;
            }
        }
    }
}
