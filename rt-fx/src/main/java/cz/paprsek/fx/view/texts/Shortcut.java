package cz.paprsek.fx.view.texts;

import java.util.ArrayList;
import java.util.List;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;

/** Keys that do something, by their names as they are shown: "Ctrl+Page Down". Plus, minus and digits are those of the block of numbers, too, and plus is found where it needs Shift. In fields for text on Windows, Ctrl+Alt is AltGr, and types. */
public final class Shortcut extends KeyCombination {
    private final KeyCodeCombination shown;
    private final List<KeyCodeCombination> all;

    private Shortcut(KeyCodeCombination shown) {
        super(shown.getShift(), shown.getControl(), shown.getAlt(), shown.getMeta(), shown.getShortcut());
        this.shown = shown;
        List<KeyCodeCombination> found = new ArrayList<>(List.of(shown));
        KeyCode code = shown.getCode();
        if (code == KeyCode.PLUS) {
            found.add(with(KeyCode.ADD, shown.getShift()));
            for (KeyCode plus : List.of(KeyCode.PLUS, KeyCode.EQUALS)) {
                found.add(with(plus, ModifierValue.ANY));
            }
        } else if (code == KeyCode.MINUS) {
            found.add(with(KeyCode.SUBTRACT, shown.getShift()));
        } else if (code.isDigitKey() && !code.isKeypadKey()) {
            found.add(with(KeyCode.valueOf("NUMPAD" + code.getName()), shown.getShift()));
        }
        all = List.copyOf(found);
    }

    private KeyCodeCombination with(KeyCode code, ModifierValue shift) {
        return new KeyCodeCombination(code, shift, shown.getControl(), shown.getAlt(), shown.getMeta(), shown.getShortcut());
    }

    /**
     * Such as "Shortcut+Page Down".
     *
     * @throws IllegalArgumentException if there is no such key: JavaFX itself would take the name for a character, which no key ever gives
     */
    public static Shortcut of(String keys) {
        if (KeyCombination.valueOf(keys) instanceof KeyCodeCombination known) {
            return new Shortcut(known);
        }
        throw new IllegalArgumentException("there is no such key: " + keys);
    }

    @Override
    public boolean match(KeyEvent event) {
        return match(event, System.getProperty("os.name", "").startsWith("Windows"));
    }

    /** @param isWindows whether Ctrl+Alt is what AltGr gives, by which characters are typed: "{" by B on a Czech keyboard */
    boolean match(KeyEvent event, boolean isWindows) {
        boolean isTyped = isWindows && event.isControlDown() && event.isAltDown() && event.getTarget() instanceof TextInputControl;
        return !isTyped && all.stream().anyMatch(keys -> keys.match(event));
    }

    @Override
    public String getName() {
        return shown.getName();
    }

    @Override
    public String getDisplayText() {
        return shown.getDisplayText();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Shortcut same && same.shown.equals(shown);
    }

    @Override
    public int hashCode() {
        return shown.hashCode();
    }
}
