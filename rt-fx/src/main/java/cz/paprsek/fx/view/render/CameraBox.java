package cz.paprsek.fx.view.render;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.render.fields.Named;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import javafx.scene.control.ChoiceBox;

/** Chooses whose picture is rendered, among the cameras of a scene. */
final class CameraBox extends ChoiceBox<Named<Integer>> {
    private static final double WIDTH = 150;
    private final Texts texts;
    private List<String> names = List.of();

    CameraBox(Texts texts) {
        this.texts = texts;
        setId("render-camera");
        // As the names of a scene come after the box has been measured.
        setPrefWidth(WIDTH);
        Hint.of(this).set(texts.of("render.camera.hint"));
    }

    /** Offers the cameras there are now, and chooses the one looked through if that or the cameras have changed. */
    void follow(EditorState state) {
        List<Named<Integer>> cameras = IntStream.range(0, state.scene().cameras().size())
                .mapToObj(i -> new Named<>(i, i + 1 + ": " + PathNames.of(state.scene(), ScenePath.camera(i), texts))).toList();
        if (!cameras.equals(getItems())) {
            getItems().setAll(cameras);
        }
        names = names(state.scene());
        setDisable(cameras.size() < 2);
        getSelectionModel().select(state.eye());
    }

    /** The chosen one in the word of the command line. */
    String word() {
        return Subject.word(names, getValue().value());
    }

    /** Chooses the one of that word, if there is one. */
    void say(String word) {
        IntStream.range(0, names.size()).filter(i -> Subject.word(names, i).equals(word)).findFirst().ifPresent(getSelectionModel()::select);
    }

    /** The scene as the chosen camera sees it. */
    Scene seen(Scene scene) {
        return chosen(scene).stream().mapToObj(scene::through).findFirst().orElse(scene);
    }

    /** What the command line calls the chosen camera; nothing if that is the first. */
    Optional<String> word(Scene scene) {
        return chosen(scene).stream().mapToObj(index -> Subject.word(names(scene), index)).findFirst();
    }

    private static List<String> names(Scene scene) {
        return scene.cameras().stream().map(Camera::name).toList();
    }

    /** None if it is the first, or has gone. */
    private OptionalInt chosen(Scene scene) {
        int index = getValue().value();
        return index > 0 && index < scene.cameras().size() ? OptionalInt.of(index) : OptionalInt.empty();
    }

    /** The name of the chosen camera, if there are several; empty for the only one. */
    String remark() {
        return getItems().size() > 1 ? getValue().name().substring(getValue().name().indexOf(' ') + 1) : "";
    }
}
