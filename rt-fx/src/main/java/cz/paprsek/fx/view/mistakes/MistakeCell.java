package cz.paprsek.fx.view.mistakes;

import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.teach.mistake.Mistake;
import javafx.scene.control.ListCell;
import javafx.scene.control.Tooltip;

/** What goes wrong, in the language of the editor; a tooltip has the name that the command line has for it. */
final class MistakeCell extends ListCell<Mistake> {
    private final Texts texts;

    MistakeCell(Texts texts) {
        this.texts = texts;
        setWrapText(true);
        // As wide as the list, so that words are broken rather than left out.
        setPrefWidth(0);
        setStyle("-fx-font-size: 13px; -fx-padding: 4 8 4 8; -fx-cell-size: 0");
    }

    @Override
    protected void updateItem(Mistake mistake, boolean empty) {
        super.updateItem(mistake, empty);
        setText(empty ? null : mistake.meaning(texts.words()));
        setTooltip(empty ? null : new Tooltip(texts.of("mistakes.word", mistake)));
    }
}
