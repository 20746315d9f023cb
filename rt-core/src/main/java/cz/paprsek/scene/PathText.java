package cz.paprsek.scene;

import cz.paprsek.math.Require;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.CameraAt;
import cz.paprsek.scene.ScenePath.LightAt;
import cz.paprsek.scene.ScenePath.MaterialAt;
import cz.paprsek.text.Similar;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Paths of a scene as text, and back. */
final class PathText {
    /** More texts than this are not looked through for the one that was meant. */
    private static final int MOST = 1000;

    private PathText() {}

    /**
     * What is no body is called by a word, a colon, and its name, or its number where it has none.
     *
     * @param names in the order of the scene; empty for none
     * @param path of the one at an index
     */
    private record Word(String word, Function<Scene, List<String>> names, Function<Scene, IntFunction<ScenePath>> path) {
        String text(Scene scene, int index) {
            List<String> all = names.apply(scene);
            Require.that(index < all.size(), "there is no " + word + " #" + (index + 1) + " in this scene");
            return all.get(index).isEmpty() ? number(index) : word + ":" + all.get(index);
        }

        String number(int index) {
            return word + ":#" + (index + 1);
        }

        Stream<ScenePath> all(Scene scene) {
            return IntStream.range(0, names.apply(scene).size()).mapToObj(path.apply(scene));
        }
    }

    private static final Word CAMERA = new Word("camera", scene -> scene.cameras().stream().map(Camera::name).toList(), scene -> CameraAt::new);
    private static final Word LIGHT = new Word("light", scene -> scene.lights().stream().map(Light::name).toList(), scene -> LightAt::new);
    private static final Word MATERIAL = new Word("material", scene -> List.copyOf(scene.materials().keySet()),
            scene -> List.copyOf(scene.materials().keySet().stream().map(MaterialAt::new).toList())::get);
    private static final List<Word> WORDS = List.of(CAMERA, LIGHT, MATERIAL);

    static String of(Scene scene, ScenePath path) {
        if (path instanceof BodyAt body) {
            StringBuilder text = new StringBuilder();
            body.way().forEach(step -> text.append(text.isEmpty() ? "" : "/").append(step(step.in(scene), step.index())));
            return text.toString();
        }
        return path instanceof CameraAt camera ? CAMERA.text(scene, camera.index())
                : path instanceof LightAt light ? LIGHT.text(scene, light.index())
                : MATERIAL.text(scene, index(scene, (MaterialAt) path));
    }

    private static int index(Scene scene, MaterialAt material) {
        int index = List.copyOf(scene.materials().keySet()).indexOf(material.name());
        Require.that(index >= 0, "there is no material named \"" + material.name() + "\" in this scene");
        return index;
    }

    static ScenePath parse(Scene scene, String text) {
        List<ScenePath> found = called(scene, text, false);
        if (found.isEmpty()) {
            found = called(scene, text, true);
        }
        if (found.isEmpty()) {
            List<String> known = Stream.concat(WORDS.stream().flatMap(word -> word.all(scene)), ScenePath.bodies(scene))
                    .limit(MOST + 1).map(path -> of(scene, path)).toList();
            throw new IllegalArgumentException("nothing in this scene is called \"" + text + "\"" + Similar.suggestion(text, known));
        }
        Require.that(found.size() == 1, "\"" + text + "\" may be any of " + found.size()
                + " things in this scene; give them names that tell them apart");
        return found.get(0);
    }

    /** @param byNumber whether to look for things by number that have a name */
    private static List<ScenePath> called(Scene scene, String text, boolean byNumber) {
        List<ScenePath> found = new ArrayList<>();
        for (Word word : WORDS) {
            List<String> names = word.names().apply(scene);
            for (int i = 0; i < names.size() && text.startsWith(word.word() + ":"); i++) {
                if (text.equals(byNumber ? word.number(i) : word.text(scene, i))) {
                    found.add(word.path().apply(scene).apply(i));
                }
            }
        }
        for (int i = 0; i < scene.objects().size(); i++) {
            SceneObject object = scene.objects().get(i);
            if (mayBeIn(object, text, byNumber)) {
                called(ScenePath.body(i), Body.of(object), text, byNumber, found);
            }
        }
        return found;
    }

    /** Passes over most of very many objects in no time. */
    private static boolean mayBeIn(SceneObject object, String text, boolean byNumber) {
        String name = object.name();
        return name.isEmpty() ? text.startsWith(object.shape().kind()) : text.startsWith(name) || (byNumber && text.startsWith(object.shape().kind()));
    }

    private static void called(BodyAt at, Body body, String text, boolean byNumber, List<ScenePath> found) {
        called(at, body, step(body, at.index()), text, byNumber, found);
        if (byNumber && !body.name().isEmpty()) {
            called(at, body, number(body, at.index()), text, true, found);
        }
    }

    private static void called(BodyAt at, Body body, String step, String text, boolean byNumber, List<ScenePath> found) {
        if (text.equals(step)) {
            found.add(at);
        } else if (text.startsWith(step) && text.charAt(step.length()) == '/') {
            String rest = text.substring(step.length() + 1);
            for (int i = 0; i < body.operands().size(); i++) {
                called(at.child(i), Body.of(body.operands().get(i)), rest, byNumber, found);
            }
        }
    }

    private static String step(Body body, int index) {
        return body.name().isEmpty() ? number(body, index) : body.name();
    }

    private static String number(Body body, int index) {
        return body.shape().kind() + "#" + (index + 1);
    }
}
