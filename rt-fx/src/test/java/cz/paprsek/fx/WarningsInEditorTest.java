package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.Label;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javafx.scene.control.Button;
import javafx.scene.control.ListView;
import javafx.scene.control.TextInputControl;
import org.assertj.core.api.InstanceOfAssertFactories;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What validate warns of, in the editor; and numbers as the language writes them. */
class WarningsInEditorTest {
    private static final Scene SCENE = Scene.EMPTY.plus(Light.at(3, 9, 9)).plus(SceneObject.of(new Sphere(1)).named("ball").at(0.5, 0, 0))
            .withCameras(List.of(Camera.lookingAt(new Vec3(0, 1, 5), Vec3.ZERO).named("outside"), Camera.lookingAt(new Vec3(0.5, 0, 0.2), Vec3.ZERO).named("inside")));

    @TempDir
    Path folder;

    private EditorGui editor;

    @BeforeEach
    void open() {
        editor = new EditorGui(folder, SCENE);
    }

    @AfterEach
    void close() {
        editor.close();
    }

    @Test
    void aWarningIsCountedListedAndLeadsToTheThing() {
        assertThat(editor.gui.stage().getScene().lookup("#status-warnings").isVisible()).as("all is well").isFalse();
        editor.gui.act(() -> editor.model().look(1));
        editor.gui.until("the camera is inside the ball", () -> editor.gui.stage().getScene().lookup("#status-warnings").isVisible());
        editor.gui.click("#status-warnings");
        ListView<?> list = (ListView<?>) editor.gui.node("#warning-list");
        assertThat(list.getItems()).singleElement().asString().startsWith("the camera is inside sphere \"ball\"");
        editor.gui.act(() -> list.getSelectionModel().select(0));
        assertThat(editor.model().selection()).containsExactly(ScenePath.body(0));
        editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
        editor.gui.until("the new window has looked, too", () -> editor.gui.stage().getScene().lookup("#status-warnings").isVisible());
        editor.gui.click("#status-warnings");
        assertThat(((ListView<?>) editor.gui.node("#warning-list")).getItems()).singleElement().asString().startsWith("kamera je uvnitř neprůhledného tělesa: koule \"ball\"");
        assertThat(Screenshots.save(editor.gui, "warnings")).isNotEmptyFile();
        editor.gui.click(".mend");
        assertThat(editor.model().state().camera().position().minus(new Vec3(0.5, 0, 0)).length()).as("back out of the ball").isBetween(1.05, 1.5);
        assertThat(editor.model().undoableProperty().get()).contains(Label.of(Label.Edit.CHANGE, "Vysunout kameru ven"));
        editor.gui.until("mended", () -> !editor.gui.stage().getScene().lookup("#status-warnings").isVisible());
        assertThat(editor.gui.stage().getScene().lookup("#warnings").isVisible()).isFalse();
    }

    @Test
    void numbersHaveDecimalCommasInCzech() {
        editor.gui.act(() -> editor.model().select(ScenePath.body(0)));
        assertThat(((TextInputControl) editor.gui.node("#placement-position-x")).getText()).isEqualTo("0.5");
        editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
        TextInputControl field = (TextInputControl) editor.gui.node("#placement-position-x");
        assertThat(field.getText()).isEqualTo("0,5");
        editor.gui.act(() -> {
            field.requestFocus();
            field.setText("1,25");
        });
        editor.gui.keys(javafx.scene.input.KeyCode.ENTER);
        assertThat(editor.model().scene().objects().get(0).placement().position().x()).isEqualTo(1.25);
        assertThat(field.getText()).isEqualTo("1,25");
    }

    /** The list stays for a moment, after which it is that of the scene as it is then. */
    @Test
    void asecondClickMendsNothingElse() {
        Csg needless = Csg.difference(Operand.of(new Sphere(1)), Operand.of(new Sphere(1)).at(5, 0, 0), Operand.of(new Sphere(1)).at(0, 1, 0));
        editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.ADD), scene -> scene.withObjects(List.of(SceneObject.of(needless)))));
        editor.gui.until("an operand takes nothing away", () -> editor.gui.stage().getScene().lookup("#status-warnings").isVisible());
        editor.gui.click("#status-warnings");
        editor.gui.act(() -> {
            Button mend = (Button) editor.gui.stage().getScene().lookup(".mend");
            mend.fire();
            mend.fire();
        });
        assertThat(editor.model().scene().objects().get(0).shape()).asInstanceOf(InstanceOfAssertFactories.type(Csg.class))
                .extracting(csg -> csg.operands().size()).as("only what was warned of").isEqualTo(2);
    }
}
