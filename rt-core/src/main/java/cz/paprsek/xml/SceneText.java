package cz.paprsek.xml;

import cz.paprsek.asset.Assets;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.xml.recipe.Script;
import cz.paprsek.xml.text.Encoding;
import cz.paprsek.xml.text.Unpatchable;
import cz.paprsek.xml.typing.LooseMarkup;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * The text of a scene for people who write in it: what its file would have if it were saved now, as characters, with lines that end in {@code \n}. What is
 * typed goes back into the file byte for byte, and what was not touched stays as it is there: ends of lines, encoding and byte-order mark. Immutable.
 */
public final class SceneText {
    private static final char MARK = '\uFEFF';

    private final OriginalText kept;
    private final Scene scene;
    private final byte[] bytes;
    /** As it stands in the file. */
    private final String raw;
    private final String characters;

    /**
     * Where something stands.
     *
     * @param place what it is
     * @param from where its element begins, in characters
     * @param to behind its end
     */
    public record Stand(ScenePath place, int from, int to) {
        public Stand {
            Objects.requireNonNull(place, "place");
        }
    }

    private SceneText(OriginalText kept, Scene scene, byte[] bytes, String raw) {
        this.kept = kept;
        this.scene = scene;
        this.bytes = bytes;
        this.raw = raw;
        characters = plain(raw);
    }

    /**
     * The text that a scene has now.
     *
     * @param kept the file that it is in, or a database; empty if there is none
     * @throws IllegalArgumentException as {@link SceneFiles#format}
     */
    public static SceneText of(Optional<OriginalText> kept, Scene scene) {
        Objects.requireNonNull(scene, "scene");
        OriginalText base = kept.map(text -> text.contents().isDatabase() ? text.alone(scene) : text).orElseGet(() -> OriginalText.of(scene));
        byte[] bytes = kept.isEmpty() ? base.bytes() : base.with(List.of(scene), List.of());
        try {
            return new SceneText(base, scene, bytes, new String(Encoding.of(bytes).toUtf8(bytes), StandardCharsets.UTF_8));
        } catch (Unpatchable unknown) {
            // Such a file is written anew when it is saved.
            OriginalText fresh = OriginalText.of(scene);
            return new SceneText(fresh, scene, fresh.bytes(), new String(fresh.bytes(), StandardCharsets.UTF_8));
        }
    }

    /** The scene that it tells. */
    public Scene scene() {
        return scene;
    }

    /** What the texts of changed scenes start from. */
    public OriginalText kept() {
        return kept;
    }

    /** All of it. */
    public String characters() {
        return characters;
    }

    /**
     * What it becomes by typing.
     *
     * @param typed all characters
     * @param assets what the scene may include
     * @throws SceneFileException if that is no scene, with every problem found
     * @throws IOException if what it includes cannot be read, or it cannot be written in its encoding
     */
    public SceneText typed(String typed, Assets assets) throws SceneFileException, IOException {
        String text = woven(Objects.requireNonNull(typed, "typed"));
        byte[] file = encoded(text);
        OriginalText read = OriginalText.read(new ByteArrayInputStream(file), "text", Map.of(), Objects.requireNonNull(assets, "assets"));
        if (read.contents().isDatabase()) {
            throw new SceneFileException(List.of(new Problem("text", 1, 1, "this is a database of " + read.contents().scenes().size() + " scenes, but one scene was expected")));
        }
        Scene shared = sharing(read.contents().scenes().get(0));
        return new SceneText(read.typed(shared), shared, file, text);
    }

    /** With the objects of before where they are the same, so that a history of many steps is no larger than what has changed. */
    private Scene sharing(Scene fresh) {
        List<SceneObject> old = scene.objects();
        List<SceneObject> objects = new ArrayList<>(fresh.objects());
        int shift = objects.size() - old.size();
        for (int i = 0; i < objects.size(); i++) {
            SceneObject one = objects.get(i);
            if (i < old.size() && old.get(i).equals(one)) {
                objects.set(i, old.get(i));
            } else if (i - shift >= 0 && i - shift < old.size() && old.get(i - shift).equals(one)) {
                objects.set(i, old.get(i - shift));
            }
        }
        return fresh.withObjects(objects);
    }

    private byte[] encoded(String text) throws IOException {
        byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
        try {
            boolean isDeclared = !Encoding.isTold(bytes) && text.indexOf(MARK) != 0;
            return Encoding.of(isDeclared ? utf8 : bytes).fromUtf8(utf8);
        } catch (Unpatchable unknown) {
            throw new IOException(unknown.getMessage(), unknown);
        }
    }

    /** The text as it is to stand in the file: what is not typed as it stands there, and lines that are new with the ends of its others. */
    private String woven(String typed) {
        int most = Math.min(typed.length(), characters.length());
        int before = 0;
        while (before < most && typed.charAt(before) == characters.charAt(before)) {
            before++;
        }
        int behind = 0;
        while (behind < most - before && typed.charAt(typed.length() - 1 - behind) == characters.charAt(characters.length() - 1 - behind)) {
            behind++;
        }
        String lineEnd = raw.contains("\r\n") ? "\r\n" : raw.contains("\r") ? "\r" : "\n";
        return raw.substring(0, rawPlace(before)) + typed.substring(before, typed.length() - behind).replace("\n", lineEnd) + raw.substring(rawPlace(characters.length() - behind));
    }

    private int rawPlace(int place) {
        int at = raw.indexOf(MARK) == 0 ? 1 : 0;
        for (int i = 0; i < place; i++) {
            at += raw.startsWith("\r\n", at) ? 2 : 1;
        }
        return at;
    }

    private static String plain(String raw) {
        String text = raw.indexOf(MARK) == 0 ? raw.substring(1) : raw;
        return text.indexOf('\r') < 0 ? text : text.replace("\r\n", "\n").replace('\r', '\n');
    }

    /** Where the bodies, lights, cameras and named materials of the scene stand; not what stands in files that are included. Works it out anew each time. */
    public List<Stand> stands() {
        byte[] utf8 = characters.getBytes(StandardCharsets.UTF_8);
        List<Stand> stands = new ArrayList<>();
        try {
            Making how = Making.of(scene.recipe(), Map.of());
            Map<Integer, Integer> ends = new HashMap<>();
            LooseMarkup.of(characters).spans().forEach(span -> ends.put(span.from(), span.to()));
            Map<ScenePath, Integer> sites = Script.ofAny(utf8, how.files(), SceneFiles.LARGEST).filter(script -> script.mistakes().isEmpty()).map(Script::sites).orElse(Map.of());
            Map<Integer, Integer> inCharacters = inCharacters(utf8, sites.values());
            sites.forEach((place, at) -> {
                int from = inCharacters.getOrDefault(at, 0);
                stands.add(new Stand(place, from, ends.getOrDefault(from, from)));
            });
        } catch (Unpatchable unusual) {
            stands.clear();
        }
        return stands;
    }

    /** How many characters are before places in bytes, counted once for all of them. */
    private static Map<Integer, Integer> inCharacters(byte[] utf8, Collection<Integer> places) {
        Map<Integer, Integer> found = new HashMap<>();
        int at = 0;
        int characters = 0;
        for (int place : places.stream().sorted().toList()) {
            while (at < place) {
                // A byte within a character is none of its own; the longest characters are two here.
                int first = utf8[at++] & 0xFF;
                characters += (first & 0xC0) == 0x80 ? 0 : first >= 0xF0 ? 2 : 1;
            }
            found.put(place, characters);
        }
        return found;
    }
}
