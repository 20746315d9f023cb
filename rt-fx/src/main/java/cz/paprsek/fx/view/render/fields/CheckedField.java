package cz.paprsek.fx.view.render.fields;

import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.FirstClick;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.css.PseudoClass;
import javafx.scene.control.TextField;

/**
 * A field for a number. What is out of range is marked, and has no value; nothing that is typed is swallowed, which would make another number of it. It has no formatter:
 * JavaFX's fields with one keep Escape for themselves, by which dialogs are left.
 */
public abstract class CheckedField extends TextField {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");

    private static final int LONGEST = 64;

    private final ReadOnlyBooleanWrapper valid = new ReadOnlyBooleanWrapper(true);

    CheckedField(String id, String name, String hint, int columns) {
        setId(id);
        setPrefColumnCount(columns);
        Hint.of(this).set(hint);
        setAccessibleText(name);
        FirstClick.takesAll(this, () -> true);
        textProperty().addListener((property, old, now) -> judge());
    }

    /** Looks again whether it is a number within range. */
    final void judge() {
        valid.set(getText().length() <= LONGEST && isInRange(getText()));
        pseudoClassStateChanged(REFUSED, !valid.get());
    }

    /** Whether it is a number within range. */
    abstract boolean isInRange(String text);

    /** What it is for and within which range, in the language of the window. */
    public final String wanted() {
        return getAccessibleHelp();
    }

    /** Its number as text if it has one, else what stands there. */
    public abstract String word();

    /** Shows a number that is written as {@link #word} has it. */
    public void say(String word) {
        setText(word);
    }

    /** Whether there is a number within range. */
    public final ReadOnlyBooleanProperty validProperty() {
        return valid.getReadOnlyProperty();
    }
}
