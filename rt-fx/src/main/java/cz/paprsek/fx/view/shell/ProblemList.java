package cz.paprsek.fx.view.shell;

import cz.paprsek.xml.Problem;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;

/** Lines that tell what is wrong: with a file that could not be opened, by line and column, or with the scene, each leading to the thing it is about. */
public final class ProblemList extends BorderPane {
    /** The list is as high as it needs to be, but not higher, pixels. */
    private static final double HIGHEST = 150;
    private static final double ROW = 28;

    private final UnaryOperator<String> language;
    private final Label title = new Label();
    private final ListView<Entry> list = new ListView<>();

    /** What mends something, as a button. */
    public record Mend(String text, Runnable action) {}

    /** A line, what goes to the thing it is about when it is clicked or walked to, and what mends it if that is known, which is asked for when the line is seen. */
    public record Entry(String text, Runnable jump, Supplier<Optional<Mend>> mend) {
        @Override
        public String toString() {
            return text;
        }
    }

    /**
     * @param name for style sheets and tests: "problem" is listed in "problem-list" within "problems"
     * @param language says the messages in the language of the window
     */
    public ProblemList(String name, String closeHint, UnaryOperator<String> language) {
        this.language = language;
        setId(name + "s");
        getStyleClass().add(name + "s");
        list.setId(name + "-list");
        list.getSelectionModel().selectedItemProperty().addListener((property, old, now) -> jump());
        list.setOnMouseClicked(event -> jump());
        list.setCellFactory(view -> new MendableCell());
        list.setOnKeyPressed(event -> {
            if (event.getCode() == KeyCode.ENTER) {
                Optional.ofNullable(list.getSelectionModel().getSelectedItem()).flatMap(entry -> entry.mend().get()).ifPresent(mend -> mend.action().run());
                event.consume();
            }
        });
        Button close = new Button("", new FontIcon(MaterialDesignC.CLOSE));
        close.setId(name + "s-close");
        close.setAccessibleText(closeHint);
        close.getStyleClass().add("view-button");
        close.setOnAction(event -> hide());
        Region space = new Region();
        HBox.setHgrow(space, Priority.ALWAYS);
        HBox top = new HBox(title, space, close);
        top.setAlignment(Pos.CENTER_LEFT);
        top.getStyleClass().add("view-title");
        setTop(top);
        setCenter(list);
        hide();
    }

    public void show(String header, List<Problem> problems) {
        int longest = problems.stream().mapToInt(p -> place(p).length()).max().orElse(0);
        showEntries(header, problems.stream().map(p -> new Entry(place(p) + " ".repeat(longest - place(p).length()) + "   " + language.apply(p.message()), () -> {}, Optional::empty)).toList());
    }

    private static String place(Problem problem) {
        return problem.line() + ":" + problem.column();
    }

    public void showEntries(String header, List<Entry> entries) {
        title.setText(header);
        list.getItems().setAll(entries);
        list.setPrefHeight(Math.min(HIGHEST, ROW * (entries.size() + 0.5)));
        setVisible(true);
        setManaged(true);
    }

    /** A line with its button at the end: Enter presses it, too. */
    private static final class MendableCell extends ListCell<Entry> {
        @Override
        protected void updateItem(Entry entry, boolean empty) {
            super.updateItem(entry, empty);
            setText(empty || entry == null ? null : entry.text());
            setContentDisplay(ContentDisplay.RIGHT);
            setGraphic(empty || entry == null ? null : entry.mend().get().map(MendableCell::button).orElse(null));
        }

        private static Button button(Mend mend) {
            Button button = new Button(mend.text());
            button.getStyleClass().add("mend");
            button.setFocusTraversable(false);
            button.setMinWidth(Region.USE_PREF_SIZE);
            button.setOnAction(event -> mend.action().run());
            return button;
        }
    }

    private void jump() {
        Optional.ofNullable(list.getSelectionModel().getSelectedItem()).ifPresent(entry -> entry.jump().run());
    }

    public void hide() {
        setVisible(false);
        setManaged(false);
    }
}
