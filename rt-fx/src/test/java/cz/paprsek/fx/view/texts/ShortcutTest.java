package cz.paprsek.fx.view.texts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import cz.paprsek.fx.Gui;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ShortcutTest {
    private static KeyEvent event(KeyCode code, boolean shift, boolean control) {
        return new KeyEvent(KeyEvent.KEY_PRESSED, "", "", code, shift, control, false, false);
    }

    @ParameterizedTest
    @CsvSource({"Shortcut+Page Down, Ctrl+Page Down", "Delete, Delete", "Shortcut+Alt+R, Ctrl+Alt+R", "Shortcut+Shift+Down, Ctrl+Shift+↓", "Shift+F1, Shift+F1", "Shortcut+Plus, Ctrl++"})
    void keysAreShownByTheirNames(String keys, String shown) {
        assertThat(Shortcut.of(keys).getDisplayText()).isEqualTo(shown);
    }

    @ParameterizedTest
    @CsvSource({
        "Shortcut+Page Down, PAGE_DOWN, false, true", "Shortcut+Plus, PLUS, false, true", "Shortcut+Plus, ADD, false, true", "Shortcut+Plus, EQUALS, true, true",
        "Shortcut+Minus, SUBTRACT, false, true", "Shortcut+0, NUMPAD0, false, true", "Shortcut+Shift+0, DIGIT0, true, true"})
    void keysThatSayTheSameDoTheSame(String keys, KeyCode code, boolean shift, boolean control) {
        assertThat(Shortcut.of(keys).match(event(code, shift, control))).isTrue();
        assertThat(Shortcut.of(keys).match(event(code, shift, !control))).isFalse();
    }

    /** Ctrl+Alt is AltGr there, by which a Czech keyboard types "{", "ł" and the like. */
    @Test
    void whatTypesIntoAFieldOnWindowsDoesNothingElse() {
        KeyEvent next = new KeyEvent(KeyEvent.KEY_PRESSED, "", "", KeyCode.K, false, true, true, false);
        KeyEvent typed = Gui.on(() -> next.copyFor(next.getSource(), new TextField()));
        assertThat(Shortcut.of("Shortcut+Alt+K").match(typed, true)).isFalse();
        assertThat(Shortcut.of("Shortcut+Alt+K").match(typed, false)).isTrue();
        assertThat(Shortcut.of("Shortcut+Alt+K").match(next, true)).isTrue();
    }

    /** JavaFX takes it for a character, and no key ever gives that. */
    @Test
    void whatIsNoKeyIsRefused() {
        assertThatThrownBy(() -> Shortcut.of("Shortcut+Page_Down")).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("Page_Down");
        assertThat(Shortcut.of("Shortcut+K")).isEqualTo(Shortcut.of("Shortcut+K")).isNotEqualTo(Shortcut.of("Shortcut+L"));
    }
}
