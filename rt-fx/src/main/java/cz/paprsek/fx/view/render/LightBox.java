package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.render.fields.Named;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.scene.control.ChoiceBox;

/** Chooses which lights are lit: all, or one by itself. */
final class LightBox extends ChoiceBox<Named<Integer>> {
    private static final int ALL = -1;
    private static final double WIDTH = 150;
    private final Texts texts;
    private List<String> names = List.of();

    LightBox(Texts texts) {
        this.texts = texts;
        setId("render-lights");
        // As the names of a scene come after the box has been measured.
        setPrefWidth(WIDTH);
        Hint.of(this).set(texts.of("render.lights.hint"));
    }

    /** Offers the lights of a scene, all of them lit. */
    void offer(Scene scene) {
        Stream<Named<Integer>> each = Stream.iterate(0, i -> i + 1).limit(scene.lights().size())
                .map(i -> new Named<>(i, i + 1 + ": " + PathNames.of(scene, ScenePath.light(i), texts)));
        getItems().setAll(Stream.concat(Stream.of(new Named<>(ALL, texts.of("render.lights.all"))), each).toList());
        names = scene.lights().stream().map(Light::name).toList();
        getSelectionModel().selectFirst();
    }

    /** The chosen one in the word of the command line; empty for all. */
    String word() {
        return getValue().value() == ALL ? "" : Subject.word(names, getValue().value());
    }

    /** Chooses the one of that word, if there is one. */
    void say(String word) {
        IntStream.range(0, names.size()).filter(i -> Subject.word(names, i).equals(word)).findFirst().ifPresent(i -> getSelectionModel().select(i + 1));
    }

    /** The scene with what the chosen light adds; as it is if that has gone. */
    Scene lit(Scene scene) {
        return chosen(scene).stream().mapToObj(scene::litBy).findFirst().orElse(scene);
    }

    /** What the command line calls the chosen light; nothing if that is all. */
    Optional<String> word(Scene scene) {
        List<String> names = scene.lights().stream().map(Light::name).toList();
        return chosen(scene).stream().mapToObj(index -> Subject.word(names, index)).findFirst();
    }

    /** None if it is all, or has gone. */
    private OptionalInt chosen(Scene scene) {
        int index = getValue().value();
        return index >= 0 && index < scene.lights().size() ? OptionalInt.of(index) : OptionalInt.empty();
    }
}
