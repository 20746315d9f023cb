package cz.paprsek.xml;

import cz.paprsek.formula.Maker;
import cz.paprsek.formula.Written;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.xml.recipe.Moment;
import cz.paprsek.xml.recipe.Script;
import cz.paprsek.xml.text.Unpatchable;
import cz.paprsek.xml.write.SceneForms;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Scenes that have been changed since they were made: their formulas stay where the values have stayed. */
final class Settled {
    private Settled() {}

    /** The scene with a recipe that makes just this; with none if there is no such recipe. */
    static Scene of(Scene scene) {
        Recipe recipe = scene.recipe();
        if (recipe.isNone()) {
            return scene;
        }
        Scene plain = scene.withRecipe(Recipe.NONE);
        try {
            Script script = script(recipe);
            Scene made = only(script).withRecipe(Recipe.NONE);
            if (made.equals(plain)) {
                return scene;
            }
            for (boolean movesInstances : new boolean[] {true, false}) {
                Recipe now = new Recipe(script.reconciled(SceneForms.file(made), SceneForms.file(plain), movesInstances), recipe.included(), recipe.parameters());
                Scene again = only(script(now));
                if (again.withRecipe(Recipe.NONE).equals(plain)) {
                    return plain.withRecipe(again.recipe());
                }
            }
        } catch (SceneFileException | IOException | Unpatchable | IllegalArgumentException hopeless) {
            // Then it is written down as it is.
        }
        return plain;
    }

    /**
     * The scene made anew, with other values of parameters. What comes out as it was stays the very same objects.
     *
     * @throws SceneFileException if it cannot be made of these
     */
    static Scene with(Scene scene, Map<String, String> parameters) throws SceneFileException, IOException {
        Scene settled = of(scene);
        if (settled.recipe().isNone() && !parameters.isEmpty()) {
            throw new SceneFileException(List.of(new Problem("scene", 1, 1, "there is no parameter \"" + parameters.keySet().iterator().next() + "\" here, nor any other")));
        }
        return settled.recipe().isNone() ? scene : like(scene, made(settled.recipe(), parameters, Moment.REST));
    }

    /** As {@link #with(Scene, Map)}, of a scene that has been settled, at another time. */
    static Scene at(Scene settled, Map<String, String> parameters, Moment moment) throws SceneFileException, IOException {
        return settled.recipe().isNone() ? settled : like(settled, made(settled.recipe(), parameters, moment));
    }

    /** The scene where what has become of a first copy becomes of all copies; else as {@link #of}. */
    static Scene following(Scene scene) {
        return following(scene, false);
    }

    /** @param isOfEach whether also where a formula has made each copy another one */
    static Scene following(Scene scene, boolean isOfEach) {
        Recipe recipe = scene.recipe();
        if (!recipe.text().contains("<repeat")) {
            return of(scene);
        }
        try {
            Script script = script(recipe);
            Scene made = only(script).withRecipe(Recipe.NONE);
            Scene plain = scene.withRecipe(Recipe.NONE);
            Optional<String> text = made.equals(plain) ? Optional.empty() : script.following(SceneForms.file(made), SceneForms.file(plain), isOfEach);
            return text.isEmpty() ? of(scene) : like(scene, remade(scene, text.get()));
        } catch (SceneFileException | IOException | Unpatchable hopeless) {
            return of(scene);
        }
    }

    /** What is repeated, and where definitions are used. */
    static List<Maker> makers(Recipe recipe) {
        return script(recipe).makers();
    }

    /** The scene with another value of an attribute of one of its makers, as it is written; without it for none. */
    static Scene with(Scene scene, int maker, String attribute, String value) {
        Scene settled = of(scene);
        if (settled.recipe().isNone()) {
            throw new IllegalArgumentException("nothing is repeated in the scene, and no definition used");
        }
        return like(scene, remade(settled, script(settled.recipe()).with(maker, attribute, value)));
    }

    /** The scene with an element around bodies. */
    static Scene around(Scene scene, List<List<Integer>> bodies, String element, Map<String, String> attributes) {
        Scene settled = of(scene);
        Making how = Making.of(settled.recipe(), Map.of());
        Script script = Script.ofAny(SceneFiles.format(settled).getBytes(StandardCharsets.UTF_8), how.files(), SceneFiles.LARGEST).orElseThrow();
        return like(scene, remade(settled, script.around(bodies, element, attributes)));
    }

    /** The scene, the same as it is, with a definition of a body, which is used where the body stands. */
    static Scene defined(Scene scene, List<Integer> body, String name) {
        Scene settled = of(scene);
        Making how = Making.of(settled.recipe(), Map.of());
        Script script = Script.ofAny(SceneFiles.format(settled).getBytes(StandardCharsets.UTF_8), how.files(), SceneFiles.LARGEST).orElseThrow();
        Scene before = scene.withRecipe(Recipe.NONE);
        for (boolean isMoved : new boolean[] {true, false}) {
            Scene made = like(scene, remade(settled, script.defined(body, name, isMoved)));
            if (made.withRecipe(Recipe.NONE).equals(before)) {
                return made;
            }
        }
        throw new IllegalArgumentException("as a definition this body would be another one");
    }

    /** The scene with another use of a definition beside one. */
    static Scene usedAgain(Scene scene, int maker, double aside) {
        Scene settled = of(scene);
        return like(scene, remade(settled, script(settled.recipe()).usedAgain(maker, aside)));
    }

    static Scene remade(Scene scene, String text) {
        try {
            return only(script(new Recipe(text, scene.recipe().included(), List.of())));
        } catch (SceneFileException refused) {
            throw new IllegalArgumentException(refused.problems().get(0).message(), refused);
        } catch (IOException e) {
            throw new IllegalStateException("a text in memory could not be read", e);
        }
    }

    static Map<Optional<ScenePath>, List<Written>> formulas(Recipe recipe) {
        return script(recipe).formulas();
    }

    /**
     * The scene with another text of how it is made.
     *
     * @throws IllegalArgumentException if that makes no scene, or another one
     */
    static Scene made(Scene wanted, String text) {
        try {
            Scene made = only(script(new Recipe(text, wanted.recipe().included(), List.of())));
            if (made.withRecipe(Recipe.NONE).equals(wanted.withRecipe(Recipe.NONE))) {
                return wanted.withRecipe(made.recipe());
            }
        } catch (SceneFileException | IOException | Unpatchable hopeless) {
            throw new IllegalArgumentException("no formula can stand here", hopeless);
        }
        throw new IllegalArgumentException("no formula can stand here");
    }

    private static Scene made(Recipe recipe, Map<String, String> parameters, Moment moment) throws SceneFileException, IOException {
        return SceneFiles.only(Making.of(recipe, parameters, moment).contents(recipe.text().getBytes(StandardCharsets.UTF_8), "scene").orElseThrow(), "scene");
    }

    static Scene like(Scene before, Scene now) {
        List<SceneObject> objects = new ArrayList<>(now.objects());
        for (int i = 0; i < Math.min(objects.size(), before.objects().size()); i++) {
            SceneObject old = before.objects().get(i);
            SceneObject fresh = objects.get(i);
            objects.set(i, fresh.equals(old) ? old : fresh.shape().equals(old.shape()) ? fresh.withShape(old.shape()) : fresh);
        }
        return now.withObjects(objects);
    }

    static Script script(Recipe recipe) {
        Making how = Making.of(recipe, Map.of());
        return Script.of(recipe.text().getBytes(StandardCharsets.UTF_8), "scene", Map.of(), Moment.REST, how.files(), SceneFiles.LARGEST)
                .orElseThrow(() -> new Unpatchable("nothing is made in the scene any more"));
    }

    private static Scene only(Script script) throws SceneFileException, IOException {
        return SceneFiles.only(Making.contents(script, "scene"), "scene");
    }
}
