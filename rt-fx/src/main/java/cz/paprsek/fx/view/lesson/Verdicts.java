package cz.paprsek.fx.view.lesson;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.layout.Region;

/** Lines that tell whether something is right: in words, and in a colour besides. */
final class Verdicts {
    private static final Pattern PARENTHESES = Pattern.compile("\\([^()]{1,20}\\)");
    private static final PseudoClass GOOD = PseudoClass.getPseudoClass("good");
    private static final PseudoClass BAD = PseudoClass.getPseudoClass("bad");

    private Verdicts() {}

    /** A text that is broken where it must be. */
    static Label text(String words, String styleClass) {
        Label label = new Label(unbroken(words));
        label.getStyleClass().add(styleClass);
        label.setWrapText(true);
        label.setMinHeight(Region.USE_PREF_SIZE);
        return label;
    }

    /** Lines begin neither with a sign of equality nor within short parentheses, such as those of a point. */
    private static String unbroken(String words) {
        return PARENTHESES.matcher(words).replaceAll(found -> Matcher.quoteReplacement(found.group().replace(' ', '\u00a0'))).replace(" =", "\u00a0=");
    }

    /** A line that is not there as long as it says nothing. */
    static Label line(String id) {
        Label label = text("", "lesson-verdict");
        label.setId(id);
        label.visibleProperty().bind(label.textProperty().isNotEmpty());
        label.managedProperty().bind(label.visibleProperty());
        return label;
    }

    static void say(Label line, String words, boolean isGood, boolean isBad) {
        line.setText(unbroken(words));
        line.pseudoClassStateChanged(GOOD, isGood);
        line.pseudoClassStateChanged(BAD, isBad);
    }
}
