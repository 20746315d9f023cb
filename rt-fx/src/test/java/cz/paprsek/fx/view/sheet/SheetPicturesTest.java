package cz.paprsek.fx.view.sheet;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.Screenshots;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.edit.Adding;
import cz.paprsek.fx.model.edit.Examples;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern.Checkerboard;
import cz.paprsek.material.Rgb;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Sphere;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.event.ActionEvent;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.text.Text;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The sheet's states, for eyes; and that no word in them is cut off. */
class SheetPicturesTest {
    private static final Map<String, Set<ScenePath>> STATES = Map.of(
            "scene", Set.of(),
            "sphere", Set.of(ScenePath.body(0)),
            "floor", Set.of(ScenePath.body(1)),
            "several", Set.of(ScenePath.body(0), ScenePath.body(1)),
            "light", Set.of(ScenePath.light(0)),
            "camera", Set.of(ScenePath.camera()));

    private static final List<Lens> LENSES = List.of(new Lens.Orthographic(3), new Lens.Spherical(), Lens.Fisheye.DEFAULT);

    private final EditorModel model = new EditorModel(Scene.EMPTY
            .plus("steel", Material.color(180, 190, 200).withHighlight(0.6, 100))
            .plus(Light.at(4, 5, 3).named("key"))
            .plus(SceneObject.of(new Sphere(0.5)).named("ball").at(-12.375, 0.5, 0.125).madeOf(Material.DEFAULT.withTransparency(0.85, 1.5)),
                    SceneObject.of(new Rectangle(-5, -5, 5, 5)).named("floor").rotated(-90, 0, 0)
                            .madeOf(Material.DEFAULT.withPattern(new Checkerboard(10, 10, Rgb.WHITE, Rgb.grey(40)))),
                    SceneObject.of(new Sphere(1)).madeOf("steel")));

    @ParameterizedTest
    @CsvSource({"en, LIGHT", "cs, DARK"})
    void noWordIsCutOff(String language, Theme theme) {
        try (Gui gui = Gui.show(() -> new PropertySheet(model, Texts.in(Locale.forLanguageTag(language)), new SimpleBooleanProperty(true), (kind, owner) -> java.util.Optional.empty(), new Clock(model)), 300, 980)) {
            gui.act(() -> theme.applyTo(gui.stage().getScene()));
            STATES.forEach((state, items) -> {
                gui.act(() -> model.select(items));
                gui.pulse();
                Path file = Screenshots.save(gui, "sheet-" + state + "-" + language);
                assertThat(file).isNotEmptyFile();
                assertThat(Gui.on(() -> cutOff(gui.stage().getScene().getRoot()))).as(state).isEmpty();
            });
            for (ScenePath item : ofEveryKind(gui)) {
                gui.act(() -> model.select(item));
                gui.pulse();
                assertThat(Gui.on(() -> cutOff(gui.stage().getScene().getRoot()))).as(item.toString()).isEmpty();
            }
            refuse(gui);
            Screenshots.save(gui, "sheet-refused-" + language);
        }
    }

    /** Lights, shapes and cameras of every kind, added to the scene. */
    private List<ScenePath> ofEveryKind(Gui gui) {
        Scene now = model.scene();
        List<Light> lights = Stream.concat(now.lights().stream(), Adding.LIGHTS.stream()).toList();
        List<SceneObject> objects = Stream.concat(now.objects().stream(), Examples.ofSize(1).stream().map(SceneObject::of)).toList();
        List<Camera> cameras = Stream.concat(now.cameras().stream(), LENSES.stream().map(now.camera()::withLens)).toList();
        gui.act(() -> model.edit(cz.paprsek.fx.model.Label.of(cz.paprsek.fx.model.Label.Edit.ADD),
                scene -> scene.withLights(lights).withObjects(objects).withCameras(cameras)));
        return Stream.of(IntStream.range(0, lights.size()).mapToObj(ScenePath::light), IntStream.range(0, objects.size()).mapToObj(ScenePath::body),
                IntStream.range(0, cameras.size()).mapToObj(ScenePath::camera)).<ScenePath>flatMap(items -> items).toList();
    }

    private void refuse(Gui gui) {
        gui.act(() -> model.select(ScenePath.body(0)));
        gui.pulse();
        gui.act(() -> {
            TextField radius = (TextField) gui.stage().getScene().lookup("#shape-radius");
            radius.setText("-2");
            radius.fireEvent(new ActionEvent());
        });
    }

    /** The texts of all labels that end in dots for lack of room. */
    private static List<String> cutOff(Node root) {
        return root.lookupAll(".label").stream().filter(Label.class::isInstance).map(Label.class::cast)
                .filter(label -> !label.getText().isEmpty() && label.isVisible())
                .filter(label -> label.lookupAll(".text").stream().anyMatch(text -> !((Text) text).getText().equals(label.getText())))
                .map(Label::getText).toList();
    }
}
