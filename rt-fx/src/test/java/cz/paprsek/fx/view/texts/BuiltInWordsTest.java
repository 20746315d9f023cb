package cz.paprsek.fx.view.texts;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.view.dialog.ColorBox;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Labeled;
import javafx.scene.control.MenuItem;
import javafx.scene.control.TextField;
import javafx.scene.input.ContextMenuEvent;
import javafx.scene.layout.VBox;
import javafx.stage.Window;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What JavaFX itself says, in the language of the window. */
class BuiltInWordsTest {
    private final AtomicReference<Texts> texts = new AtomicReference<>(Texts.in(Locale.forLanguageTag("cs")));
    private final BuiltInWords words = Gui.on(() -> new BuiltInWords(texts::get));
    private final ColorBox picker = Gui.on(() -> new ColorBox(Texts.in(Locale.forLanguageTag("cs"))));
    private final TextField field = Gui.on(TextField::new);
    private final Gui gui = Gui.show(() -> new VBox(picker, field), 500, 400);

    @AfterEach
    void close() {
        gui.act(() -> Window.getWindows().stream().filter(window -> window != gui.stage()).toList().forEach(Window::hide));
        gui.act(words::close);
        gui.close();
    }

    @Test
    void aPaletteLeadsToAnyOtherColourInCzech() {
        gui.act(picker::show);
        assertThat(labels()).contains("Jiná barva…").doesNotContain("Custom Color...");
    }

    @Test
    void onASystemOfAnotherLanguageTheMenuIsThatOfTheWindow() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMAN);
            assertThat(BuiltInWords.speakEnglish()).isEqualTo(Locale.GERMAN);
            assertThat(menu()).contains("Vyjmout", "Kopírovat").doesNotContain("Ausschneiden", "Kopieren", "Copy");
        } finally {
            Locale.setDefault(before);
        }
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
