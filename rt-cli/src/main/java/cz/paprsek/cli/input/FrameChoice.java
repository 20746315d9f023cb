package cz.paprsek.cli.input;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.scene.Scene;
import cz.paprsek.xml.SceneFiles;
import java.util.Optional;
import picocli.CommandLine.Option;

/** Which frame of a film the user wants of a scene, if not the scene as it is written. */
public final class FrameChoice {
    @Option(names = "--frame", paramLabel = "N", description = "Frame N of the film that the scene is, the first being 1. Default: the scene as it is written.")
    private Optional<Integer> frame = Optional.empty();

    public boolean isChosen() {
        return frame.isPresent();
    }

    /** @throws WrongUsage if there is no such frame */
    public Scene of(Scene scene) {
        try {
            return frame.isPresent() ? SceneFiles.frames(scene).apply(frame.get()) : scene;
        } catch (IllegalArgumentException refused) {
            throw new WrongUsage(String.valueOf(refused.getMessage()));
        }
    }
}
