package cz.paprsek.fx.view.texts;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.control.ColorPicker;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Labeled;
import javafx.scene.control.MenuItem;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.ContextMenuEvent;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;
import javafx.stage.Window;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What JavaFX itself says, in the language of the window. */
class BuiltInWordsTest {
    private final AtomicReference<Texts> texts = new AtomicReference<>(Texts.in(Locale.forLanguageTag("cs")));
    private final BuiltInWords words = Gui.on(() -> new BuiltInWords(texts::get));
    private final ColorPicker picker = Gui.on(ColorPicker::new);
    private final TextField field = Gui.on(TextField::new);
    private final Gui gui = Gui.show(() -> new VBox(picker, field), 500, 400);

    @AfterEach
    void close() {
        gui.act(() -> Window.getWindows().stream().filter(window -> window != gui.stage()).toList().forEach(Window::hide));
        gui.act(words::close);
        gui.close();
    }

    @Test
    void aColourIsChosenInCzech() {
        gui.act(picker::show);
        Hyperlink own = (Hyperlink) Gui.on(() -> everywhere().filter(Hyperlink.class::isInstance).findFirst().orElseThrow());
        assertThat(own.getText()).isEqualTo("Jiná barva…");
        gui.act(own::fire);
        Stage dialog = Gui.on(() -> Window.getWindows().stream().filter(window -> window instanceof Stage && window != gui.stage()).map(Stage.class::cast).findFirst().orElseThrow());
        assertThat(dialog.getTitle()).isEqualTo("Vlastní barvy");
        assertThat(labels()).contains("Odstín:", "Sytost:", "Jas:", "Krytí:", "Dosavadní barva", "Nová barva", "Uložit", "Použít", "Zrušit");
        gui.act(() -> everywhere().filter(ToggleButton.class::isInstance).map(ToggleButton.class::cast).filter(one -> one.getText().equals("RGB")).forEach(ToggleButton::fire));
        assertThat(labels()).contains("Červená:", "Zelená:", "Modrá:").doesNotContain("Red:", "Hue:");
    }

    @Test
    void theMenuOfAFieldFollowsTheLanguage() {
        assertThat(menu()).contains("Vyjmout", "Kopírovat", "Vložit", "Vybrat vše").doesNotContain("Cut", "Undo", "Delete");
        texts.set(Texts.in(Locale.ENGLISH));
        assertThat(menu()).contains("Cut", "Copy", "Paste", "Select All").doesNotContain("Zpět", "Smazat");
    }

    private List<String> menu() {
        gui.act(() -> field.fireEvent(new ContextMenuEvent(ContextMenuEvent.CONTEXT_MENU_REQUESTED, 5, 5, 50, 50, false, null)));
        return Gui.on(() -> {
            ContextMenu menu = Window.getWindows().stream().filter(ContextMenu.class::isInstance).map(ContextMenu.class::cast).findFirst().orElseThrow();
            List<String> all = menu.getItems().stream().map(MenuItem::getText).filter(text -> text != null).toList();
            menu.hide();
            return all;
        });
    }

    private List<String> labels() {
        return Gui.on(() -> everywhere().filter(Labeled.class::isInstance).map(node -> ((Labeled) node).getText()).toList());
    }

    /** For JavaFX's thread. */
    private Stream<Node> everywhere() {
        return Window.getWindows().stream().filter(window -> window != gui.stage()).flatMap(window -> window.getScene().getRoot().lookupAll("*").stream());
    }
}
