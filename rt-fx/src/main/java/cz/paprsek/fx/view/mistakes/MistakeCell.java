package cz.paprsek.fx.view.mistakes;

import cz.paprsek.teach.mistake.Mistake;
import cz.paprsek.words.Words;
import javafx.scene.control.ListCell;

/** What goes wrong, in the language of the editor, and below it the name that the command line has for it. */
final class MistakeCell extends ListCell<Mistake> {
    private final Words words;

    MistakeCell(Words words) {
        this.words = words;
        setWrapText(true);
        // As wide as the list, so that words are broken rather than left out.
        setPrefWidth(0);
        setStyle("-fx-font-size: 13px; -fx-padding: 4 8 4 8; -fx-cell-size: 0");
    }

    @Override
    protected void updateItem(Mistake mistake, boolean empty) {
        super.updateItem(mistake, empty);
        setText(empty ? null : mistake.meaning(words) + "\n" + mistake);
    }
}
