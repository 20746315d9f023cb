package cz.paprsek.fx.model.edit;

import cz.paprsek.scene.SceneRules;
import java.util.Set;

/** Makes names unique among siblings. */
public final class Names {
    private Names() {}

    /** The name itself if nobody has it or it is empty, else with the first free number: "ball" becomes "ball 2", "ball 2" becomes "ball 3". */
    public static String free(String name, Set<String> taken) {
        if (name.isEmpty() || !taken.contains(name)) {
            return name;
        }
        String stem = name.replaceFirst(" \\d{1,9}$", "");
        for (int number = 2; ; number++) {
            String suffix = " " + number;
            String candidate = stem.substring(0, Math.min(stem.length(), SceneRules.LONGEST_NAME - suffix.length())) + suffix;
            if (!taken.contains(candidate)) {
                return candidate;
            }
        }
    }
}
