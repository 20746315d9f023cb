package cz.paprsek.cli.input;

import cz.paprsek.asset.Assets;
import cz.paprsek.format.ForeignFormat;
import cz.paprsek.format.ForeignScene;
import cz.paprsek.format.MeshFiles;
import cz.paprsek.io.Failures;
import cz.paprsek.scene.Scene;
import cz.paprsek.shape.Text;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.Problem;
import cz.paprsek.xml.SceneFileException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * What a file has in it: scenes, or problems.
 *
 * @param scenes one, or those of a database, with the triangles of their meshes and the letters of their texts; empty if the file is no scene
 * @param problems empty if the file is valid
 * @param text empty if the file is no scene of ours
 * @param foreign what a file of another program holds
 * @param lacking the numbers of scenes that a mesh, a relief or a font is not there for, or that cannot be what they say: nothing can be measured in them
 */
public record SceneReading(Path file, List<Scene> scenes, List<Problem> problems, Optional<OriginalText> text, Optional<ForeignScene> foreign, Set<Integer> lacking) {

    public static SceneReading of(Path file) {
        return of(file, ParameterWishes.NONE);
    }

    /** With other values of parameters, and files from elsewhere. */
    public static SceneReading of(Path file, ParameterWishes parameters) {
        try {
            Optional<ForeignFormat> format = Models.format(file);
            if (format.isPresent()) {
                Incoming.refuse(file, parameters);
                ForeignScene read = Models.read(file, format.get());
                return new SceneReading(file, List.of(read.scene()), List.of(), Optional.empty(), Optional.of(read), Set.of());
            }
            OriginalText text = Incoming.text(file, parameters);
            return withMeshes(file, text, parameters.pictures().of(file));
        } catch (SceneFileException e) {
            return refused(file, e.problems());
        } catch (IOException e) {
            String sentence = Failures.sentence(file.toString(), e);
            return refused(file, List.of(new Problem(file.toString(), 0, 0, sentence.substring(file.toString().length() + 2))));
        }
    }

    /** With the triangles of meshes; one that is not to be had is a problem at the attribute that names its file. */
    private static SceneReading withMeshes(Path file, OriginalText text, Assets assets) {
        // What is wrong with a copy is wrong with all, in one place.
        Set<Problem> problems = new LinkedHashSet<>();
        List<Scene> scenes = new ArrayList<>();
        Set<Integer> lacking = new HashSet<>();
        OriginalText.Pointer pointer = text.pointer();
        for (Scene scene : text.contents().scenes()) {
            int number = scenes.size();
            scenes.add(MeshFiles.read(scene, assets, (place, problem) -> {
                lacking.add(number);
                problems.add(pointer.at(number, Optional.of(place), place.in(scene).shape() instanceof Text ? "font" : "file", String.valueOf(problem.getMessage())));
            }));
        }
        return new SceneReading(file, scenes, List.copyOf(problems), Optional.of(text), Optional.empty(), lacking);
    }

    /** The scenes in which everything is there that is to be measured, by their numbers. */
    public IntStream whole() {
        return IntStream.range(0, scenes.size()).filter(scene -> !lacking.contains(scene));
    }

    /** With what there is to say of pictures that its scenes and their meshes name and that are missing or too large; they are not decoded. */
    public SceneReading withPictures(Pictures pictures) {
        Assets assets = pictures.of(file);
        Set<Problem> all = new LinkedHashSet<>(problems);
        Optional<OriginalText.Pointer> pointer = text.map(OriginalText::pointer);
        whole().forEach(number -> Pictures.ofMeshes(scenes.get(number)).forEach((name, at) -> {
            try {
                assets.bytes(name);
            } catch (IOException e) {
                String sentence = Failures.sentence(e);
                all.add(pointer.map(known -> known.at(number, Optional.of(at), "file", sentence)).orElseGet(() -> new Problem(file.toString(), 0, 0, sentence)));
            }
        }));
        for (int i = 0; i < scenes.size() && pointer.isPresent(); i++) {
            for (String name : scenes.get(i).files()) {
                try {
                    assets.bytes(name);
                } catch (IOException e) {
                    Problem problem = pointer.get().naming(i, name, Failures.sentence(e));
                    // Of meshes and fonts, it has been told already.
                    if (all.stream().noneMatch(told -> told.line() == problem.line() && told.column() == problem.column() && told.file().equals(problem.file())
                            && told.message().startsWith(problem.message()))) {
                        all.add(problem);
                    }
                }
            }
        }
        return new SceneReading(file, scenes, List.copyOf(all), text, foreign, lacking);
    }

    /**
     * What a scene of a file lacks, or why it cannot be read, in one line: with the place where the file names it, for which it is read once more.
     *
     * @param label what stands in front if there is no place
     */
    public static String sentence(Path file, String label, Pictures pictures, IOException lack) {
        Stream<Problem> problems = Incoming.isOnce(file) ? Stream.of() : of(file, new ParameterWishes(pictures)).withPictures(pictures).problems().stream();
        return problems.filter(problem -> problem.line() > 0 && problem.message().equals(lack.getMessage())).findFirst().map(Problem::toString)
                .orElseGet(() -> Failures.sentence(label, lack));
    }

    private static SceneReading refused(Path file, List<Problem> problems) {
        return new SceneReading(file, List.of(), problems, Optional.empty(), Optional.empty(), Set.of());
    }

    /** What is in a file of another program but not taken along. */
    public List<String> notes() {
        return foreign.map(read -> read.notes().stream().map(note -> file + ": note: " + note).toList()).orElse(List.of());
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
