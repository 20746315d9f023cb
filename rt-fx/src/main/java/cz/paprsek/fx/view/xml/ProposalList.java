package cz.paprsek.fx.view.xml;

import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.xml.typing.Completion;
import cz.paprsek.xml.typing.Completion.Proposal;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.VBox;

/** What could be written where the caret is, below it. The keyboard stays in the text. */
final class ProposalList extends VBox {
    private static final double ROW = 22;
    private static final int MOST_ROWS = 10;
    private static final double WIDTH = 330;

    private final Texts texts;
    private final Consumer<Proposal> taken;
    private final Label expected = new Label();
    private final ListView<Proposal> list = new ListView<>();

    ProposalList(Texts texts, Consumer<Proposal> taken) {
        this.texts = texts;
        this.taken = taken;
        setId("xml-proposals");
        getStyleClass().add("xml-proposals");
        list.setId("xml-proposal-list");
        list.setFixedCellSize(ROW);
        list.setFocusTraversable(false);
        list.setPrefWidth(WIDTH);
        list.setCellFactory(view -> new Cell());
        list.setOnMouseClicked(event -> take());
        expected.setId("xml-expected");
        expected.setWrapText(true);
        expected.setMaxWidth(WIDTH);
        getChildren().addAll(expected, list);
        setManaged(false);
        hide();
    }

    /** Shows them below a place in the coordinates of the parent; nothing if there are none and nothing is to be said. */
    void show(Completion found, double x, double y, double lineHeight) {
        expected.setText(found.expected().isEmpty() ? "" : texts.of("xml.must-be", texts.sentence(found.expected())));
        show(expected, !found.expected().isEmpty());
        list.getItems().setAll(found.proposals());
        list.getSelectionModel().select(0);
        list.scrollTo(0);
        list.setPrefHeight(Math.min(MOST_ROWS, found.proposals().size()) * ROW + 2);
        show(list, !found.proposals().isEmpty());
        setVisible(!found.proposals().isEmpty() || expected.isVisible());
        applyCss();
        double width = WIDTH + 2;
        double height = prefHeight(width);
        double right = getParent().getLayoutBounds().getWidth();
        double bottom = getParent().getLayoutBounds().getHeight();
        resizeRelocate(Math.max(0, Math.min(x, right - width)), y + height > bottom && y - lineHeight - height >= 0 ? y - lineHeight - height : y, width, height);
        layout();
    }

    private static void show(Node node, boolean is) {
        node.setVisible(is);
        node.setManaged(is);
    }

    void hide() {
        setVisible(false);
    }

    /** Whether it is there and has used a key. */
    boolean uses(KeyEvent event) {
        if (!isVisible()) {
            return false;
        }
        int size = list.getItems().size();
        int at = list.getSelectionModel().getSelectedIndex();
        KeyCode code = event.getCode();
        if (code == KeyCode.ESCAPE) {
            hide();
        } else if (size == 0) {
            return false;
        } else if (code == KeyCode.ENTER) {
            take();
        } else if (code == KeyCode.DOWN || code == KeyCode.UP) {
            select((at + (code == KeyCode.DOWN ? 1 : size - 1)) % size);
        } else if (code == KeyCode.PAGE_DOWN || code == KeyCode.PAGE_UP) {
            select(Math.max(0, Math.min(size - 1, at + (code == KeyCode.PAGE_DOWN ? MOST_ROWS : -MOST_ROWS))));
        } else {
            return false;
        }
        return true;
    }

    private void select(int index) {
        list.getSelectionModel().select(index);
        list.scrollTo(Math.max(0, index - MOST_ROWS / 2));
    }

    private void take() {
        hide();
        Optional.ofNullable(list.getSelectionModel().getSelectedItem()).ifPresent(taken);
    }

    /** Its name, and in the language of the window what it is called and what it must be. */
    private final class Cell extends ListCell<Proposal> {
        @Override
        protected void updateItem(Proposal one, boolean empty) {
            super.updateItem(one, empty);
            setText(empty || one == null ? null : line(one));
            getStyleClass().remove("xml-required");
            if (!empty && one != null && one.isRequired()) {
                getStyleClass().add("xml-required");
            }
        }
    }

    private String line(Proposal one) {
        String called = switch (one.kind()) {
            case ELEMENT -> Stream.of("kind." + one.name(), "element." + one.name()).filter(texts.words()::has).findFirst().map(texts::of).orElse("");
            case ATTRIBUTE -> Stream.of(texts.attribute(one.name()).equals(one.name()) ? "" : texts.attribute(one.name()), texts.sentence(one.expected()))
                    .filter(part -> !part.isEmpty()).reduce((name, must) -> name + ": " + must).orElse("");
            case VALUE, END_TAG -> "";
        };
        return called.isEmpty() || called.equals(one.name()) ? one.name() : one.name() + "   " + called;
    }
}
