package cz.paprsek.cli.bench;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.scene.Scene;
import cz.paprsek.standard.StandardScenes;
import cz.paprsek.text.Similar;
import java.util.Collection;
import java.util.Collections;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Stream;

/** Scenes to measure by name, in the order of the table. */
final class BenchScenes implements Iterable<String> {
    private static final String RING = "ring1M";
    private static final Map<String, Supplier<Scene>> STANDARD = standard();
    private static final Map<String, Supplier<Scene>> GROWING = growing();
    private static final Map<String, Supplier<Scene>> PATHS = paths();
    private static final Map<String, Supplier<Scene>> KNOWN = known();

    private static Map<String, Supplier<Scene>> standard() {
        Map<String, Supplier<Scene>> scenes = new LinkedHashMap<>();
        scenes.put("few", StandardScenes::few);
        scenes.put("flake4", () -> StandardScenes.flake(4));
        scenes.put("flake5", () -> StandardScenes.flake(5));
        scenes.put("cloud100k", () -> StandardScenes.cloud(100_000));
        scenes.put("cloud1M", () -> StandardScenes.cloud(1_000_000));
        scenes.put("mesh1M", () -> StandardScenes.mesh(1_000_000));
        scenes.put("csg1000", () -> StandardScenes.carved(1000));
        scenes.put("csgn1000", () -> StandardScenes.pierced(1000));
        return Collections.unmodifiableMap(scenes);
    }

    /** More and more bodies, and bodies of more and more operands. */
    private static Map<String, Supplier<Scene>> growing() {
        Map<String, Supplier<Scene>> scenes = new LinkedHashMap<>();
        for (int spheres = 10; spheres <= 10_000_000; spheres *= 10) {
            int number = spheres;
            scenes.put("cloud" + thousands(number), () -> StandardScenes.cloud(number));
        }
        for (int operands : new int[] {2, 10, 100, 1000}) {
            scenes.put("chain" + operands, () -> StandardScenes.chain(operands));
        }
        return Collections.unmodifiableMap(scenes);
    }

    /** Those in which light is followed by paths. */
    private static Map<String, Supplier<Scene>> paths() {
        Map<String, Supplier<Scene>> scenes = new LinkedHashMap<>();
        scenes.put("box", StandardScenes::box);
        scenes.put("interior1M", () -> StandardScenes.interior(1_000_000));
        return Collections.unmodifiableMap(scenes);
    }

    private static Map<String, Supplier<Scene>> known() {
        Map<String, Supplier<Scene>> scenes = new LinkedHashMap<>(STANDARD);
        scenes.put("mesh10M", () -> StandardScenes.mesh(10_000_000));
        scenes.put("instances", () -> StandardScenes.instances(1000, 100_000));
        scenes.putAll(PATHS);
        scenes.put(RING, () -> StandardScenes.ring(1_000_000));
        GROWING.forEach(scenes::putIfAbsent);
        return Collections.unmodifiableMap(scenes);
    }

    private static String thousands(int number) {
        return number >= 1_000_000 ? number / 1_000_000 + "M" : number >= 1000 ? number / 1000 + "k" : Integer.toString(number);
    }

    /** The names of the standard scenes. */
    static Set<String> standardNames() {
        return STANDARD.keySet();
    }

    /** The names of those that show how cost grows. */
    static Set<String> growingNames() {
        return GROWING.keySet();
    }

    /** The names of those in which light is followed by paths. */
    static Set<String> pathNames() {
        return PATHS.keySet();
    }

    /** The names of those that are compared with Mitsuba: paths, and rays that meet many triangles. */
    static Collection<String> mitsubasNames() {
        return Stream.concat(PATHS.keySet().stream(), Stream.of(RING)).toList();
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
                    + (Similar.nearest(name, KNOWN.keySet()).isEmpty() ? ";" : "") + " there are " + String.join(", ", KNOWN.keySet()));
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
