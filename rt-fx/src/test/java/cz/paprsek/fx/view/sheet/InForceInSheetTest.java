package cz.paprsek.fx.view.sheet;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.util.List;
import java.util.stream.Stream;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What stands in where none is given: what is up of cameras that look straight down or up. */
class InForceInSheetTest {
    private static final Camera DOWN = Camera.looking(new Vec3(0, 5, 0), new Vec3(0, -1, 0)).named("down");
    private static final Scene LOOKING = Scene.EMPTY.withCameras(List.of(DOWN, Camera.looking(Vec3.ZERO, Vec3.Y).named("up")));

    private final SheetInHand sheet = SheetInHand.of(LOOKING);
    private final Gui gui = sheet.gui();

    @AfterEach
    void close() {
        gui.close();
    }

    @Test
    void isShownAndWhatIsTypedAndSteppedBeginsWithIt() {
        select(ScenePath.camera(0));
        assertThat(shown()).containsExactly("0", "0", "-1");
        type("#up-x", "0.5");
        assertUp(0, new Vec3(0.5, 0, -1));
        gui.act(sheet.model()::undo);
        gui.pulse();
        gui.click("#up-z");
        gui.keys(KeyCode.UP);
        assertUp(0, new Vec3(0, 0, -0.9));
    }

    @Test
    void isNotWrittenByStepsToAndFro() {
        select(ScenePath.camera(0));
        gui.click("#up-z");
        gui.hold(KeyCode.UP);
        assertUp(0, new Vec3(0, 0, -0.9));
        gui.act(() -> gui.stage().getScene().getFocusOwner().fireEvent(new KeyEvent(KeyEvent.KEY_PRESSED, "", "", KeyCode.DOWN, false, false, false, false)));
        gui.letGo(KeyCode.UP);
        assertThat(sheet.model().scene()).isEqualTo(LOOKING);
    }

    /** The same, none, is given to both, but other things stand in. */
    @Test
    void isToldApartAndKeptOfSeveral() {
        select(ScenePath.camera(0), ScenePath.camera(1));
        assertThat(shown().get(2)).isEmpty();
        type("#up-x", "0.5");
        assertUp(0, new Vec3(0.5, 0, -1));
        assertUp(1, new Vec3(0.5, 0, 1));
    }

    private void select(ScenePath... items) {
        gui.act(() -> sheet.model().select(items));
        gui.until("the sheet shows what is up", () -> gui.stage().getScene().lookup("#up-x") instanceof TextField field && !(field.getText() + field.getPromptText()).isEmpty());
    }

    private List<String> shown() {
        return Gui.on(() -> Stream.of("#up-x", "#up-y", "#up-z").map(id -> ((TextField) gui.stage().getScene().lookup(id)).getText()).toList());
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

    /** Zero may have a sign. */
    private void assertUp(int camera, Vec3 expected) {
        Vec3 up = sheet.model().scene().cameras().get(camera).up();
        assertThat(up.minus(expected).length()).as("%s", up).isZero();
    }
}
