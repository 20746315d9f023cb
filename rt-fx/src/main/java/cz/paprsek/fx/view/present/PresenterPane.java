package cz.paprsek.fx.view.present;

import cz.paprsek.asset.Assets;
import cz.paprsek.fx.view.explain.Explained;
import cz.paprsek.fx.view.library.Worker;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.picture.PictureBuffer;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderScene;
import cz.paprsek.render.Tile;
import cz.paprsek.render.explain.text.Outline;
import cz.paprsek.render.explain.text.Step;
import cz.paprsek.render.live.LiveListener;
import cz.paprsek.render.live.LivePass;
import cz.paprsek.render.live.LiveRender;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import javafx.animation.Animation;
import javafx.animation.KeyFrame;
import javafx.animation.Timeline;
import javafx.application.Platform;
import javafx.beans.binding.Bindings;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Label;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.RowConstraints;
import javafx.util.Duration;

/**
 * Why a pixel has its colour, told to a class: its rays come one after the other, by keys or by themselves, each with its exercise in large type. The pixel is one
 * of the full picture, by the numbers that the command line has for it. What the mouse is at, a ray or a line of the exercise, lights up in both.
 */
public final class PresenterPane extends BorderPane {
    private static final Duration EACH = Duration.seconds(3);
    /** Lines of the exercise that fit above each other. */
    private static final double LINES = 40;
    private static final double SMALLEST_TYPE = 17;

    private final Texts texts;
    private final Scene scene;
    private final Assets assets;
    private final PictureBuffer buffer;
    private final RenderSettings settings;
    private final LiveRender live = new LiveRender(Runtime.getRuntime().availableProcessors());
    private final ExecutorService explainer = Worker.named("present-pixel");
    private final CompletableFuture<RenderScene> ready;
    private final StagePicture picture;
    private final Label sum = new Label();
    private final Exercise steps;
    private final PresenterTools tools;
    private final KindBoxes kinds;
    private final Timeline play;
    private Optional<Telling> telling = Optional.empty();
    private Optional<Step> meant = Optional.empty();
    private String light = "";
    private int column;
    private int row;
    /** Counts the pixels asked for. */
    private final AtomicInteger turn = new AtomicInteger();
    private volatile boolean closed;
    private final RenderMonitor whileOpen = new RenderMonitor() {
        @Override
        public boolean cancelled() {
            return closed;
        }
    };

    /**
     * Of a scene as it is now. Nothing runs if the picture is refused.
     *
     * @throws IllegalArgumentException if its picture is too large to be shown
     * @throws ArithmeticException likewise
     * @throws OutOfMemoryError likewise
     */
    public PresenterPane(Scene scene, Assets assets, Texts texts, ObservableValue<Theme> theme) {
        this(scene, assets, texts, theme, new PictureBuffer(scene.settings().width(), scene.settings().height()));
    }

    private PresenterPane(Scene scene, Assets assets, Texts texts, ObservableValue<Theme> theme, PictureBuffer buffer) {
        this.texts = texts;
        this.scene = scene;
        this.assets = assets;
        this.buffer = buffer;
        this.settings = scene.settings();
        setId("present-pane");
        getStylesheets().add(Objects.requireNonNull(PresenterPane.class.getResource("present.css")).toExternalForm());
        picture = new StagePicture(buffer);
        picture.setOnPixel(point -> show((int) point.getX(), (int) point.getY()));
        picture.setOnRay(line -> go(told -> told.go(line.ray())));
        steps = new Exercise(texts, this::mean);
        picture.setOnPointed(steps::point);
        tools = new PresenterTools(texts, this::step);
        kinds = new KindBoxes(texts, theme, this::draw);
        play = new Timeline(new KeyFrame(EACH, event -> step(1)));
        play.setCycleCount(Animation.INDEFINITE);
        tools.playing().selectedProperty().addListener((property, old, now) -> play(now));
        tools.zoomed().selectedProperty().addListener((property, old, now) -> picture.zoom(now));
        tools.blank().selectedProperty().addListener((property, old, now) -> {
            steps.setBlank(now);
            showSum();
        });
        sum.setId("present-sum");
        sum.setWrapText(true);
        sum.setMinHeight(Region.USE_PREF_SIZE);
        setTop(tools);
        setCenter(stage());
        setBottom(kinds);
        addEventFilter(KeyEvent.KEY_PRESSED, this::key);
        styleProperty().bind(Bindings.createStringBinding(() -> "-fx-font-size: " + Math.max(SMALLEST_TYPE, Math.rint(getHeight() / LINES)) + "px", heightProperty()));
        ready = CompletableFuture.supplyAsync(() -> RenderScene.of(scene, assets, whileOpen), explainer);
        live.show(scene, assets, settings, new Painter());
    }

    /** Picture and exercise beside each other, the picture larger. */
    private GridPane stage() {
        GridPane stage = new GridPane();
        for (double share : new double[] {58, 42}) {
            ColumnConstraints constraints = new ColumnConstraints();
            constraints.setPercentWidth(share);
            stage.getColumnConstraints().add(constraints);
        }
        RowConstraints all = new RowConstraints();
        all.setVgrow(Priority.ALWAYS);
        stage.getRowConstraints().addAll(all, new RowConstraints());
        stage.add(picture, 0, 0);
        stage.add(steps, 1, 0);
        stage.add(sum, 0, 1, 2, 1);
        GridPane.setVgrow(steps, Priority.ALWAYS);
        steps.setMaxHeight(Double.MAX_VALUE);
        return stage;
    }

    /** Ends what is being computed. */
    public void close() {
        closed = true;
        turn.incrementAndGet();
        play.stop();
        live.close();
        explainer.shutdownNow();
    }

    /** One of the same pixel in another language, after this one has been closed. */
    public PresenterPane translated(Texts other, ObservableValue<Theme> theme) {
        PresenterPane fresh = new PresenterPane(scene, assets, other, theme, buffer);
        fresh.tools.zoomed().setSelected(tools.zoomed().isSelected());
        fresh.tools.blank().setSelected(tools.blank().isSelected());
        fresh.show(column, row);
        return fresh;
    }

    /** Tells of a pixel of the full picture, counted from 0; one beyond its edge is that at the edge. */
    public void show(int atColumn, int atRow) {
        column = Math.max(0, Math.min(settings.width() - 1, atColumn));
        row = Math.max(0, Math.min(settings.height() - 1, atRow));
        tools.title().setText(texts.of("present.pixel", column, row, settings.width(), settings.height()));
        int mine = turn.incrementAndGet();
        double x = column + 0.5;
        double y = row + 0.5;
        explainer.execute(() -> {
            try {
                if (mine == turn.get()) {
                    Explained explained = Explained.of(new PicturePoint(ready.join(), settings, x, y), whileOpen);
                    Platform.runLater(() -> tell(mine, explained));
                }
            } catch (RuntimeException failed) {
                say(failed);
            }
        });
    }

    /** Tells of the pixel in the middle. */
    public void showMiddle() {
        show(settings.width() / 2, settings.height() / 2);
    }

    /** The pixel that is told of, in words: which, of how large a picture. */
    public String title() {
        return tools.title().getText();
    }

    private void say(Throwable failed) {
        Throwable cause = failed instanceof CompletionException && failed.getCause() != null ? failed.getCause() : failed;
        if (!closed) {
            Platform.runLater(() -> sum.setText(texts.sentence(String.valueOf(cause.getMessage()))));
        }
    }

    private void tell(int mine, Explained explained) {
        if (mine != turn.get()) {
            return;
        }
        light = explained.sum(texts.words());
        showSum();
        telling = explained.size() == 0 ? Optional.empty() : Optional.of(new Telling(scene, Outline.of(explained.ray(explained.typical())).pruned(explained.smallestShare())));
        refresh();
    }

    private void showSum() {
        sum.setText(tools.blank().isSelected() ? texts.of("present.hidden") : light);
    }

    /** Shows the ray that has come. */
    private void refresh() {
        steps.show(telling);
        tools.progress().setText(telling.map(told -> texts.of("present.ray", told.now() + 1, told.rays().size(), told.ray().name(), told.ray().percent(texts.words()))).orElse(""));
    }

    private void go(Consumer<Telling> where) {
        telling.ifPresent(told -> {
            where.accept(told);
            refresh();
        });
    }

    private void step(int rays) {
        go(told -> told.go(told.now() + rays));
        if (telling.map(Telling::isLast).orElse(true)) {
            tools.playing().setSelected(false);
        }
    }

    private void play(boolean on) {
        if (on) {
            if (telling.map(Telling::isLast).orElse(false)) {
                go(told -> told.go(0));
            }
            play.playFromStart();
        } else {
            play.stop();
        }
    }

    /** The line of the exercise whose rays and body light up. */
    private void mean(Optional<Step> step) {
        meant = step;
        draw();
    }

    private void draw() {
        picture.show(telling.map(told -> told.drawn(kinds.hidden())), line -> meant.isPresent() && telling.filter(told -> told.isAbout(line, meant.get().topic())).isPresent(),
                meant.isPresent() ? telling.flatMap(Telling::body) : Optional.empty());
    }

    /** The numbers of the next line; after the last ray's last one, the pixel's. */
    private void askNext() {
        if (!steps.askNext()) {
            sum.setText(light);
        }
    }

    private void key(KeyEvent event) {
        if (event.isShortcutDown() || event.isAltDown()) {
            return;
        }
        if (event.isShiftDown()) {
            switch (event.getCode()) {
                case LEFT -> show(column - 1, row);
                case RIGHT -> show(column + 1, row);
                case UP -> show(column, row - 1);
                case DOWN -> show(column, row + 1);
                default -> {
                    return;
                }
            }
        } else {
            switch (event.getCode()) {
                case RIGHT, PAGE_DOWN -> step(1);
                case LEFT, PAGE_UP -> step(-1);
                case HOME -> go(told -> told.go(0));
                case END -> go(told -> told.go(told.rays().size()));
                case SPACE -> tools.playing().fire();
                case Z -> tools.zoomed().fire();
                case B -> tools.blank().fire();
                case ENTER -> askNext();
                default -> {
                    return;
                }
            }
        }
        event.consume();
    }

    /** Paints coarsely first. */
    private final class Painter implements LiveListener {
        @Override
        public void painted(LivePass pass, Image image, Tile tile) {
            buffer.paint(image, tile, pass.step(), ImageOptions.shown(pass.settings().exposure(), pass.settings().tone()));
        }

        @Override
        public void failed(Throwable fault) {
            say(fault);
        }
    }
}
