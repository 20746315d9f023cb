package cz.paprsek.fx.view.render.fields;

import java.util.Locale;
import java.util.regex.Pattern;
import javafx.scene.paint.Color;

/** A field for a colour as {@code #rrggbb}; {@code #rgb} is understood, too, and the # may be left out. */
public final class HexField extends CheckedField {
    private static final Pattern HEX = Pattern.compile("\\s*#?([0-9a-fA-F]{3}|[0-9a-fA-F]{6})\\s*");

    /** @param hint what it is for, and how it is written */
    public HexField(String id, String name, String hint) {
        super(id, name, hint, 7);
        set(Color.BLACK);
    }

    /** Shows a colour. */
    public void set(Color color) {
        setText(text(color));
    }

    /** How a colour is written. */
    public static String text(Color color) {
        return String.format(Locale.ROOT, "#%02x%02x%02x", Math.round(255 * color.getRed()), Math.round(255 * color.getGreen()), Math.round(255 * color.getBlue()));
    }

    /** The colour; only if it is valid. */
    public Color get() {
        return Color.web(getText().strip());
    }

    @Override
    public String word() {
        return validProperty().get() ? text(get()) : getText();
    }

    @Override
    boolean isInRange(String text) {
        return HEX.matcher(text).matches();
    }
}
