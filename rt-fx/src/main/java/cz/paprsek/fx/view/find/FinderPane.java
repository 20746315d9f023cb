package cz.paprsek.fx.view.find;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;

/** A field above everything, and below it what is found by what is typed: arrows go through it, Enter does it, Escape leaves all as it was. */
public final class FinderPane extends StackPane {
    private static final double WIDTH = 560;
    private static final double ROW = 26;
    private static final int MOST_ROWS = 12;

    private final Supplier<List<Findable>> source;
    private final TextField field = new TextField();
    private final ListView<Findable> list = new ListView<>();
    private final Label nothing = new Label();
    private List<Findable> all = List.of();
    private Optional<Node> before = Optional.empty();

    /**
     * @param source what there is to be found, asked for each time it is opened
     * @param prompt what the field says while it is empty
     * @param none what is said if nothing is found
     */
    public FinderPane(Supplier<List<Findable>> source, String prompt, String none) {
        this.source = source;
        setId("finder");
        getStyleClass().add("finder-room");
        getStylesheets().add(String.valueOf(FinderPane.class.getResource("find.css")));
        field.setId("finder-field");
        field.setPromptText(prompt);
        list.setId("finder-list");
        list.setFocusTraversable(false);
        list.setFixedCellSize(ROW);
        list.setCellFactory(view -> new FoundCell());
        nothing.setText(none);
        list.setPlaceholder(nothing);
        list.setOnMouseClicked(event -> {
            if (event.getButton() == MouseButton.PRIMARY) {
                run();
            }
        });
        VBox box = new VBox(field, list);
        box.getStyleClass().add("finder");
        box.setMaxSize(WIDTH, Region.USE_PREF_SIZE);
        StackPane.setAlignment(box, Pos.TOP_CENTER);
        getChildren().add(box);
        field.textProperty().addListener((property, was, is) -> show(is));
        addEventFilter(KeyEvent.KEY_PRESSED, this::pressed);
        setOnMousePressed(event -> close());
        box.setOnMousePressed(event -> event.consume());
        hide();
    }

    /** Opens it with nothing typed. */
    public void open() {
        if (isVisible()) {
            close();
            return;
        }
        before = Optional.ofNullable(getScene()).flatMap(scene -> Optional.ofNullable(scene.getFocusOwner()));
        all = source.get();
        setVisible(true);
        setManaged(true);
        field.clear();
        show("");
        field.requestFocus();
    }

    /** Gives the keyboard back to what had it. */
    private void close() {
        before.filter(node -> node.getScene() == getScene()).ifPresent(Node::requestFocus);
        before = Optional.empty();
        hide();
    }

    private void hide() {
        setVisible(false);
        setManaged(false);
        all = List.of();
        list.getItems().clear();
    }

    private void show(String question) {
        list.getItems().setAll(Findable.matching(all, question));
        list.setPrefHeight(ROW * Math.max(1, Math.min(MOST_ROWS, list.getItems().size())) + 4);
        list.getSelectionModel().select(0);
        list.scrollTo(0);
    }

    private void pressed(KeyEvent event) {
        switch (event.getCode()) {
            case ESCAPE -> close();
            case ENTER -> run();
            case UP -> go(-1);
            case DOWN -> go(1);
            case PAGE_UP -> go(1 - MOST_ROWS);
            case PAGE_DOWN -> go(MOST_ROWS - 1);
            case TAB -> {
                // There is nothing else to go to.
            }
            default -> {
                return;
            }
        }
        event.consume();
    }

    private void go(int by) {
        int next = Math.max(0, Math.min(list.getItems().size() - 1, list.getSelectionModel().getSelectedIndex() + by));
        list.getSelectionModel().select(next);
        list.scrollTo(Math.max(0, next - MOST_ROWS / 2));
    }

    private void run() {
        Optional<Findable> chosen = Optional.ofNullable(list.getSelectionModel().getSelectedItem()).filter(Findable::possible);
        chosen.ifPresent(found -> {
            close();
            found.action().run();
        });
    }

    private static final class FoundCell extends ListCell<Findable> {
        private final Label name = new Label();
        private final Label where = new Label();
        private final Label keys = new Label();
        private final HBox box = new HBox(8, name, where, keys);

        FoundCell() {
            where.getStyleClass().add("finder-where");
            where.setMaxWidth(Double.MAX_VALUE);
            where.setMinWidth(0);
            HBox.setHgrow(where, Priority.ALWAYS);
            name.setMinWidth(Region.USE_PREF_SIZE);
            keys.setMinWidth(Region.USE_PREF_SIZE);
            keys.getStyleClass().add("finder-keys");
            box.setAlignment(Pos.CENTER_LEFT);
            setPrefWidth(0);
        }

        @Override
        protected void updateItem(Findable found, boolean empty) {
            super.updateItem(found, empty);
            setText(null);
            setGraphic(empty || found == null ? null : box);
            if (!empty && found != null) {
                name.setText(found.name());
                where.setText(found.where());
                keys.setText(found.keys());
                box.setOpacity(found.possible() ? 1 : 0.45);
            }
        }
    }
}
