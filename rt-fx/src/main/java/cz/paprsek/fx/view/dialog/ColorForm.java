package cz.paprsek.fx.view.dialog;

import cz.paprsek.fx.view.texts.Texts;
import java.util.List;
import java.util.stream.IntStream;
import javafx.geometry.Insets;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.layout.GridPane;
import javafx.scene.paint.Color;
import javafx.scene.paint.CycleMethod;
import javafx.scene.paint.LinearGradient;
import javafx.scene.paint.Stop;
import javafx.scene.shape.Rectangle;
import javafx.scene.shape.StrokeType;

/** A colour by hue, saturation and brightness: a slider for each, above it what it would lead to. */
final class ColorForm extends GridPane {
    private static final double WIDTH = 320;
    private static final int STOPS = 12;

    private final Slider hue;
    private final Slider saturation;
    private final Slider brightness;
    private final Rectangle shown = bordered(40);

    ColorForm(Color start, Texts texts) {
        setPadding(new Insets(10, 4, 0, 10));
        setHgap(8);
        setVgap(4);
        hue = slider("color.hue", 360, start.getHue(), texts, 0);
        saturation = slider("color.saturation", 100, 100 * start.getSaturation(), texts, 1);
        brightness = slider("color.brightness", 100, 100 * start.getBrightness(), texts, 2);
        List<Slider> all = List.of(hue, saturation, brightness);
        List<Rectangle> ways = IntStream.range(0, all.size()).mapToObj(i -> bordered(8)).toList();
        for (int i = 0; i < all.size(); i++) {
            add(ways.get(i), 1, 2 * i);
            all.get(i).valueProperty().addListener(property -> show(ways));
        }
        shown.setId("color-shown");
        add(shown, 1, 2 * all.size());
        show(ways);
    }

    /** White on a light window and black on a dark one are seen by it. */
    private static Rectangle bordered(double height) {
        Rectangle fresh = new Rectangle(WIDTH, height);
        fresh.setStroke(Color.GRAY);
        fresh.setStrokeType(StrokeType.INSIDE);
        return fresh;
    }

    private Slider slider(String name, double most, double value, Texts texts, int row) {
        Slider slider = new Slider(0, most, value);
        slider.setId(name.replace('.', '-'));
        slider.setBlockIncrement(1);
        slider.setPrefWidth(WIDTH);
        Label label = new Label(texts.of(name));
        label.setLabelFor(slider);
        slider.setAccessibleText(label.getText());
        Label number = new Label();
        number.setMinWidth(44);
        number.setAlignment(Pos.CENTER_RIGHT);
        number.textProperty().bind(slider.valueProperty().asString(texts.locale(), most > 100 ? "%.0f°" : "%.0f %%"));
        addRow(2 * row + 1, label, slider, number);
        return slider;
    }

    /** What has been chosen. */
    Color color() {
        return Color.hsb(hue.getValue(), saturation.getValue() / 100, brightness.getValue() / 100);
    }

    private void show(List<Rectangle> ways) {
        shown.setFill(color());
        for (int way = 0; way < ways.size(); way++) {
            int which = way;
            ways.get(way).setFill(new LinearGradient(0, 0, 1, 0, true, CycleMethod.NO_CYCLE,
                    IntStream.rangeClosed(0, STOPS).mapToObj(i -> new Stop((double) i / STOPS, at(which, (double) i / STOPS))).toList()));
        }
    }

    /** The colour with a slider elsewhere; hues pure, or they could not be told apart where it is black, white or grey. */
    private Color at(int way, double share) {
        return way == 0 ? Color.hsb(360 * share, 1, 1)
                : Color.hsb(hue.getValue(), way == 1 ? share : saturation.getValue() / 100, way == 2 ? share : brightness.getValue() / 100);
    }
}
