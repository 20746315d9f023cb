package cz.paprsek.fx;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.Texts;
import cz.paprsek.fx.view.Theme;
import cz.paprsek.scene.Scene;
import java.util.Locale;
import javafx.beans.property.SimpleObjectProperty;
import javafx.scene.Node;
import org.junit.jupiter.api.Test;

class MainWindowTest {
    @Test
    void viewFillsTheWholeAndComesBack() {
        try (Gui gui = Gui.show(() -> new MainWindow(new EditorModel(Scene.EMPTY), Texts.in(Locale.ENGLISH), new SimpleObjectProperty<>(Theme.LIGHT)).root(), 1280, 800)) {
            Node button = gui.node("#front-maximize");
            Node view = button.getParent().getParent();
            double before = Gui.on(() -> view.getLayoutBounds().getWidth());
            gui.click(button);
            assertThat(Gui.on(() -> view.getLayoutBounds().getWidth())).isGreaterThan(1.8 * before);
            gui.click(button);
            assertThat(Gui.on(() -> view.getLayoutBounds().getWidth())).isEqualTo(before);
        }
    }
}
