package cz.paprsek.fx.view.shell;

import cz.paprsek.xml.Problem;
import java.util.List;
import java.util.function.UnaryOperator;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;

/** What is wrong with a file that could not be opened, by line and column. */
public final class ProblemList extends BorderPane {
    private final UnaryOperator<String> language;
    private final Label title = new Label();
    private final ListView<String> list = new ListView<>();

    /** @param language says the messages in the language of the window */
    public ProblemList(String closeHint, UnaryOperator<String> language) {
        this.language = language;
        setId("problems");
        getStyleClass().add("problems");
        list.setId("problem-list");
        Button close = new Button("", new FontIcon(MaterialDesignC.CLOSE));
        close.setId("problems-close");
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
        list.setPrefHeight(150);
        hide();
    }

    public void show(String header, List<Problem> problems) {
        title.setText(header);
        list.getItems().setAll(problems.stream().map(p -> p.line() + ":" + p.column() + "   " + language.apply(p.message())).toList());
        setVisible(true);
        setManaged(true);
    }

    public void hide() {
        setVisible(false);
        setManaged(false);
    }
}
