package cz.paprsek.fx.view.xml;

import cz.paprsek.fx.view.look.Hint;
import javafx.scene.control.Label;
import javafx.scene.text.Text;

/** Takes what room there is, and says in it as much as it has room for: all, its short form, or nothing; never a part that ends in dots. All of it is told by a hint. */
final class ShortLabel extends Label {
    private final String whole;
    private final String brief;

    ShortLabel(String whole, String brief) {
        this.whole = whole;
        this.brief = brief;
        setMinWidth(0);
        setPrefWidth(0);
        setMaxWidth(Double.MAX_VALUE);
        Hint.of(this).set(whole);
    }

    @Override
    protected void layoutChildren() {
        setText(hasRoom(whole) ? whole : hasRoom(brief) ? brief : "");
        super.layoutChildren();
    }

    private boolean hasRoom(String text) {
        Text measured = new Text(text);
        measured.setFont(getFont());
        return Math.ceil(measured.getLayoutBounds().getWidth()) <= getWidth() - snappedLeftInset() - snappedRightInset();
    }
}
