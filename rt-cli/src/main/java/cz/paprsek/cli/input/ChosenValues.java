package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.scene.Scene;
import cz.paprsek.text.Similar;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Values of parameters for the scenes of a database that are chosen: its others may have parameters of the same name with other ranges. */
final class ChosenValues {
    private ChosenValues() {}

    /** Whether values are said, and the file can be read without them first. */
    static boolean areFor(Path file, ParameterWishes parameters) throws IOException {
        return parameters.areSaid() && !Incoming.isOnce(file) && Models.format(file).isEmpty() && Foreign.kind(file).isEmpty() && SceneFiles.isDatabase(file);
    }

    /**
     * Chosen scenes, each with those values that it has parameters for.
     *
     * @throws WrongUsage if none of them has a parameter, or one cannot have its value
     */
    static List<Scene> given(Path file, List<Scene> chosen, Map<String, String> values) {
        List<String> known = chosen.stream().flatMap(scene -> names(scene).stream()).distinct().toList();
        for (String name : values.keySet()) {
            if (!chosen.isEmpty() && !known.contains(name)) {
                String where = chosen.size() == 1 ? "scene \"" + chosen.get(0).name() + "\"" : "in the scenes chosen";
                throw new WrongUsage(file + ": " + where + ": there is no parameter \"" + name + "\"" + Similar.suggestion(name, known));
            }
        }
        return chosen.stream().map(scene -> given(file, scene, values)).toList();
    }

    private static Scene given(Path file, Scene scene, Map<String, String> values) {
        Map<String, String> own = new TreeMap<>(values);
        own.keySet().retainAll(names(scene));
        try {
            return own.isEmpty() ? scene : SceneFiles.with(scene, own);
        } catch (SceneFileException wrong) {
            throw new WrongUsage(file + ": scene \"" + scene.name() + "\": " + wrong.problems().get(0).message());
        }
    }

    private static List<String> names(Scene scene) {
        return scene.recipe().parameters().stream().map(Scene.Recipe.Parameter::name).toList();
    }
}
