package cz.paprsek.fx.view.mistakes;

import cz.paprsek.fx.view.library.Worker;
import cz.paprsek.fx.view.picture.PictureBuffer;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageComparison;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.StoredImage;
import cz.paprsek.render.Tile;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.teach.Beside;
import cz.paprsek.teach.PlainTracer;
import cz.paprsek.teach.mistake.Mistake;
import cz.paprsek.teach.mistake.Mistakes;
import cz.paprsek.words.Words;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javafx.animation.PauseTransition;
import javafx.application.Platform;
import javafx.collections.ListChangeListener;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.SelectionMode;
import javafx.scene.control.TextArea;
import javafx.scene.image.ImageView;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import javafx.util.Duration;

/** A list of mistakes, and of those chosen the wrong picture beside the right one, where they differ, and the numbers of a pixel that is clicked. */
public final class MistakesPane extends BorderPane {
    /** Pictures that are no wider and no higher come first, so that each mistake shows at once. */
    private static final int FIRST = 320;
    /** By how much pictures become larger where the window has room, rather than with each pixel of it. */
    private static final int STEP = 80;
    private static final double LIST_WIDTH = 230;
    /** What stands beside three pictures in a row, and what stands above and below them, in pixels. */
    private static final double BESIDE = LIST_WIDTH + 45;
    private static final double ABOVE_AND_BELOW = 300;
    private static final double TOLERANCE = 2;

    private final Scene scene;
    private final Texts texts;
    private final ExecutorService worker = Worker.named("mistakes");
    private final ListView<Mistake> list = new ListView<>();
    private final ImageView right = view("mistakes-right");
    private final ImageView wrong = view("mistakes-wrong");
    private final ImageView difference = view("mistakes-difference");
    private final Label lines = new Label();
    private final TextArea numbers = new TextArea();
    /** Counts what has been chosen. */
    private final AtomicInteger turn = new AtomicInteger();
    private final PauseTransition resized = new PauseTransition(Duration.millis(150));
    /** How large pictures are shown. */
    private RenderSettings shown;

    /** Of a scene as it is now. */
    public MistakesPane(Scene scene, Texts texts) {
        this.scene = scene;
        this.texts = texts;
        this.shown = within(FIRST);
        setId("mistakes-pane");
        lines.setId("mistakes-lines");
        lines.setWrapText(true);
        numbers.setId("mistakes-numbers");
        numbers.setEditable(false);
        numbers.setStyle("-fx-font-family: monospace; -fx-prompt-text-fill: -color-fg-muted");
        numbers.setPromptText(texts.of("mistakes.click"));
        VBox.setVgrow(numbers, Priority.ALWAYS);
        FlowPane pictures = new FlowPane(10, 10, captioned(texts.words().of("beside.right"), right), captioned(texts.words().of("beside.wrong"), wrong),
                captioned(texts.of("mistakes.difference"), difference));
        VBox content = new VBox(10, lines, pictures, numbers);
        content.setStyle("-fx-padding: 10");
        List<String> unknown = PlainTracer.unknown(scene, shown);
        if (!unknown.isEmpty()) {
            lines.setText(texts.of("mistakes.unknown", unknown.stream().map(texts.words()::name).collect(Collectors.joining(", "))));
            content.getChildren().setAll(lines);
            setCenter(content);
            return;
        }
        // The keyboard comes to the list first: to the numbers, which say how they are had, when it has chosen.
        setLeft(list);
        setCenter(content);
        fillList();
        compute(List.of());
        resized.setOnFinished(event -> fit());
        widthProperty().addListener(property -> resized.playFromStart());
        heightProperty().addListener(property -> resized.playFromStart());
    }

    /** The scene's pictures with one ray for each pixel, and no side longer than this. */
    private RenderSettings within(int side) {
        RenderSettings full = scene.settings();
        double scale = Math.min(1, side / (double) Math.max(full.width(), full.height()));
        return full.withSize(Math.max(1, (int) (scale * full.width())), Math.max(1, (int) (scale * full.height()))).withSamples(1);
    }

    /** Makes the pictures as large as three of them have room beside each other. */
    private void fit() {
        RenderSettings full = scene.settings();
        double longer = Math.max(full.width(), full.height());
        double side = Math.min((getWidth() - BESIDE) / 3 * longer / full.width(), (getHeight() - ABOVE_AND_BELOW) * longer / full.height());
        int steps = (int) (side / STEP);
        RenderSettings now = within(Math.max(FIRST, steps * STEP));
        if (now.width() != shown.width() || now.height() != shown.height()) {
            shown = now;
            List.of(right, wrong, difference).forEach(view -> view.setFitWidth(now.width()));
            compute(List.copyOf(list.getSelectionModel().getSelectedItems()));
        }
    }

    private void fillList() {
        list.setId("mistakes-list");
        list.setPrefWidth(LIST_WIDTH);
        list.setCellFactory(view -> new MistakeCell(texts));
        list.getSelectionModel().setSelectionMode(SelectionMode.MULTIPLE);
        list.getItems().setAll(Mistake.values());
        list.getSelectionModel().getSelectedItems().addListener((ListChangeListener<Mistake>) change -> choose(List.copyOf(list.getSelectionModel().getSelectedItems())));
        lines.setText(texts.of("mistakes.choose"));
    }

    /** Ends what is being computed. */
    public void close() {
        resized.stop();
        turn.incrementAndGet();
        worker.shutdown();
    }

    private void choose(List<Mistake> made) {
        Words words = texts.words();
        lines.setText(made.stream().map(mistake -> mistake.meaning(words) + ":   " + mistake.wrong(words) + "   (" + words.of("beside.right") + ":   " + mistake.right(words) + ")")
                .collect(Collectors.joining("\n")));
        numbers.clear();
        compute(made);
    }

    private void compute(List<Mistake> made) {
        int mine = turn.incrementAndGet();
        List<RenderSettings> sizes = Stream.of(within(FIRST), shown).distinct().toList();
        worker.execute(() -> sizes.forEach(settings -> compute(mine, made, settings)));
    }

    /** On the worker's thread; gives up as soon as something else has been chosen. */
    private void compute(int mine, List<Mistake> made, RenderSettings settings) {
        try {
            Image good = PlainTracer.of(scene, settings, Mistakes.NONE).render(() -> turn.get() != mine);
            Image bad = made.isEmpty() ? good : PlainTracer.of(scene, settings, Mistakes.of(made)).render(() -> turn.get() != mine);
            Image heat = ImageComparison.heatmap(eightBit(good), eightBit(bad), TOLERANCE);
            Platform.runLater(() -> {
                if (turn.get() == mine) {
                    show(good, right);
                    show(bad, wrong);
                    show(heat, difference);
                }
            });
        } catch (CancellationException other) {
            // Something else has been chosen, and will be computed.
        }
    }

    private static StoredImage eightBit(Image image) {
        return new StoredImage(image, StoredImage.Precision.EIGHT_BIT, false);
    }

    private static void show(Image image, ImageView view) {
        PictureBuffer buffer = new PictureBuffer(image.width(), image.height());
        buffer.paint(image, new Tile(0, 0, image.width(), image.height()), 1, ImageOptions.DEFAULT);
        view.setImage(buffer.image());
    }

    private ImageView view(String id) {
        ImageView view = new ImageView();
        view.setId(id);
        view.setPreserveRatio(true);
        view.setOnMouseClicked(event -> tell((int) event.getX(), (int) event.getY()));
        return view;
    }

    /** The numbers are those of the pixel of the full picture that lies there, as the command line has them. */
    private void tell(int column, int row) {
        List<Mistake> made = list.getSelectionModel().getSelectedItems();
        if (column >= 0 && row >= 0 && column < shown.width() && row < shown.height()) {
            RenderSettings full = scene.settings().withSamples(1);
            int fullColumn = (int) ((column + 0.5) * full.width() / shown.width());
            int fullRow = (int) ((row + 0.5) * full.height() / shown.height());
            numbers.setText(String.join("\n", new Beside(scene, full, Mistakes.of(made), fullColumn, fullRow).lines(texts.words())));
        }
    }

    private static VBox captioned(String caption, ImageView picture) {
        return new VBox(4, new Label(caption), picture);
    }
}
