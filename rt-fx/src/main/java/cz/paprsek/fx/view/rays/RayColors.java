package cz.paprsek.fx.view.rays;

import cz.paprsek.drawing.RayLine;
import cz.paprsek.fx.view.look.Theme;
import java.util.EnumMap;
import java.util.Map;
import javafx.scene.paint.Color;

/** The colours of lines, to be seen on a light or a dark ground. */
enum RayColors {
    ON_LIGHT, ON_DARK;

    private static final Map<RayLine.Style, Color> BRIGHT = new EnumMap<>(Map.of(
            RayLine.Style.PRIMARY, Color.web("#ffab40"), RayLine.Style.REFLECTED, Color.web("#6cb2ff"),
            RayLine.Style.REFRACTED, Color.web("#4cd07d"), RayLine.Style.SHADOW_FREE, Color.web("#e8d65c"),
            RayLine.Style.SHADOW_BLOCKED, Color.web("#ff7b72"), RayLine.Style.NORMAL, Color.web("#b4bcc8")));

    static RayColors of(Theme theme) {
        return theme == Theme.DARK ? ON_DARK : ON_LIGHT;
    }

    Color of(RayLine.Style style) {
        return this == ON_LIGHT ? Color.web(style.color()) : BRIGHT.getOrDefault(style, Color.WHITE);
    }
}
