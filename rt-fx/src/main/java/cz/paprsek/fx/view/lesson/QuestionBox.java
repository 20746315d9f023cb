package cz.paprsek.fx.view.lesson;

import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.io.Failures;
import cz.paprsek.lesson.Question;
import cz.paprsek.lesson.Question.Found;
import cz.paprsek.lesson.Question.Mark;
import cz.paprsek.lesson.Question.Verdict;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javafx.application.Platform;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/** A question with a field for its answer, which is marked by Enter or a button; a hint for whoever asks; when it is right, why. */
final class QuestionBox extends VBox {
    private final Question question;
    private final CompletableFuture<List<Double>> right;
    private final Texts texts;
    private final Consumer<Question> onRight;
    private final TextField field = new TextField();
    private final Label verdict;
    private final Button explain;

    /**
     * @param number among the parts of the lesson, for ids
     * @param right the right numbers, as soon as they are known
     * @param onLook explains a pixel
     * @param onRight is told when it has been answered rightly
     */
    QuestionBox(int number, Question question, CompletableFuture<List<Double>> right, Texts texts, BiConsumer<Integer, Integer> onLook, Consumer<Question> onRight) {
        this.question = question;
        this.right = right;
        this.texts = texts;
        this.onRight = onRight;
        getStyleClass().add("lesson-box");
        verdict = Verdicts.line("lesson-verdict-" + number);
        String asked = question.asked().in(texts.locale());
        field.setId("lesson-answer-" + number);
        field.setPromptText(texts.of(question.numbers() == 1 ? "lesson.number" : "lesson.numbers", question.numbers()));
        field.setAccessibleText(asked);
        field.setOnAction(event -> mark());
        Button check = new Button(texts.of("lesson.check"));
        check.setId("lesson-check-" + number);
        check.setOnAction(event -> mark());
        Label hint = Verdicts.line("lesson-hint-" + number);
        Button help = new Button(texts.of("lesson.hint"));
        help.setId("lesson-help-" + number);
        help.setOnAction(event -> Verdicts.say(hint, question.hint().in(texts.locale()), false, false));
        explain = new Button(texts.of("lesson.explain"));
        explain.setId("lesson-explain-" + number);
        explain.setVisible(false);
        explain.managedProperty().bind(explain.visibleProperty());
        if (question.answer() instanceof Found found) {
            explain.setOnAction(event -> onLook.accept(found.column(), found.row()));
        }
        for (Button button : List.of(check, help, explain)) {
            button.setMinWidth(Region.USE_PREF_SIZE);
        }
        getChildren().addAll(Verdicts.text(asked, "lesson-asked"), field, new FlowPane(6, 6, check, help, explain), hint, verdict);
    }

    TextField field() {
        return field;
    }

    /** Shows what was answered earlier. */
    void recall(String typed) {
        field.setText(typed);
        if (!typed.isBlank()) {
            mark();
        }
    }

    private void mark() {
        right.thenAccept(numbers -> Platform.runLater(() -> show(question.mark(field.getText(), numbers)))).exceptionally(failed -> {
            Platform.runLater(() -> Verdicts.say(verdict, texts.sentence(Failures.sentence(failed instanceof CompletionException && failed.getCause() != null ? failed.getCause() : failed)), false, true));
            return null;
        });
    }

    private void show(Mark mark) {
        String told = mark.told().map(said -> " " + said.in(texts.locale())).orElse("");
        boolean isRight = mark.verdict() == Verdict.RIGHT;
        switch (mark.verdict()) {
            case RIGHT -> Verdicts.say(verdict, texts.of("lesson.right") + told, true, false);
            case WRONG -> Verdicts.say(verdict, texts.of("lesson.wrong") + told, false, true);
            case UNREADABLE -> Verdicts.say(verdict, texts.of(question.numbers() == 1 ? "lesson.unreadable" : "lesson.unreadable-numbers", question.numbers()), false, true);
        }
        explain.setVisible(isRight && question.answer() instanceof Found);
        if (isRight) {
            onRight.accept(question);
        }
    }
}
