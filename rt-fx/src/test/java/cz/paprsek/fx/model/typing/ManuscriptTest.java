package cz.paprsek.fx.model.typing;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.OriginalText;
import cz.paprsek.xml.SceneFileException;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Text that is written in while the scene is edited, without a window. */
class ManuscriptTest {
    private static final String TEXT = """
            <scene xmlns="urn:paprsek:scene:1">
              <camera position='0 0 5' direction="0 0 -1"/> <!-- do not move -->
              <sphere name="a" radius="1"/>
              <sphere name="b" radius="2"/> <!-- large -->
            </scene>
            """;

    private Optional<OriginalText> file = Optional.empty();
    private final EditorModel model = new EditorModel(Scene.EMPTY);
    private final Manuscript text = new Manuscript(model, () -> model.state().typed().or(() -> file), new ByExecutor(Runnable::run));

    @BeforeEach
    void open() throws IOException, SceneFileException {
        OriginalText read = OriginalText.read(new ByteArrayInputStream(TEXT.getBytes(StandardCharsets.UTF_8)), "a.xml");
        file = Optional.of(read);
        model.open(read.contents().scenes().get(0));
        text.openProperty().set(true);
    }

    private void write(String old, String fresh) {
        text.write(text.page().text().replace(old, fresh));
        text.check();
    }

    private void move(int body, double x) {
        model.edit(Label.of(Label.Edit.MOVE), scene -> scene.with(ScenePath.body(body), one -> one.placed(Placement.at(x, 0, 0))));
    }

    @Test
    void whatIsValidIsOneStepAndUndoGivesTheTextBack() {
        assertThat(text.page().text()).isEqualTo(TEXT);
        model.select(ScenePath.body(1));
        write("<sphere name=\"a\" radius=\"1\"/>", "<sphere name=\"new\" radius=\"3\"/>\n  <sphere name=\"a\" radius=\"1.5\"/> <!-- mine -->");
        assertThat(model.scene().objects()).extracting(SceneObject::name).containsExactly("new", "a", "b");
        assertThat(model.selection()).as("follows what it is about").containsExactly(ScenePath.body(2));
        assertThat(text.page().isHeld()).isFalse();
        assertThat(model.undoableProperty().get()).contains(Label.of(Label.Edit.WRITE, "XML"));
        move(1, 7);
        assertThat(text.page().text()).contains("<sphere name=\"a\" radius=\"1.5\" position=\"7 0 0\"/> <!-- mine -->");
        model.undo();
        model.undo();
        assertThat(text.page().text()).isEqualTo(TEXT);
        assertThat(model.unsavedProperty().get()).isFalse();
        assertThat(model.undoableProperty().get()).isEmpty();
        model.redo();
        assertThat(text.page().text()).contains("<!-- mine -->");
    }

    @Test
    void commentsAloneAreAStepToo() {
        write("<!-- large -->", "<!-- small -->");
        assertThat(model.unsavedProperty().get()).isTrue();
        model.undo();
        assertThat(text.page().text()).isEqualTo(TEXT);
    }

    @Test
    void whatIsWrongIsHeldWhateverHappensElsewhere() {
        write("radius=\"1\"", "radius=\"-1\"");
        assertThat(text.page().problems()).singleElement().satisfies(problem -> assertThat(problem.line()).isEqualTo(3));
        assertThat(model.scene().objects().get(0).shape()).as("the last good one").isEqualTo(new Sphere(1));
        move(1, 2);
        assertThat(text.page().text()).as("both").contains("radius=\"-1\"").contains("position=\"2 0 0\"/> <!-- large -->");
        assertThat(text.page().isCrossed()).isFalse();
        assertThat(text.flush()).isFalse();
        model.undo();
        assertThat(text.page().text()).isEqualTo(TEXT.replace("radius=\"1\"", "radius=\"-1\""));
        write("radius=\"-1\"", "radius=\"4\"");
        assertThat(model.scene().objects().get(0).shape()).isEqualTo(new Sphere(4));
        assertThat(text.page().problems()).isEmpty();
    }

    @Test
    void changesOfTheSamePlaceAreToldAndNothingIsLost() {
        write("radius=\"1\"/>", "radius=\"\"/>");
        model.edit(Label.of(Label.Edit.RESIZE), scene -> scene.with(ScenePath.body(0), one -> one.withShape(new Sphere(6))));
        assertThat(text.page().isCrossed()).isTrue();
        assertThat(text.page().text()).contains("radius=\"\"/>").doesNotContain("radius=\"6");
        text.giveUp();
        assertThat(text.page().text()).contains("radius=\"6\"");
        assertThat(text.page().isHeld()).isFalse();
    }

    @Test
    void whatIsTooLongIsSaidAndNotShown() {
        model.open(Scene.EMPTY.withObjects(java.util.Collections.nCopies(100_001, SceneObject.of(new Sphere(1)))));
        assertThat(text.page().text()).isEmpty();
        assertThat(text.page().problems()).singleElement().satisfies(problem -> assertThat(problem.message()).startsWith("the text of a scene of more than 100000 objects"));
        assertThat(text.page().isHeld()).isFalse();
        assertThat(text.flush()).as("saving is not in its way").isTrue();
    }

    @Test
    void placesLeadToThingsAndBackAlsoWhileSomethingIsHeld() {
        write("name=\"a\" radius=\"1\"", "name=\"a longer name\" radius=\"?\"");
        String now = text.page().text();
        assertThat(text.page().at(now.indexOf("\"b\""))).contains(ScenePath.body(1));
        assertThat(text.page().of(ScenePath.body(1))).hasValueSatisfying(stand -> assertThat(now.substring(stand.from(), stand.to())).isEqualTo("<sphere name=\"b\" radius=\"2\"/>"));
        assertThat(text.page().at(now.indexOf("camera"))).contains(ScenePath.camera(0));
        assertThat(text.page().at(3)).isEmpty();
    }
}
