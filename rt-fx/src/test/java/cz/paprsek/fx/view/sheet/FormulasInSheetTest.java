package cz.paprsek.fx.view.sheet;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.Screenshots;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label.Edit;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFileException;
import cz.paprsek.xml.SceneFiles;
import java.util.List;
import java.util.Map;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;

/** Formulas typed into the sheet by a robot. */
@TestInstance(Lifecycle.PER_CLASS)
class FormulasInSheetTest {
    private static final Scene START = SheetInHand.scene("""
            <sphere name="ball" radius="1" position="0 {w/2} 5"/>
            """);

    private final SheetInHand sheet = SheetInHand.of(START);
    private final EditorModel model = sheet.model();
    private final Gui gui = sheet.gui();

    @BeforeEach
    void selectTheBall() {
        sheet.select(START);
    }

    @AfterAll
    void close() {
        gui.close();
    }

    @Test
    void aTextWithACommaStaysOne() {
        Scene scene = SheetInHand.scene("<param name=\"label\" value=\"1,5\"/><sphere radius=\"1\"/>");
        sheet.select(scene);
        gui.click("#parameter-label");
        gui.keys(KeyCode.TAB);
        assertThat(model.scene()).isSameAs(scene);
        assertThat(model.undoableProperty().get()).isEmpty();
        type("#parameter-label", "2,5");
        assertThat(model.scene().recipe().text()).contains("value=\"2,5\"");
    }

    @Test
    void whatIsTypedStaysAFormulaOfTheFile() {
        type("#shape-radius", "=w/2+1");
        assertThat(model.scene().objects().get(0).shape()).isEqualTo(new Sphere(2.5));
        assertThat(model.scene().recipe().text()).contains("radius=\"{w/2+1}\"", "position=\"0 {w/2} 5\"");
        assertThat(shown("#shape-radius")).isEqualTo("=w/2+1");
        gui.click("#name");
        assertThat(shown("#shape-radius")).isEqualTo("\u0192 2.5");
        gui.act(() -> model.edit(cz.paprsek.fx.model.Label.of(Edit.CHANGE, "w"), scene -> made(scene, "5")));
        gui.until("it follows its parameter", () -> text("#shape-radius").equals("\u0192 3.5"));
        gui.act(model::undo);
        gui.act(model::undo);
        assertThat(model.scene()).isSameAs(START);
        gui.until("the number is back", () -> text("#shape-radius").equals("1"));
    }

    @Test
    void sumsAreWorkedOutUnlessTheyAreToBeKept() {
        type("#shape-radius", "3/4");
        assertThat(shown("#shape-radius")).isEqualTo("0.75");
        type("#shape-radius", "{3/4}");
        assertThat(model.scene().recipe().text()).contains("radius=\"{3/4}\"");
    }

    @Test
    void whoStepsByHandHasANumberInItsPlace() {
        assertThat(shown("#placement-position-y")).isEqualTo("\u0192 1.5");
        gui.click("#placement-position-y");
        assertThat(shown("#placement-position-y")).isEqualTo("=w/2");
        gui.keys(KeyCode.UP);
        assertThat(model.scene().objects().get(0).placement().position()).isEqualTo(new Vec3(0, 1.6, 5));
        assertThat(model.scene().recipe().text()).contains("position=\"0 1.6 5\"");
        gui.act(model::undo);
        assertThat(model.scene()).isSameAs(START);
    }

    @Test
    void mistakesAreToldByTheirColumnUnderTheField() {
        type("#shape-radius", "= w + q");
        assertThat(((Label) gui.node(".refusal")).getText()).isEqualTo("column 7: \"q\" is not a number, and no parameter is called so");
        assertThat(model.scene()).isSameAs(START);
        Screenshots.save(gui, "formula-refused");
        gui.keys(KeyCode.ESCAPE);
        assertThat(shown("#shape-radius")).isEqualTo("1");
    }

    /** As in a file: each copy has its own. */
    @Test
    void theNumberOfACopyStandsInAFieldOfWhatIsRepeated() throws SceneFileException {
        Scene row = SceneFiles.parse("<scene xmlns='urn:paprsek:scene:1'><camera position='0 0 9' target='0 0 0'/><repeat count='3' position='2 0 0'><sphere radius='1'/></repeat></scene>");
        gui.act(() -> model.open(row));
        gui.act(() -> model.select(ScenePath.body(2)));
        gui.until("the sheet shows the first copy", () -> gui.stage().getScene().lookup("#shape-radius") instanceof TextField field && !field.getText().isEmpty());
        for (String formula : List.of("0.5+i/4", "1-i/4")) {
            type("#shape-radius", formula);
            assertThat(shown("#shape-radius")).isEqualTo("=" + formula);
            assertThat(model.scene().recipe().text()).contains("<repeat", "radius=\"{" + formula + "}\"");
        }
        assertThat(model.scene().objects()).extracting(one -> one.shape()).containsExactly(new Sphere(1), new Sphere(0.75), new Sphere(0.5));
        gui.act(model::undo);
        assertThat(model.scene().objects().get(2).shape()).isEqualTo(new Sphere(1));
    }

    private static Scene made(Scene scene, String value) {
        try {
            return SceneFiles.with(scene, Map.of("w", value));
        } catch (SceneFileException e) {
            throw new IllegalStateException(e);
        }
    }

    private void type(String field, String text) {
        gui.act(() -> {
            TextField node = (TextField) gui.stage().getScene().lookup(field);
            node.requestFocus();
            node.setText(text);
        });
        gui.keys(KeyCode.ENTER);
        gui.pulse();
    }

    private String text(String field) {
        return ((TextField) gui.stage().getScene().lookup(field)).getText();
    }

    private String shown(String field) {
        return Gui.on(() -> ((TextField) gui.stage().getScene().lookup(field)).getText());
    }
}
