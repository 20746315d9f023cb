package cz.paprsek.fx.view.dialog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.fx.Gui;
import java.util.ArrayList;
import java.util.List;
import javafx.application.Platform;
import javafx.scene.control.Button;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.StackPane;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;
import org.junit.jupiter.api.Test;

/** A window while a question is asked: nothing is done in it, and nothing is done to it. */
class DeafTest {
    private final List<String> done = new ArrayList<>();
    private final Button button = Gui.on(() -> {
        Button fresh = new Button("here");
        fresh.setOnAction(event -> done.add("clicked"));
        return fresh;
    });

    @Test
    void aWindowHearsNothingUntilTheQuestionIsAnswered() {
        try (Gui gui = Gui.show(() -> new StackPane(button), 300, 200)) {
            Stage stage = gui.stage();
            gui.act(() -> stage.setOnCloseRequest(event -> done.add("closed")));
            boolean wasResizable = Gui.on(stage::isResizable);
            Object question = new Object();
            Platform.runLater(() -> done.add(String.valueOf(Deaf.<Object>during(() -> Platform.enterNestedEventLoop(question)))));
            gui.click(button);
            gui.keys(KeyCode.ENTER);
            gui.act(() -> stage.fireEvent(new WindowEvent(stage, WindowEvent.WINDOW_CLOSE_REQUEST)));
            assertThat(Gui.on(() -> List.copyOf(done))).isEmpty();
            assertThat(Gui.on(stage::isResizable)).isEqualTo(wasResizable);
            gui.act(() -> Platform.exitNestedEventLoop(question, "answered"));
            gui.until("it is answered", () -> done.contains("answered"));
            gui.click(button);
            gui.until("it hears again", () -> done.contains("clicked"));
        }
    }

    @Test
    void afterAFaultItHearsAgain() {
        try (Gui gui = Gui.show(() -> new StackPane(button), 300, 200)) {
            gui.act(() -> assertThatThrownBy(() -> Deaf.during(() -> {
                throw new IllegalStateException("no dialog");
            })).hasMessage("no dialog"));
            gui.click(button);
            gui.until("it hears again", () -> done.contains("clicked"));
        }
    }

    /** Under Windows and macOS a dialog keeps the owner that it belongs to. */
    @Test
    void onlyUnderGtkADialogHasNoOwner() {
        assertThat(FileBox.fixesOwners("Linux")).isTrue();
        assertThat(FileBox.fixesOwners("Windows 11")).isFalse();
        assertThat(FileBox.fixesOwners("Mac OS X")).isFalse();
    }
}
