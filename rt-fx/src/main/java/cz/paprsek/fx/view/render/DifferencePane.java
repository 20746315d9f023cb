package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.look.Hint;
import cz.paprsek.fx.view.picture.PictureBuffer;
import cz.paprsek.fx.view.picture.PictureView;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageComparison;
import cz.paprsek.image.ImageComparison.Unit;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.image.StoredImage;
import cz.paprsek.image.StoredImage.Precision;
import cz.paprsek.render.Tile;
import java.util.Optional;
import javafx.animation.Animation;
import javafx.animation.KeyFrame;
import javafx.animation.Timeline;
import javafx.application.Platform;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import javafx.util.Duration;

/** How far a picture is from the one that is laid over it, as both are shown: by how much, and, in place of the other one, where. It follows while they are rendered. */
final class DifferencePane extends HBox {
    private static final Duration BETWEEN_LOOKS = Duration.millis(250);

    /** A picture beside which there is another, and what it is called. */
    record Side(String name, PictureBuffer buffer) {}

    private final PictureView view;
    private final Side shown;
    private final Texts texts;
    private final Label figures = new Label();
    private final ToggleButton map = new ToggleButton();
    private final PictureBuffer differences;
    private final Timeline clock = new Timeline(new KeyFrame(BETWEEN_LOOKS, event -> look()));
    private Optional<Side> other = Optional.empty();
    /** What the figures are of. */
    private String compared = "";
    private boolean isWorking;

    DifferencePane(PictureView view, Side shown, Texts texts) {
        super(10);
        this.view = view;
        this.shown = shown;
        this.texts = texts;
        this.differences = new PictureBuffer(shown.buffer().width(), shown.buffer().height());
        map.setText(texts.of("render.difference.map"));
        map.setId("render-difference");
        map.setMinWidth(USE_PREF_SIZE);
        Hint.of(map).set(texts.of("render.difference.hint"));
        map.selectedProperty().addListener((property, old, now) -> show());
        figures.setId("render-difference-figures");
        figures.setWrapText(true);
        figures.setMinHeight(USE_PREF_SIZE);
        clock.setCycleCount(Animation.INDEFINITE);
        setAlignment(Pos.CENTER_LEFT);
        getStyleClass().add("render-status");
        getChildren().addAll(map, figures);
        setVisible(false);
        managedProperty().bind(visibleProperty());
    }

    /** Compares with another picture, or with none. */
    void compare(Optional<Side> wished) {
        other = wished;
        compared = "";
        figures.setText("");
        setVisible(wished.isPresent());
        boolean isAsLarge = wished.filter(side -> side.buffer().width() == differences.width() && side.buffer().height() == differences.height()).isPresent();
        map.setDisable(!isAsLarge);
        if (isAsLarge) {
            look();
            clock.play();
        } else {
            clock.stop();
            map.setSelected(false);
            wished.ifPresent(side -> figures.setText(texts.of("render.difference.sizes")));
        }
        show();
    }

    private void show() {
        boolean isMap = map.isSelected();
        view.compare(other.map(side -> isMap ? differences : side.buffer()), "A  " + shown.name(),
                isMap ? texts.of("render.difference.side") : "B  " + other.map(Side::name).orElse(""));
    }

    /** Compares anew if either has been painted on since. */
    private void look() {
        if (getScene() == null || isWorking) {
            return;
        }
        other.ifPresent(side -> {
            String state = shown.buffer().paints() + " " + side.buffer().paints();
            if (!state.equals(compared)) {
                compared = state;
                isWorking = true;
                RenderDesk.start(() -> work(side), "paprsek-difference");
            }
        });
    }

    private void work(Side side) {
        String text;
        try {
            StoredImage a = stored(shown.buffer());
            StoredImage b = stored(side.buffer());
            double tolerance = Unit.of(a, b).usualTolerance();
            ImageComparison found = ImageComparison.of(a, b, tolerance);
            Image heat = ImageComparison.heatmap(a, b, tolerance);
            differences.paint(heat, new Tile(0, 0, heat.width(), heat.height()), 1, ImageOptions.DEFAULT);
            text = found.largest() == 0 ? texts.of("render.difference.none") : texts.of("render.difference.figures",
                    number("%.0f", found.largest()), found.x(), found.y(), number("%.3f", found.mean()), number("%.2f", 100 * found.shareBeyond()));
        } catch (OutOfMemoryError exhausted) {
            text = texts.of("render.too-large", differences.width(), differences.height());
        }
        String figure = text;
        Platform.runLater(() -> {
            isWorking = false;
            if (other.filter(side::equals).isPresent()) {
                figures.setText(figure);
            }
        });
    }

    /** As a file of it would be read. */
    private static StoredImage stored(PictureBuffer buffer) {
        return new StoredImage(buffer.shown(), Precision.EIGHT_BIT, false);
    }

    private String number(String format, double value) {
        return String.format(texts.locale(), format, value);
    }
}
