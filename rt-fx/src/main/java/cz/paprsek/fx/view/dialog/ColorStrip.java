package cz.paprsek.fx.view.dialog;

import cz.paprsek.fx.view.dialog.Tint.Part;
import cz.paprsek.fx.view.render.fields.WholeNumberField;
import cz.paprsek.fx.view.texts.Texts;
import java.util.Locale;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import javafx.scene.Node;
import javafx.scene.control.Slider;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.StackPane;
import javafx.scene.paint.Color;
import javafx.scene.paint.CycleMethod;
import javafx.scene.paint.LinearGradient;
import javafx.scene.paint.Stop;
import javafx.scene.shape.Rectangle;

/**
 * One part of a colour: a slider over what each place of it would give, and a field with its number. Arrow keys go by one, with Shift and Page Up and Down by ten.
 */
final class ColorStrip {
    private static final double WIDTH = 280;
    /** Of the slider's thumb, which reaches half its width beyond the strip at both ends; as the style sheet has it. */
    private static final double THUMB = 16;
    private static final double HEIGHT = 12;
    private static final int STOPS = 12;
    private static final int LEAP = 10;

    private final Part part;
    private final Slider slider;
    private final Rectangle way = bordered(WIDTH - THUMB, HEIGHT);
    private final StackPane strip;
    private final WholeNumberField field;
    private boolean showing;
    private boolean typing;

    /**
     * @param onPulled is told of a number chosen on the strip
     * @param onTyped is told of a number in the field
     */
    ColorStrip(Part part, Texts texts, DoubleConsumer onPulled, DoubleConsumer onTyped) {
        this.part = part;
        String id = "color-" + part.name().toLowerCase(Locale.ROOT);
        String name = texts.of(part.key());
        slider = new Slider(0, part.most(), 0);
        slider.setId(id);
        slider.getStyleClass().add("color-strip");
        slider.setBlockIncrement(1);
        slider.setPrefWidth(WIDTH);
        slider.setAccessibleText(name);
        slider.addEventFilter(KeyEvent.KEY_PRESSED, this::leap);
        strip = new StackPane(way, slider);
        field = new WholeNumberField(id + "-field", name, 0, part.most(), 3);
        slider.valueProperty().addListener((property, old, now) -> {
            if (!showing) {
                onPulled.accept(Math.rint(now.doubleValue()));
            }
        });
        field.textProperty().addListener((property, old, now) -> {
            if (!showing && field.validProperty().get()) {
                typing = true;
                onTyped.accept(field.get());
                typing = false;
            }
        });
    }

    /** White on a light window and black on a dark one are seen by its border. */
    static Rectangle bordered(double width, double height) {
        Rectangle fresh = new Rectangle(width, height);
        fresh.getStyleClass().add("color-shown");
        return fresh;
    }

    Node strip() {
        return strip;
    }

    WholeNumberField field() {
        return field;
    }

    void takeKeys() {
        slider.requestFocus();
    }

    /** Shows the number of a colour, and what other numbers would give. */
    void show(Tint tint) {
        showing = true;
        slider.setValue(tint.get(part));
        way.setFill(new LinearGradient(0, 0, 1, 0, true, CycleMethod.NO_CYCLE,
                IntStream.rangeClosed(0, STOPS).mapToObj(i -> new Stop((double) i / STOPS, given(tint, (double) i / STOPS))).toList()));
        if (!typing) {
            field.set((int) Math.rint(tint.get(part)));
        }
        showing = false;
    }

    private Color given(Tint tint, double share) {
        return tint.sought(part, share * part.most()).color();
    }

    private void leap(KeyEvent event) {
        int by = switch (event.getCode()) {
            case PAGE_UP -> LEAP;
            case PAGE_DOWN -> -LEAP;
            case RIGHT -> event.isShiftDown() ? LEAP : 0;
            case LEFT -> event.isShiftDown() ? -LEAP : 0;
            default -> 0;
        };
        if (by != 0) {
            slider.adjustValue(slider.getValue() + by);
            event.consume();
        }
    }
}
