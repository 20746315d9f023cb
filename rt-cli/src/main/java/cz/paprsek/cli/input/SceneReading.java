package cz.paprsek.cli.input;

import cz.paprsek.io.Failures;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.Problem;
import cz.paprsek.xml.SceneFileException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * What a file has in it: scenes, or problems.
 *
 * @param scenes one, or those of a database; empty if there are problems
 * @param problems empty if the file is valid
 * @param text empty if there are problems
 */
public record SceneReading(Path file, List<Scene> scenes, List<Problem> problems, Optional<OriginalText> text) {

    public static SceneReading of(Path file) {
        try {
            OriginalText text = Incoming.text(file);
            return new SceneReading(file, text.contents().scenes(), List.of(), Optional.of(text));
        } catch (SceneFileException e) {
            return refused(file, e.problems());
        } catch (IOException e) {
            String sentence = Failures.sentence(file.toString(), e);
            return refused(file, List.of(new Problem(file.toString(), 0, 0, sentence.substring(file.toString().length() + 2))));
        }
    }

    private static SceneReading refused(Path file, List<Problem> problems) {
        return new SceneReading(file, List.of(), problems, Optional.empty());
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
