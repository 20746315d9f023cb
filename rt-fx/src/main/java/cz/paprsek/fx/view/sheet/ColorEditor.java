package cz.paprsek.fx.view.sheet;

import cz.paprsek.fx.model.property.Property;
import cz.paprsek.fx.model.property.Trait;
import cz.paprsek.fx.view.dialog.ColorBox;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Rgb;
import cz.paprsek.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.layout.HBox;
import javafx.scene.paint.Color;

/** A colour as a picker and three fields from 0 to 255. */
final class ColorEditor implements PropertyEditor {
    private static final List<String> CHANNELS = List.of("red", "green", "blue");

    private final HBox box = new HBox();
    private final ColorBox picker;
    private final List<NumberField> fields = new ArrayList<>();
    private final Property property;
    private boolean showing;

    ColorEditor(Property property, PropertyEdit edit, Texts texts, String pick) {
        this.property = property;
        picker = new ColorBox(texts);
        box.getStyleClass().add("color-editor");
        box.setAlignment(Pos.CENTER_LEFT);
        picker.setId(String.join("-", property.path()) + "-picker");
        picker.setAccessibleText(pick);
        picker.setOnAction(event -> {
            if (!showing) {
                Rgb picked = rgb(picker.getValue());
                edit.change(scene -> property.write(scene, property.read(scene).map(old -> kept((Rgb) old, picked)).orElse(picked)));
            }
        });
        box.getChildren().add(picker);
        for (String channel : CHANNELS) {
            Property part = new Property(property.target(), property.part(channel).path(), double.class, channel());
            NumberField field = new NumberField(part, edit, texts);
            // Colours of metals are computed, and have more decimals than there is room for, or than can be seen.
            field.round();
            box.getChildren().add(field.behind(channel.substring(0, 1).toUpperCase(Locale.ROOT), channel));
            fields.add(field);
        }
    }

    @Override
    public Node node() {
        return box;
    }

    @Override
    public void show(Scene scene) {
        fields.forEach(field -> field.show(scene));
        showing = true;
        property.read(scene).ifPresent(value -> picker.setValue(color((Rgb) value)));
        showing = false;
    }

    private static Color color(Rgb rgb) {
        return Color.color(rgb.red() / 255, rgb.green() / 255, rgb.blue() / 255);
    }

    private static Rgb rgb(Color color) {
        return new Rgb(Math.rint(color.getRed() * 255), Math.rint(color.getGreen() * 255), Math.rint(color.getBlue() * 255));
    }

    /** A colour that was picked, with the decimals of an old one where they are all that differs: a picker shows whole numbers. */
    private static Rgb kept(Rgb old, Rgb picked) {
        return new Rgb(kept(old.red(), picked.red()), kept(old.green(), picked.green()), kept(old.blue(), picked.blue()));
    }

    private static double kept(double old, double picked) {
        return Math.abs(old - picked) <= 0.5 ? old : picked;
    }

    private static Trait channel() {
        return new Trait(Trait.Kind.NUMBER, Trait.Unit.NONE, 0, 255, 1, List.of());
    }
}
