package cz.paprsek.fx.view.xml;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.typing.ByExecutor;
import cz.paprsek.fx.model.typing.Manuscript;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Sphere;
import java.util.Collection;
import java.util.Locale;
import java.util.Optional;
import javafx.application.Platform;
import javafx.geometry.Bounds;
import javafx.scene.control.Labeled;
import javafx.scene.control.ListView;
import javafx.scene.input.KeyCode;
import org.fxmisc.richtext.CodeArea;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The scene as text, by mouse and keys. */
class XmlPaneTest {
    private final EditorModel model = new EditorModel(Scene.EMPTY.plus(SceneObject.of(new Sphere(1)).named("ball")).plus(SceneObject.of(new Sphere(2)).named("other")));
    private final Manuscript manuscript = Gui.on(() -> new Manuscript(model, () -> model.state().typed(), new ByExecutor(Platform::runLater)));
    private final Gui gui = Gui.show(() -> new XmlPane(manuscript, model, Texts.in(Locale.forLanguageTag("cs"))), 700, 400);
    private final CodeArea area = (CodeArea) gui.node("#xml-text");

    @AfterEach
    void close() {
        gui.close();
    }

    private void open() {
        gui.act(() -> manuscript.openProperty().set(true));
        gui.until("the text is there", () -> area.getText().contains("other"));
    }

    private void caretBehind(String text) {
        gui.act(() -> {
            area.requestFocus();
            area.moveTo(area.getText().indexOf(text) + text.length());
        });
    }

    @Test
    void aClickSelectsAndASelectionIsMarked() {
        open();
        gui.act(() -> model.select(ScenePath.body(1)));
        gui.until("marked", () -> styles("other").contains("xml-selected"));
        assertThat(styles("ball")).doesNotContain("xml-selected");
        Bounds ball = Gui.on(() -> {
            int at = area.getText().indexOf("ball");
            return area.screenToLocal(area.getCharacterBoundsOnScreen(at, at + 1).orElseThrow());
        });
        gui.click(area, ball.getCenterX(), ball.getCenterY());
        assertThat(model.selection()).containsExactly(ScenePath.body(0));
    }

    @Test
    void whatIsTypedIsInTheSceneAndMistakesAreToldInTheLanguageOfTheWindow() {
        open();
        caretBehind("radius=\"1");
        gui.keys(KeyCode.PERIOD);
        gui.keys(KeyCode.DIGIT5);
        gui.until("the ball is larger", () -> model.scene().objects().get(0).shape().equals(new Sphere(1.5)));
        gui.keys(KeyCode.X);
        Labeled told = (Labeled) Gui.on(() -> gui.stage().getScene().lookup("#xml-told"));
        gui.until("told", () -> !told.getText().isEmpty());
        assertThat(told.getText()).contains("koule, poloměr: má být konečné číslo větší než 0, ale je \"1.5x\"");
        gui.until("underlined", () -> styles("1.5x").contains("xml-mistake"));
        assertThat(model.scene().objects().get(0).shape()).isEqualTo(new Sphere(1.5));
        gui.act(() -> model.edit(Label.of(Label.Edit.MOVE), scene -> scene.with(ScenePath.body(1), one -> one.placed(Placement.at(0, 9, 0)))));
        gui.until("what moves elsewhere moves here", () -> area.getText().contains("position=\"0 9 0\""));
        assertThat(area.getText()).contains("1.5x");
        assertThat(area.getCaretPosition()).isEqualTo(area.getText().indexOf("1.5x") + 4);
        gui.keys(KeyCode.BACK_SPACE);
        gui.until("nothing is held", () -> !manuscript.page().isHeld());
        assertThat(Gui.on(() -> model.undoableProperty().get().map(Label::edit))).contains(Label.Edit.MOVE);
    }

    @Test
    void whatCouldStandThereIsProposedAndTaken() {
        open();
        caretBehind("name=\"ball\"");
        gui.keys(KeyCode.SPACE);
        gui.keys(KeyCode.CONTROL, KeyCode.SPACE);
        ListView<?> list = (ListView<?>) gui.node("#xml-proposal-list");
        assertThat(Gui.on(() -> list.getItems().size())).isGreaterThan(3);
        gui.keys(KeyCode.M);
        gui.keys(KeyCode.A);
        gui.keys(KeyCode.ENTER);
        gui.until("the names of materials", () -> area.getText().contains("material=\"\"") && list.isVisible() && list.getItems().size() > 5);
        gui.keys(KeyCode.G);
        gui.keys(KeyCode.L);
        gui.keys(KeyCode.ENTER);
        gui.until("of glass", () -> ScenePath.body(0).materialName(model.scene()).equals("glass"));
        assertThat(area.getText()).contains("<sphere name=\"ball\" material=\"glass\"");
    }

    @Test
    void whatIsEmptiedCanBeWrittenInAgain() {
        assertThat(area.isEditable()).as("nothing is there to be written in").isFalse();
        open();
        String whole = area.getText();
        caretBehind("radius=\"1");
        gui.keys(KeyCode.CONTROL, KeyCode.A);
        gui.keys(KeyCode.DELETE);
        assertThat(area.getText()).isEmpty();
        gui.keys(KeyCode.X);
        assertThat(area.getText()).isEqualTo("x");
        gui.until("told", () -> !manuscript.page().problems().isEmpty());
        gui.act(manuscript::giveUp);
        assertThat(area.getText()).isEqualTo(whole);
        assertThat(model.unsavedProperty().get()).isFalse();
    }

    private Collection<String> styles(String text) {
        return Gui.on(() -> Optional.of(area.getText().indexOf(text)).filter(at -> at >= 0).map(at -> area.getStyleOfChar(at)).orElse(java.util.List.of()));
    }
}
