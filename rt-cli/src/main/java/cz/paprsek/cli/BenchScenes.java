package cz.paprsek.cli;

import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Similar;
import cz.paprsek.scene.StandardScenes;
import java.util.Collections;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;

/** The standard scenes by name, in the order of the table. */
final class BenchScenes implements Iterable<String> {
    private static final Map<String, Supplier<Scene>> KNOWN = known();

    private static Map<String, Supplier<Scene>> known() {
        Map<String, Supplier<Scene>> scenes = new LinkedHashMap<>();
        scenes.put("few", StandardScenes::few);
        scenes.put("flake4", () -> StandardScenes.flake(4));
        scenes.put("flake5", () -> StandardScenes.flake(5));
        scenes.put("cloud100k", () -> StandardScenes.cloud(100_000));
        scenes.put("cloud1M", () -> StandardScenes.cloud(1_000_000));
        scenes.put("csg1000", () -> StandardScenes.carved(1000));
        scenes.put("csgn1000", () -> StandardScenes.pierced(1000));
        return Collections.unmodifiableMap(scenes);
    }

    /** All names; picocli shows them as completion candidates. */
    @Override
    public Iterator<String> iterator() {
        return KNOWN.keySet().iterator();
    }

    /** Whether there is a scene of that name. */
    static void check(String name) {
        if (!KNOWN.containsKey(name)) {
            throw new WrongUsage("there is no standard scene \"" + name + "\"" + Similar.suggestion(name, KNOWN.keySet())
                    + "; there are " + String.join(", ", KNOWN.keySet()));
        }
    }

    /** Makes the scene of that name, which must be known. */
    static Scene make(String name) {
        Supplier<Scene> maker = KNOWN.get(name);
        if (maker == null) {
            throw new IllegalArgumentException("unknown scene " + name);
        }
        return maker.get();
    }
}
