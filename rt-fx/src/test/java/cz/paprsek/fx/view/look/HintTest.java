package cz.paprsek.fx.view.look;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import javafx.scene.AccessibleAttribute;
import javafx.scene.control.Button;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.StackPane;
import javafx.stage.Window;
import org.junit.jupiter.api.Test;

class HintTest {
    @Test
    void itComesWhenTheMouseRestsAndSaysWhatItSaysNow() {
        Button button = Gui.on(() -> new Button("x"));
        Gui.on(() -> {
            Hint.of(button).set("what it does");
            return true;
        });
        try (Gui gui = Gui.show(() -> new StackPane(button), 200, 100)) {
            gui.moveTo(gui.stage().getScene().getRoot(), 1, 1);
            assertThat(button.getTooltip()).as("nobody has come").isNull();
            gui.moveTo(button, 3, 3);
            gui.until("it is told", () -> isTold("what it does"));
            gui.act(() -> Hint.of(button).set("what it does now"));
            gui.until("it is told anew", () -> isTold("what it does now"));
            assertThat(Gui.on(() -> button.queryAccessibleAttribute(AccessibleAttribute.HELP))).isEqualTo("what it does now");
        }
    }

    private static boolean isTold(String text) {
        return Window.getWindows().stream().anyMatch(window -> window instanceof Tooltip hint && hint.isShowing() && hint.getText().equals(text));
    }
}
