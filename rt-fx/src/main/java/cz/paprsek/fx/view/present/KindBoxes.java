package cz.paprsek.fx.view.present;

import cz.paprsek.drawing.RayLine.Style;
import cz.paprsek.fx.view.explain.RayLegend;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.texts.Texts;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.CheckBox;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.Region;

/** Which kinds of rays are drawn: the legend, to be ticked. */
final class KindBoxes extends FlowPane {
    private final Set<Style> hidden = EnumSet.noneOf(Style.class);

    /** @param onChange is told that other kinds are drawn from now on */
    KindBoxes(Texts texts, ObservableValue<Theme> theme, Runnable onChange) {
        super(14, 2);
        setId("present-kinds");
        for (Style style : Style.values()) {
            CheckBox box = new CheckBox(style.title(texts.words()));
            box.setId("present-kind-" + style.name().toLowerCase(Locale.ROOT).replace('_', '-'));
            box.setGraphic(RayLegend.line(style, theme));
            box.setSelected(true);
            box.setFocusTraversable(false);
            box.setMinWidth(Region.USE_PREF_SIZE);
            box.selectedProperty().addListener((property, old, now) -> {
                if (now) {
                    hidden.remove(style);
                } else {
                    hidden.add(style);
                }
                onChange.run();
            });
            getChildren().add(box);
        }
    }

    Set<Style> hidden() {
        return hidden;
    }
}
