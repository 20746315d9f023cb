package cz.paprsek.cli.input;

import cz.paprsek.io.Failures;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.Problem;
import cz.paprsek.xml.SceneFileException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/**
 * What a file has in it: scenes, or problems.
 *
 * @param scenes one, or those of a database; empty if there are problems
 * @param problems empty if the file is valid
 */
public record SceneReading(Path file, List<Scene> scenes, List<Problem> problems) {

    public static SceneReading of(Path file) {
        try {
            return new SceneReading(file, Incoming.read(file).scenes(), List.of());
        } catch (SceneFileException e) {
            return new SceneReading(file, List.of(), e.problems());
        } catch (IOException e) {
            String sentence = Failures.sentence(file.toString(), e);
            return new SceneReading(file, List.of(), List.of(new Problem(file.toString(), 0, 0, sentence.substring(file.toString().length() + 2))));
        }
    }

    public boolean isValid() {
        return problems.isEmpty();
    }

    /** The problems for people: with line and column, if they are at one. */
    public List<String> sentences() {
        return problems.stream().map(problem -> problem.line() > 0 ? problem.toString() : problem.file() + ": " + problem.message()).toList();
    }

    /** How to call a scene of this file: by the file, and by its name or number if there are several. */
    public String label(int scene) {
        if (scenes.size() == 1) {
            return file.toString();
        }
        String name = scenes.get(scene).name();
        return file + ": " + (name.isEmpty() ? "scene #" + (scene + 1) : "scene \"" + name + "\"");
    }
}
