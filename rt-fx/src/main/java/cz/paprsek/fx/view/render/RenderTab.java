package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.picture.PictureView;
import cz.paprsek.fx.view.picture.PixelText;
import cz.paprsek.fx.view.render.DifferencePane.Side;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.Tile;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.animation.Animation;
import javafx.animation.KeyFrame;
import javafx.animation.Timeline;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.value.ChangeListener;
import javafx.concurrent.Worker;
import javafx.geometry.Point2D;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ProgressBar;
import javafx.scene.control.Tab;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.util.Duration;

/** One render: its picture, how far it is, and what the mouse points at. */
final class RenderTab extends Tab {
    /** So narrow may what is told of a render be, pixels. */
    private static final double LEAST_TEXT = 90;

    private static final Duration BETWEEN_UPDATES = Duration.millis(100);

    private final Texts texts;
    private final PictureView view;
    private final ProgressBar bar = new ProgressBar(0);
    private final Label progress = new Label();
    private final Label pixel = new Label();
    private final ToggleButton before = new ToggleButton();
    private final Button cancel;
    private final Button goOn;
    private final BorderPane content;
    private final DifferencePane difference;
    private final PixelText pixelText;
    private final ModeValue value;
    private final Timeline clock = new Timeline(new KeyFrame(BETWEEN_UPDATES, event -> update()));
    private final ReadOnlyObjectWrapper<Optional<PicturePoint>> pointed = new ReadOnlyObjectWrapper<>(Optional.empty());

    private final ChangeListener<Worker.State> onState = (property, old, now) -> follow(now);
    private RenderTask task;
    private Optional<RenderTab> compared = Optional.empty();

    /** @param desk where it is rendered, also if it goes on after it was cancelled */
    RenderTab(RenderTask task, RenderDesk desk, Texts texts) {
        super(task.title());
        this.texts = texts;
        this.task = task;
        Tile part = task.options().region();
        this.view = new PictureView(task.buffer());
        view.setTransparent(task.options().transparent());
        view.setOrigin(part.x(), part.y());
        pixelText = new PixelText(texts);
        value = new ModeValue(texts, task.options());
        difference = new DifferencePane(view, new Side(task.title(), task.buffer()), texts);
        view.pointedProperty().addListener((property, old, now) -> pointed.set(now.flatMap(this::point)));
        pointed.addListener((property, old, now) -> tell(now));
        cancel = button("render.cancel", () -> this.task.cancel());
        goOn = button("render.go-on", () -> goOn(desk));
        bar.setId("render-progress");
        progress.setId("render-status");
        // Beside an explanation and the queue there may be no room for it in one line.
        progress.setWrapText(true);
        progress.setMinSize(LEAST_TEXT, Region.USE_PREF_SIZE);
        pixel.setId("pixel-text");
        pixel.getStyleClass().add("pixel-text");
        pixel.setWrapText(true);
        // Once it needed two lines it keeps them, so that the picture does not jump while the mouse goes over it.
        pixel.heightProperty().addListener((property, old, now) -> pixel.setMinHeight(now.doubleValue()));
        pixel.widthProperty().addListener(property -> pixel.setMinHeight(Region.USE_PREF_SIZE));
        before.setText(texts.of("render.before"));
        before.setId("render-before");
        before.setMinWidth(Region.USE_PREF_SIZE);
        Hint.of(before).set(texts.of("render.before.hint"));
        before.selectedProperty().addListener((property, old, now) -> showCompared());
        before.setDisable(true);
        before.setVisible(task.noisy().isPresent());
        before.managedProperty().bind(before.visibleProperty());
        HBox status = new HBox(10, cancel, goOn, bar, progress, before);
        status.setAlignment(Pos.CENTER_LEFT);
        status.getStyleClass().add("render-status");
        VBox bottom = new VBox();
        task.options().mode().scale().ifPresent(scale -> bottom.getChildren().add(new ScaleStrip(scale)));
        bottom.getChildren().addAll(pixel, difference, status);
        content = new BorderPane(view, null, null, bottom, null);
        setContent(content);
        clock.setCycleCount(Animation.INDEFINITE);
        watch();
    }

    private Button button(String key, Runnable action) {
        Button button = new Button(texts.of(key));
        button.setId(key.replace('.', '-'));
        button.setMinWidth(Region.USE_PREF_SIZE);
        button.managedProperty().bind(button.visibleProperty());
        button.setOnAction(event -> action.run());
        return button;
    }

    RenderTask task() {
        return task;
    }

    /** Another tab shows the picture from now on: nothing goes on here. */
    void release() {
        task.stateProperty().removeListener(onState);
        clock.stop();
        difference.compare(Optional.empty());
    }

    /** Ends all that runs for it. */
    void close() {
        task.giveUp();
        difference.compare(Optional.empty());
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
        difference.compare(before.isSelected() ? task.noisy().map(buffer -> new Side(texts.of("render.before"), buffer))
                : compared.map(tab -> new Side(tab.task.title(), tab.task.buffer())));
    }

    /** How far it is, or how it ended, in words. */
    ReadOnlyStringProperty statusProperty() {
        return progress.textProperty();
    }

    void setOnClicked(Consumer<PicturePoint> listener) {
        view.setOnClicked(at -> point(at).ifPresent(listener));
    }

    private Optional<PicturePoint> point(Point2D at) {
        Tile part = task.options().region();
        return task.prepared().map(scene -> new PicturePoint(scene, task.options().settings(), part.x() + at.getX(), part.y() + at.getY()));
    }

    /** Tells what is under the mouse; where colours stand for numbers, these as soon as they are known. */
    private void tell(Optional<PicturePoint> point) {
        value.stop();
        boolean isNumber = ModeValue.isOf(task.options().mode());
        pixel.setText(point.flatMap(at -> text(at, isNumber ? Optional.of("…") : Optional.empty())).orElse(""));
        point.filter(at -> isNumber).ifPresent(at -> value.ask(at, words -> pixel.setText(text(at, Optional.of(words)).orElse(""))));
    }

    private Optional<String> text(PicturePoint point, Optional<String> words) {
        return task.image().map(image -> pixelText.of(point, image, task.options().region(), task.how(), words));
    }

    /** Goes on where it was cancelled. */
    private void goOn(RenderDesk desk) {
        task.stateProperty().removeListener(onState);
        task = task.goOn();
        watch();
        desk.add(task);
    }

    private void watch() {
        task.stateProperty().addListener(onState);
        follow(task.getState());
    }

    private void follow(Worker.State state) {
        boolean hadKeys = cancel.isFocused() || goOn.isFocused();
        goOn.setVisible(state == Worker.State.CANCELLED || state == Worker.State.FAILED);
        if (hadKeys) {
            // Whoever has cancelled by the keyboard goes on by it.
            (goOn.isVisible() ? goOn : view).requestFocus();
        }
        cancel.setVisible(!goOn.isVisible());
        cancel.setDisable(task.isOver());
        if (state == Worker.State.RUNNING) {
            clock.play();
        } else if (task.isOver()) {
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
