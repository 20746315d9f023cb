package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class MainWindowTest {
    @Test
    void windowOpensAtTheSizeOfASmallScreen() {
        try (Gui gui = Gui.show(() -> new MainWindow().root(), 1280, 800)) {
            gui.until("the window is shown", () -> gui.stage().isShowing());
            assertThat(gui.node("#main-window").getLayoutBounds().getWidth()).isEqualTo(1280);
        }
    }
}
