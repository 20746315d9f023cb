package cz.paprsek.fx.view.lesson;

import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.lesson.Task;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/** A task, and whether it is done, which is looked at with every change of the scene. */
final class TaskBox extends VBox {
    private final Task task;
    private final Texts texts;
    private final Label verdict;
    private boolean isDone;

    /** @param onBegin opens the lesson's scene anew */
    TaskBox(int number, Task task, Texts texts, Runnable onBegin) {
        this.task = task;
        this.texts = texts;
        getStyleClass().add("lesson-box");
        verdict = Verdicts.line("lesson-verdict-" + number);
        Label hint = Verdicts.line("lesson-hint-" + number);
        Button help = new Button(texts.of("lesson.hint"));
        help.setId("lesson-help-" + number);
        help.setOnAction(event -> Verdicts.say(hint, task.hint().in(texts.locale()), false, false));
        Button begin = new Button(texts.of("lesson.begin"));
        begin.setId("lesson-begin-" + number);
        begin.setOnAction(event -> onBegin.run());
        help.setMinWidth(Region.USE_PREF_SIZE);
        begin.setMinWidth(Region.USE_PREF_SIZE);
        getChildren().addAll(Verdicts.text(texts.of("lesson.task") + " " + task.asked().in(texts.locale()), "lesson-asked"), new FlowPane(6, 6, help, begin), hint, verdict);
    }

    Task task() {
        return task;
    }

    /** Whether it is done in the scene there is. */
    boolean isDone() {
        return isDone;
    }

    void show(TaskCheck.State state) {
        isDone = state == TaskCheck.State.DONE;
        switch (state) {
            case DONE -> Verdicts.say(verdict, texts.of("lesson.done") + " " + task.why().in(texts.locale()), true, false);
            case OPEN -> Verdicts.say(verdict, texts.of("lesson.open"), false, false);
            case OTHER_SCENE -> Verdicts.say(verdict, texts.of("lesson.other-scene"), false, false);
        }
    }
}
