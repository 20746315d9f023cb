package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.texts.Texts;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.animation.Animation;
import javafx.animation.KeyFrame;
import javafx.animation.Timeline;
import javafx.beans.InvalidationListener;
import javafx.beans.WeakInvalidationListener;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.ProgressBar;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import javafx.util.Duration;

/** The pictures that are rendered one after the other: how far each is; those that wait are put earlier or later, and all can be cancelled. */
final class QueuePane extends VBox {
    private static final Duration BETWEEN_UPDATES = Duration.millis(250);
    private static final double WIDTH = 270;
    private static final double CELL = 62;

    private final RenderDesk desk;
    private final Texts texts;
    private final Consumer<RenderTask> onChosen;
    private final ListView<RenderTask> list;
    private final Timeline clock;
    /** Held here, because the desk, which outlives the pane, holds it weakly. */
    private final InvalidationListener onQueue = queue -> follow();

    /** @param onChosen is told which picture is to be shown */
    QueuePane(RenderDesk desk, Texts texts, Consumer<RenderTask> onChosen) {
        super(6);
        this.desk = desk;
        this.texts = texts;
        this.onChosen = onChosen;
        this.list = new ListView<>(desk.queue());
        this.clock = new Timeline(new KeyFrame(BETWEEN_UPDATES, event -> list.refresh()));
        clock.setCycleCount(Animation.INDEFINITE);
        setId("render-queue");
        getStyleClass().add("render-queue");
        setMinWidth(WIDTH);
        setPrefWidth(WIDTH);
        list.setId("render-queue-list");
        list.setAccessibleText(texts.of("render.queue"));
        list.setFixedCellSize(CELL);
        list.setPlaceholder(new Label(texts.of("render.queue.empty")));
        list.setCellFactory(view -> new Cell());
        VBox.setVgrow(list, Priority.ALWAYS);
        list.setOnMouseClicked(event -> selected().ifPresent(onChosen));
        list.addEventFilter(KeyEvent.KEY_PRESSED, this::key);
        HBox buttons = new HBox(6, button("render.queue.up", () -> move(-1), can(-1)), button("render.queue.down", () -> move(1), can(1)),
                button("render.queue.cancel", this::cancel, Bindings.isNull(list.getSelectionModel().selectedItemProperty()).not()));
        getChildren().addAll(new Label(texts.of("render.queue")), list, buttons);
        visibleProperty().addListener((property, old, now) -> follow());
        desk.queue().addListener(new WeakInvalidationListener(onQueue));
        follow();
    }

    /** Follows what is under way only while that can be seen. */
    private void follow() {
        if (isVisible() && !desk.queue().isEmpty()) {
            clock.play();
        } else {
            clock.stop();
        }
    }

    private BooleanBinding can(int by) {
        return Bindings.createBooleanBinding(() -> selected().filter(task -> desk.canMove(task, by)).isPresent(), list.getSelectionModel().selectedItemProperty(), desk.queue());
    }

    private Button button(String key, Runnable action, BooleanBinding possible) {
        Button button = new Button(texts.of(key));
        button.setId(key.replace('.', '-'));
        button.setMinWidth(USE_PREF_SIZE);
        button.disableProperty().bind(possible.not());
        button.setOnAction(event -> action.run());
        return button;
    }

    private void key(KeyEvent event) {
        if (event.isAltDown() && (event.getCode() == KeyCode.UP || event.getCode() == KeyCode.DOWN)) {
            move(event.getCode() == KeyCode.UP ? -1 : 1);
        } else if (event.getCode() == KeyCode.DELETE) {
            cancel();
        } else if (event.getCode() == KeyCode.ENTER) {
            selected().ifPresent(onChosen);
        } else {
            return;
        }
        event.consume();
    }

    private void move(int by) {
        selected().ifPresent(task -> {
            desk.move(task, by);
            list.getSelectionModel().select(task);
        });
    }

    private void cancel() {
        selected().ifPresent(RenderTask::cancel);
    }

    private Optional<RenderTask> selected() {
        return Optional.ofNullable(list.getSelectionModel().getSelectedItem());
    }

    /** One picture: what it is, and how far. */
    private final class Cell extends ListCell<RenderTask> {
        private final Label title = new Label();
        private final Label state = new Label();
        private final ProgressBar bar = new ProgressBar();
        private final VBox content = new VBox(3, title, state, bar);

        Cell() {
            setPrefWidth(0);
            bar.setMaxWidth(Double.MAX_VALUE);
            state.getStyleClass().add("render-queue-state");
        }

        @Override
        protected void updateItem(RenderTask task, boolean empty) {
            super.updateItem(task, empty);
            setGraphic(empty || task == null ? null : content);
            if (!empty && task != null) {
                RenderProgress now = task.progress();
                title.setText(task.title());
                state.setText(new RenderStatus(texts).inShort(task.getState(), now));
                bar.setProgress(now.share());
            }
        }
    }
}
