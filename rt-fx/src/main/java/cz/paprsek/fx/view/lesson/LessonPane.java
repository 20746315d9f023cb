package cz.paprsek.fx.view.lesson;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.library.Worker;
import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.lesson.Lesson;
import cz.paprsek.lesson.Lesson.Formula;
import cz.paprsek.lesson.Lesson.Look;
import cz.paprsek.lesson.Lesson.Paragraph;
import cz.paprsek.lesson.Lesson.Part;
import cz.paprsek.lesson.Lessons;
import cz.paprsek.lesson.Question;
import cz.paprsek.lesson.Task;
import cz.paprsek.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.function.BiConsumer;
import java.util.function.IntConsumer;
import javafx.application.Platform;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.WeakChangeListener;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/** A lesson: what is told, its questions and its tasks, one below the other. */
public final class LessonPane extends BorderPane {
    /** What a hint takes, pixels. */
    private static final double HINT = 90;

    private final Lesson lesson;
    private final LessonDesk desk;
    private final EditorModel model;
    private final Texts texts;
    private final BiConsumer<Integer, Integer> onLook;
    private final ExecutorService worker = Worker.named("lesson-answers");
    private final List<TaskCheck> checks = new ArrayList<>();
    private final List<TaskBox> tasks = new ArrayList<>();
    private final Label progress = new Label();
    private IntConsumer goOn = number -> {};
    /** Held here, because the model, which outlives the pane, holds it weakly. */
    private final ChangeListener<Scene> onScene = (property, old, now) -> lookAtTasks();
    private final WeakChangeListener<Scene> weak = new WeakChangeListener<>(onScene);

    /** @param onLook explains a pixel of the scene's picture, by column and row */
    public LessonPane(Lesson lesson, LessonDesk desk, EditorModel model, Texts texts, BiConsumer<Integer, Integer> onLook) {
        this.lesson = lesson;
        this.desk = desk;
        this.model = model;
        this.texts = texts;
        this.onLook = onLook;
        setId("lesson-pane");
        getStylesheets().add(Objects.requireNonNull(LessonPane.class.getResource("lesson.css")).toExternalForm());
        setMinWidth(260);
        setTop(top());
        VBox content = new VBox();
        content.setId("lesson-content");
        for (int i = 0; i < lesson.parts().size(); i++) {
            content.getChildren().add(node(i, lesson.parts().get(i)));
        }
        ScrollPane scroll = new ScrollPane(content);
        scroll.setId("lesson-scroll");
        scroll.setFitToWidth(true);
        scroll.setHbarPolicy(ScrollPane.ScrollBarPolicy.NEVER);
        scroll.setFocusTraversable(false);
        // What the keyboard comes to is brought into sight.
        content.getChildren().forEach(part -> part.focusWithinProperty().addListener((property, old, now) -> {
            if (now) {
                reveal(scroll, content, part);
            }
        }));
        setCenter(scroll);
        goOn = number -> revealAfter(scroll, content, number);
        model.sceneProperty().addListener(weak);
        showProgress();
        lookAtTasks();
    }

    private VBox top() {
        int place = lesson.isShipped() ? Lessons.NAMES.indexOf(lesson.name()) : -1;
        Label title = Verdicts.text((place < 0 ? "" : (place + 1) + ". ") + lesson.title().in(texts.locale()), "lesson-title");
        title.setId("lesson-title");
        title.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(title, Priority.ALWAYS);
        progress.setId("lesson-progress");
        Region space = new Region();
        HBox.setHgrow(space, Priority.ALWAYS);
        HBox line = new HBox(6, progress, space, button("lesson.previous", "←", () -> desk.open(Lessons.NAMES.get(place - 1)), place > 0),
                button("lesson.next", "→", () -> desk.open(Lessons.NAMES.get(place + 1)), place >= 0 && place + 1 < Lessons.NAMES.size()),
                button("lesson.close", "✕", desk::close, true));
        // Below a title of two lines the buttons would not be where the last click was.
        VBox top = new VBox(4, line, title);
        top.setId("lesson-top");
        return top;
    }

    private Button button(String key, String sign, Runnable action, boolean isEnabled) {
        Button button = new Button(sign);
        button.setId(key.replace('.', '-'));
        Hint.of(button).set(texts.of(key));
        button.setAccessibleText(texts.of(key));
        button.setDisable(!isEnabled);
        button.setOnAction(event -> action.run());
        return button;
    }

    private Node node(int number, Part part) {
        if (part instanceof Paragraph paragraph) {
            return Verdicts.text(paragraph.text().in(texts.locale()), "lesson-text");
        }
        if (part instanceof Formula formula) {
            Label label = Verdicts.text(formula.text().in(texts.locale()), "lesson-formula");
            label.setMaxWidth(Double.MAX_VALUE);
            return label;
        }
        if (part instanceof Look look) {
            return look(number, look);
        }
        return part instanceof Question question ? question(number, question) : task(number, (Task) part);
    }

    private VBox look(int number, Look look) {
        Button button = new Button(texts.of("lesson.look", look.column(), look.row()));
        button.setId("lesson-look-" + number);
        button.setOnAction(event -> onLook.accept(look.column(), look.row()));
        return new VBox(4, Verdicts.text(look.text().in(texts.locale()), "lesson-text"), button);
    }

    private QuestionBox question(int number, Question question) {
        QuestionBox box = new QuestionBox(number, question, CompletableFuture.supplyAsync(() -> Lessons.answer(lesson, question), worker), texts, onLook, right -> done(number));
        box.recall(desk.typed(lesson, number));
        box.field().textProperty().addListener((property, old, now) -> desk.type(lesson, number, now));
        return box;
    }

    private TaskBox task(int number, Task task) {
        TaskBox box = new TaskBox(number, task, texts, () -> {
            // What has been built in several steps is not lost by a click beside the hint.
            if (desk.begin(lesson, tasks.stream().anyMatch(TaskBox::isDone))) {
                lookAtTasks();
            }
        });
        tasks.add(box);
        checks.add(new TaskCheck());
        return box;
    }

    private void lookAtTasks() {
        for (int i = 0; i < tasks.size(); i++) {
            TaskBox box = tasks.get(i);
            if (desk.isSceneOpen()) {
                checks.get(i).look(box.task(), model.scene(), model.assets(), state -> {
                    box.show(state);
                    if (state == TaskCheck.State.DONE) {
                        taskDone(lesson.parts().indexOf(box.task()));
                    }
                });
            } else {
                checks.get(i).cancel();
                box.show(TaskCheck.State.OTHER_SCENE);
            }
        }
    }

    /** Whoever has done what was asked sees what is asked next, when the verdict has made its room. */
    private void taskDone(int number) {
        boolean isNew = !desk.isDone(lesson, number);
        done(number);
        if (isNew && number + 1 < lesson.parts().size()) {
            Platform.runLater(() -> Platform.runLater(() -> goOn.accept(number)));
        }
    }

    private void done(int number) {
        desk.markDone(lesson, number);
        showProgress();
    }

    private void showProgress() {
        progress.setText(texts.of("lesson.progress", desk.done(lesson), lesson.questions().size() + lesson.tasks().size()));
    }

    private static void reveal(ScrollPane scroll, VBox content, Node part) {
        double view = scroll.getViewportBounds().getHeight();
        double room = content.getHeight() - view;
        if (room <= 0) {
            return;
        }
        double from = scroll.getVvalue() * room;
        double top = part.getBoundsInParent().getMinY();
        double bottom = part.getBoundsInParent().getMaxY();
        if (top < from) {
            scroll.setVvalue(top / room);
        } else if (bottom > from + view) {
            scroll.setVvalue(Math.min(top, bottom - view) / room);
        }
    }

    /** What comes after a part, with room for its hint, below that part. */
    private static void revealAfter(ScrollPane scroll, VBox content, int number) {
        double view = scroll.getViewportBounds().getHeight();
        double room = content.getHeight() - view;
        double end = content.getChildren().get(number + 1).getBoundsInParent().getMaxY() + HINT;
        if (room > 0 && end > scroll.getVvalue() * room + view) {
            double top = content.getChildren().get(number).getBoundsInParent().getMinY();
            scroll.setVvalue(Math.min(top, room) / room);
        }
    }

    /** Ends what is being computed, and follows the scene no more. */
    public void close() {
        model.sceneProperty().removeListener(weak);
        checks.forEach(TaskCheck::close);
        worker.shutdown();
    }
}
