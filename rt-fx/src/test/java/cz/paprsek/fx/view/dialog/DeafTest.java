package cz.paprsek.fx.view.dialog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.fx.Gui;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javafx.application.Platform;
import javafx.scene.Scene;
import javafx.scene.control.Alert;
import javafx.scene.control.Button;
import javafx.scene.control.ButtonBar.ButtonData;
import javafx.scene.control.ButtonType;
import javafx.scene.control.DialogPane;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.StackPane;
import javafx.stage.Stage;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import org.junit.jupiter.api.Test;

/** A window while a question is asked: nothing is done in it, and nothing is done to it. */
class DeafTest {
    private static final KeyEvent ENTER = new KeyEvent(KeyEvent.KEY_PRESSED, "", "", KeyCode.ENTER, false, false, false, false);
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

    /** Before it has been put over its window, on a busy machine. */
    @Test
    void aQuestionThatIsAnsweredAtOnceIsNoFault() {
        List<Throwable> faults = new CopyOnWriteArrayList<>();
        try (Gui gui = Gui.show(() -> new StackPane(button), 300, 200)) {
            gui.act(() -> Thread.currentThread().setUncaughtExceptionHandler((thread, fault) -> faults.add(fault)));
            gui.act(() -> {
                Alert alert = new Alert(Alert.AlertType.CONFIRMATION, "now?", ButtonType.YES, ButtonType.CANCEL);
                Deaf.over(alert, gui.stage());
                alert.show();
                alert.close();
            });
            gui.pulse();
            gui.act(() -> Thread.currentThread().setUncaughtExceptionHandler(null));
        }
        assertThat(faults).isEmpty();
    }

    /** Of the answers that say no, it is the one that loses nothing. */
    @Test
    void escapeAnswersTheQuestionAboutUnsavedChangesByStaying() {
        try (Gui gui = Gui.show(() -> new StackPane(button), 300, 200)) {
            Platform.runLater(() -> {
                ButtonType discard = new ButtonType("discard", ButtonData.NO);
                ButtonType stay = new ButtonType("stay", ButtonData.CANCEL_CLOSE);
                Alert alert = new Alert(Alert.AlertType.CONFIRMATION, "save?", new ButtonType("save", ButtonData.YES), discard, stay);
                done.add(Deaf.ask(alert, gui.stage()).orElse(stay).getText());
            });
            gui.until("it is asked", () -> Window.getWindows().stream().anyMatch(open -> open.isFocused() && open.getScene().getRoot() instanceof DialogPane));
            gui.keys(KeyCode.ESCAPE);
            gui.until("it is answered", () -> !done.isEmpty());
            assertThat(done).containsExactly("stay");
        }
    }

    /** A click or key behind a question takes the keyboard from it, which it must get back. */
    @Test
    void whatIsPressedBehindAQuestionGivesItTheKeyboard() {
        try (Gui gui = Gui.show(() -> new StackPane(button), 300, 200)) {
            Stage question = Gui.on(() -> {
                Stage fresh = new Stage();
                fresh.setScene(new Scene(new StackPane(), 90, 60));
                fresh.setX(400);
                fresh.setY(300);
                return fresh;
            });
            Object open = new Object();
            Platform.runLater(() -> Deaf.<Object>during(() -> {
                question.show();
                return Platform.enterNestedEventLoop(open);
            }, question::requestFocus));
            gui.until("it is asked", question::isFocused);
            for (Runnable press : List.<Runnable>of(() -> gui.click(button), () -> gui.act(() -> button.fireEvent(ENTER)))) {
                gui.act(() -> gui.stage().requestFocus());
                press.run();
                gui.until("the question has the keyboard", question::isFocused);
            }
            assertThat(Gui.on(() -> List.copyOf(done))).isEmpty();
            gui.act(() -> {
                Platform.exitNestedEventLoop(open, "answered");
                question.close();
            });
        }
    }
}
