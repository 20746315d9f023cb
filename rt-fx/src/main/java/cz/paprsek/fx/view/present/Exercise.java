package cz.paprsek.fx.view.present;

import cz.paprsek.drawing.RayLine;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.render.explain.text.Step;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;

/** The exercise of a ray, line by line: what the mouse or the keys are at is told, and with blanks the numbers of a line come only when they are asked for. */
final class Exercise extends ListView<Step> {
    private final Texts texts;
    private final Consumer<Optional<Step>> onMeant;
    private Optional<Telling> telling = Optional.empty();
    private Optional<RayLine> pointed = Optional.empty();
    private boolean blank;

    /** @param onMeant is told the line that is meant, whose rays and body light up */
    Exercise(Texts texts, Consumer<Optional<Step>> onMeant) {
        this.texts = texts;
        this.onMeant = onMeant;
        setId("present-steps");
        setPlaceholder(new Label(""));
        setCellFactory(view -> {
            StepCell cell = new StepCell(view, line -> blank && telling.filter(told -> told.isAsked(line)).isEmpty(), this::isLinked);
            cell.setOnMouseEntered(event -> onMeant.accept(Optional.ofNullable(cell.getItem())));
            cell.setOnMouseExited(event -> onMeant.accept(Optional.ofNullable(getSelectionModel().getSelectedItem())));
            cell.setOnMouseClicked(event -> ask(cell.getIndex()));
            return cell;
        });
        getSelectionModel().selectedItemProperty().addListener((property, old, now) -> onMeant.accept(Optional.ofNullable(now)));
    }

    /** Shows the lines of the ray that has come. */
    void show(Optional<Telling> told) {
        telling = told;
        pointed = Optional.empty();
        getItems().setAll(told.map(one -> one.steps(texts.words())).orElse(List.of()));
        scrollTo(0);
        onMeant.accept(Optional.empty());
    }

    /** With blanks in the place of numbers, all of them anew, or without. */
    void setBlank(boolean on) {
        blank = on;
        telling.ifPresent(Telling::forgetAsked);
        refresh();
    }

    /** The mouse is at a ray: the lines that speak of it light up. */
    void point(Optional<RayLine> at) {
        if (!at.equals(pointed)) {
            pointed = at;
            refresh();
        }
    }

    /** The numbers of the next line, over all rays; false if there are no more. */
    boolean askNext() {
        Optional<Integer> next = telling.flatMap(told -> told.nextToAsk(getItems()));
        next.ifPresent(line -> {
            ask(line);
            getSelectionModel().select(line);
            scrollTo(Math.max(0, line - 3));
        });
        return next.isPresent();
    }

    private void ask(int line) {
        telling.ifPresent(told -> told.ask(line));
        refresh();
    }

    private boolean isLinked(Step step) {
        return pointed.isPresent() && telling.filter(told -> told.isAbout(pointed.get(), step.topic())).isPresent();
    }
}
