package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.picture.PictureView;
import cz.paprsek.fx.view.picture.PixelText;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.render.RenderResult;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.animation.Animation;
import javafx.animation.KeyFrame;
import javafx.animation.Timeline;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.concurrent.Worker;
import javafx.geometry.Point2D;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressBar;
import javafx.scene.control.Tab;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.util.Duration;

/** One render: its picture, how far it is, and what the mouse points at. */
final class RenderTab extends Tab {
    private static final Duration BETWEEN_UPDATES = Duration.millis(100);

    private final Texts texts;
    private final RenderTask task;
    private final PictureView view;
    private final ProgressBar bar = new ProgressBar(0);
    private final Label progress = new Label();
    private final Label pixel = new Label();
    private final ToggleButton before = new ToggleButton();
    private final BorderPane content;
    private final Timeline clock = new Timeline(new KeyFrame(BETWEEN_UPDATES, event -> update()));
    private final ReadOnlyObjectWrapper<Optional<PicturePoint>> pointed = new ReadOnlyObjectWrapper<>(Optional.empty());

    private Optional<RenderTab> compared = Optional.empty();

    RenderTab(String title, RenderTask task, Texts texts) {
        super(title);
        this.texts = texts;
        this.task = task;
        this.view = new PictureView(task.buffer());
        view.setTransparent(task.options().transparent());
        PixelText pixelText = new PixelText(texts);
        view.pointedProperty().addListener((property, old, now) -> pointed.set(now.flatMap(this::point)));
        pointed.addListener((property, old, now) -> pixel.setText(now.flatMap(point -> task.image().map(image -> pixelText.of(point, image, task.how()))).orElse("")));
        Button cancel = new Button(texts.of("render.cancel"));
        cancel.setId("render-cancel");
        cancel.setOnAction(event -> task.cancel());
        cancel.disableProperty().bind(task.runningProperty().not());
        bar.setId("render-progress");
        progress.setId("render-status");
        progress.setMinWidth(Region.USE_PREF_SIZE);
        pixel.setId("pixel-text");
        HBox.setHgrow(pixel, Priority.ALWAYS);
        pixel.setMaxWidth(Double.MAX_VALUE);
        pixel.setAlignment(Pos.CENTER_RIGHT);
        before.setText(texts.of("render.before"));
        before.setId("render-before");
        before.setMinWidth(Region.USE_PREF_SIZE);
        before.setTooltip(new Tooltip(texts.of("render.before.hint")));
        before.selectedProperty().addListener((property, old, now) -> showCompared());
        before.setDisable(true);
        before.setVisible(task.noisy().isPresent());
        before.managedProperty().bind(before.visibleProperty());
        HBox status = new HBox(10, cancel, bar, progress, before, pixel);
        status.setAlignment(Pos.CENTER_LEFT);
        status.getStyleClass().add("render-status");
        VBox bottom = new VBox();
        task.options().mode().scale().ifPresent(scale -> bottom.getChildren().add(new ScaleStrip(scale)));
        bottom.getChildren().add(status);
        content = new BorderPane(view, null, null, bottom, null);
        setContent(content);
        setOnClosed(event -> task.cancel());
        clock.setCycleCount(Animation.INDEFINITE);
        task.stateProperty().addListener((property, old, now) -> follow(now));
        follow(task.getState());
    }

    RenderTask task() {
        return task;
    }

    PictureView view() {
        return view;
    }

    /** Where in the picture the mouse is; empty beside it. */
    ReadOnlyObjectProperty<Optional<PicturePoint>> pointedProperty() {
        return pointed.getReadOnlyProperty();
    }

    /** The render that is laid over the right part of this one. */
    Optional<RenderTab> comparedWith() {
        return compared;
    }

    void compareWith(Optional<RenderTab> other) {
        if (!other.equals(compared)) {
            compared = other;
            before.setSelected(false);
        }
        showCompared();
    }

    private void showCompared() {
        view.compare(before.isSelected() ? task.noisy() : compared.map(tab -> tab.task.buffer()));
    }

    /** How far it is, or how it ended, in words. */
    ReadOnlyStringProperty statusProperty() {
        return progress.textProperty();
    }

    void setOnClicked(Consumer<PicturePoint> listener) {
        view.setOnClicked(at -> point(at).ifPresent(listener));
    }

    private Optional<PicturePoint> point(Point2D at) {
        return task.prepared().map(scene -> new PicturePoint(scene, task.options().settings(), at.getX(), at.getY()));
    }

    private void follow(Worker.State state) {
        if (state == Worker.State.RUNNING) {
            clock.play();
        } else if (task.isDone()) {
            clock.stop();
            before.setDisable(state != Worker.State.SUCCEEDED);
            task.mixer().filter(mixer -> state == Worker.State.SUCCEEDED).ifPresent(mixer -> content.setRight(new MixPane(task.subject().whole(), mixer, texts)));
        }
        update();
    }

    private void update() {
        RenderProgress now = task.progress();
        bar.setProgress(now.share());
        progress.setText(new RenderStatus(texts).of(task.getState(), now, Optional.ofNullable(task.getValue()).flatMap(RenderResult::certainty), Optional.ofNullable(task.getException())));
    }
}
