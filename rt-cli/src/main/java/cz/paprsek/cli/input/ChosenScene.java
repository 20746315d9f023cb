package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.scene.Scene;
import cz.paprsek.text.Similar;
import cz.paprsek.xml.SceneFileException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** One scene of a file, with what its parameters are to be, and one of its cameras. */
public final class ChosenScene {
    @Option(names = "--scene", paramLabel = "NAME", description = "Which scene of a database.")
    private Optional<String> name = Optional.empty();

    @Option(names = "--camera", paramLabel = "CAMERA", description = Cameras.HELP)
    private Optional<String> camera = Optional.empty();

    @Mixin
    private ParameterWishes parameters;

    /** Where the files come from that it names. */
    public Pictures pictures() {
        return parameters.pictures();
    }

    /**
     * Reads it.
     *
     * @throws WrongUsage if there is no such scene or camera, or if it is not said which of several scenes is meant
     */
    public Scene of(Path file) throws SceneFileException, IOException {
        boolean isGivenLater = name.isPresent() && ChosenValues.areFor(file, parameters);
        Scene named = scene(file, Incoming.read(file, isGivenLater ? parameters.withoutValues() : parameters).scenes(), name);
        Scene scene = isGivenLater ? ChosenValues.given(file, List.of(named), parameters.values()).get(0) : named;
        try {
            return Cameras.through(scene, camera);
        } catch (WrongUsage none) {
            throw new WrongUsage(file + ": " + none.getMessage());
        }
    }

    private static Scene scene(Path file, List<Scene> scenes, Optional<String> name) {
        if (name.isEmpty() && scenes.size() == 1) {
            return scenes.get(0);
        }
        if (name.isEmpty()) {
            throw new WrongUsage(file + " is a database of " + scenes.size() + " scenes; name one with --scene NAME");
        }
        Optional<Scene> named = scenes.stream().filter(scene -> scene.name().equals(name.get())).findFirst();
        return named.orElseThrow(() -> new WrongUsage(file + ": there is no scene named \"" + name.get() + "\""
                + Similar.suggestion(name.get(), scenes.stream().map(Scene::name).toList())));
    }
}
