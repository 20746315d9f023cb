package cz.paprsek.scene;

import cz.paprsek.material.Material;
import cz.paprsek.math.Require;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Shape;
import cz.paprsek.text.Similar;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** Any number of scenes, each known by its name, in an order that is kept. Immutable: every change gives a new one. */
public final class SceneDatabase {
    /** Without scenes. */
    public static final SceneDatabase EMPTY = new SceneDatabase(new LinkedHashMap<>());

    private final Map<String, Scene> scenes;

    private SceneDatabase(Map<String, Scene> scenes) {
        this.scenes = Collections.unmodifiableMap(scenes);
    }

    /** What to do with scenes of another database whose names are taken by different ones here. */
    public enum Clash { REFUSE, KEEP, REPLACE }

    /** @throws IllegalArgumentException if a scene has no name, or the name of another */
    public static SceneDatabase of(Collection<Scene> scenes) {
        return EMPTY.plus(scenes);
    }

    /** All scenes, in the order of the database. */
    public List<Scene> scenes() {
        return List.copyOf(scenes.values());
    }

    /** The names of all scenes, in the order of the database. */
    public Set<String> names() {
        return scenes.keySet();
    }

    public int size() {
        return scenes.size();
    }

    public Optional<Scene> find(String name) {
        Objects.requireNonNull(name, "name");
        return Optional.ofNullable(scenes.get(name));
    }

    /**
     * The scene of that name.
     *
     * @throws IllegalArgumentException if there is none, with the name that was probably meant
     */
    public Scene get(String name) {
        return find(name).orElseThrow(() -> new IllegalArgumentException(
                "there is no scene named \"" + name + "\"" + Similar.suggestion(name, scenes.keySet())));
    }

    /** As {@link #plus(Collection)}. */
    public SceneDatabase plus(Scene... more) {
        return plus(Arrays.asList(Objects.requireNonNull(more, "more")));
    }

    /**
     * With these scenes added at the end.
     *
     * @throws IllegalArgumentException if one has no name, or a name that is taken
     */
    public SceneDatabase plus(Collection<Scene> more) {
        Map<String, Scene> all = new LinkedHashMap<>(scenes);
        for (Scene scene : more) {
            Objects.requireNonNull(scene, "scene");
            checkName(scene.name());
            Require.that(all.put(scene.name(), scene) == null, taken(scene.name()));
        }
        return new SceneDatabase(all);
    }

    /**
     * With another scene in the place of the one of that name; it may have another name.
     *
     * @throws IllegalArgumentException if there is no such scene, or the new name is none or taken
     */
    public SceneDatabase replace(String name, Scene scene) {
        get(name);
        checkName(scene.name());
        Require.that(scene.name().equals(name) || !scenes.containsKey(scene.name()), taken(scene.name()));
        Map<String, Scene> all = new LinkedHashMap<>();
        scenes.forEach((key, old) -> all.put(key.equals(name) ? scene.name() : key, key.equals(name) ? scene : old));
        return new SceneDatabase(all);
    }

    /** As {@link #replace}, with the same scene under another name. */
    public SceneDatabase rename(String name, String newName) {
        return replace(name, get(name).withName(newName));
    }

    /**
     * Without the scenes of these names.
     *
     * @throws IllegalArgumentException if there is none of such a name
     */
    public SceneDatabase without(Collection<String> names) {
        names.forEach(this::get);
        Map<String, Scene> all = new LinkedHashMap<>(scenes);
        all.keySet().removeAll(new HashSet<>(names));
        return new SceneDatabase(all);
    }

    /**
     * With the scenes of another database. A scene that is the same in both is no clash.
     *
     * @throws IllegalArgumentException if names clash and that is to be refused
     */
    public SceneDatabase merge(SceneDatabase other, Clash clash) {
        Objects.requireNonNull(clash, "clash");
        Map<String, Scene> all = new LinkedHashMap<>(scenes);
        List<String> clashes = new ArrayList<>();
        other.scenes.forEach((name, scene) -> {
            Scene old = all.get(name);
            if (old == null || clash == Clash.REPLACE) {
                all.put(name, scene);
            } else if (clash == Clash.REFUSE && !old.equals(scene)) {
                clashes.add(name);
            }
        });
        Require.that(clashes.isEmpty(), "both have different scenes named " + quoted(clashes));
        return new SceneDatabase(all);
    }

    /**
     * What comes of two changes to one database, scene by scene: where only one changed a scene, that counts.
     *
     * @param base what both started from
     * @param theirs what it became meanwhile; this is what it is to become
     * @throws IllegalArgumentException naming the scenes that both changed, each in another way
     */
    public SceneDatabase rebase(SceneDatabase base, SceneDatabase theirs) {
        Objects.requireNonNull(base, "base");
        Set<String> names = new LinkedHashSet<>(theirs.scenes.keySet());
        names.addAll(scenes.keySet());
        Map<String, Scene> all = new LinkedHashMap<>();
        List<String> clashes = new ArrayList<>();
        for (String name : names) {
            Optional<Scene> before = base.find(name);
            Optional<Scene> mine = find(name);
            Optional<Scene> their = theirs.find(name);
            if (!mine.equals(before) && !their.equals(before) && !mine.equals(their)) {
                clashes.add(name);
            }
            (mine.equals(before) ? their : mine).ifPresent(scene -> all.put(name, scene));
        }
        Require.that(clashes.isEmpty(), "both changed " + quoted(clashes));
        return new SceneDatabase(all);
    }

    public Stream<InScene<Camera>> cameras() {
        return scenes.values().stream().flatMap(scene -> scene.cameras().stream().map(camera -> new InScene<>(scene, camera)));
    }

    public Stream<InScene<Light>> lights() {
        return scenes.values().stream().flatMap(scene -> scene.lights().stream().map(light -> new InScene<>(scene, light)));
    }

    /** The named materials. */
    public Stream<InScene<Map.Entry<String, Material>>> materials() {
        return scenes.values().stream().flatMap(scene -> scene.materials().entrySet().stream().map(entry -> new InScene<>(scene, entry)));
    }

    /** All objects and their operands. */
    public Stream<InScene<BodyAt>> parts() {
        return scenes.values().stream().flatMap(scene -> ScenePath.bodies(scene).map(at -> new InScene<>(scene, at)));
    }

    /** The objects and operands of a kind, such as {@code Sphere.class}. */
    public Stream<InScene<BodyAt>> parts(Class<? extends Shape> kind) {
        return parts().filter(row -> kind.isInstance(row.part().in(row.scene()).shape()));
    }

    @Override
    public boolean equals(Object other) {
        return this == other || (other instanceof SceneDatabase database && scenes().equals(database.scenes()));
    }

    @Override
    public int hashCode() {
        return scenes().hashCode();
    }

    @Override
    public String toString() {
        return "database of " + size() + " scenes";
    }

    private static void checkName(String name) {
        Require.that(!name.isEmpty(), "a scene in a database needs a name, to be found by");
        SceneRules.checkName("scene name", name);
    }

    private static String taken(String name) {
        return "there is already a scene named \"" + name + "\"; give one of them another name";
    }

    private static String quoted(List<String> names) {
        return "\"" + String.join("\", \"", names.subList(0, Math.min(names.size(), 5))) + "\"" + (names.size() > 5 ? " and " + (names.size() - 5) + " more" : "");
    }
}
