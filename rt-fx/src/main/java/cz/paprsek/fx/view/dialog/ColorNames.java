package cz.paprsek.fx.view.dialog;

import cz.paprsek.fx.view.render.fields.HexField;
import cz.paprsek.fx.view.texts.Texts;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import javafx.scene.paint.Color;

/** What colours of the palette are called. */
final class ColorNames {
    /** As in style sheets, but for the dashes. */
    private static final Map<Color, String> NAMES = List.of(
            "red", "green", "blue", "black", "cyan", "dark-blue", "dark-cyan", "dark-gray", "dark-green", "dark-magenta", "dark-red", "gray", "light-blue", "light-cyan",
            "light-gray", "light-green", "light-yellow", "lime", "magenta", "maroon", "medium-blue", "navy", "olive", "orange", "pink", "purple", "teal", "white", "yellow").stream()
            .collect(Collectors.toUnmodifiableMap(name -> Color.web(name.replace("-", "")), Function.identity()));

    private ColorNames() {}

    /** Its name, if it has one, and its number. */
    static String of(Color color, Texts texts) {
        String number = HexField.text(color);
        return Optional.ofNullable(NAMES.get(color)).map(name -> texts.of("color.name." + name) + " · " + number).orElse(number);
    }
}
