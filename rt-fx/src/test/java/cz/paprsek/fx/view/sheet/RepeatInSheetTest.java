package cz.paprsek.fx.view.sheet;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.scene.Scene;
import java.util.Locale;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.Test;

/** How what is selected is repeated, in a Czech window. */
class RepeatInSheetTest {
    @Test
    void repetitionHasTheDecimalSignOfTheLanguage() {
        Scene row = SheetInHand.scene("<repeat count=\"3\" position=\"1.2 0 {w/2}\"><sphere radius=\"1\"/></repeat>");
        SheetInHand czech = SheetInHand.of(row, Locale.forLanguageTag("cs"));
        czech.select(row);
        TextField move = (TextField) Gui.on(() -> czech.gui().stage().getScene().getRoot().lookupAll(".text-field").stream()
                .filter(node -> String.valueOf(node.getId()).matches("repeat-\\d+-position")).findFirst().orElseThrow());
        czech.gui().until("it is shown", () -> move.getText().equals("1,2 0 {w/2}"));
        czech.gui().act(() -> {
            move.requestFocus();
            move.setText("1,5 0 {w/2}");
        });
        czech.gui().keys(KeyCode.ENTER);
        czech.gui().pulse();
        assertThat(czech.model().scene().recipe().text()).contains("position=\"1.5 0 {w/2}\"");
        czech.gui().close();
    }
}
