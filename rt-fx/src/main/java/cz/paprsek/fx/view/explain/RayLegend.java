package cz.paprsek.fx.view.explain;

import cz.paprsek.drawing.RayLine;
import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.rays.RayPainter;
import cz.paprsek.words.Words;
import java.util.List;
import javafx.beans.value.ObservableValue;
import javafx.scene.Node;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.control.Label;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.Region;

/** What colours and dashes mean. */
public final class RayLegend extends FlowPane {
    private static final double LENGTH = 40;
    private static final double HEIGHT = 12;

    RayLegend(Words words, ObservableValue<Theme> theme) {
        super(14, 2);
        setId("explain-legend");
        getStyleClass().add("explain-legend");
        for (RayLine.Style style : RayLine.Style.values()) {
            Label label = new Label(style.title(words), line(style, theme));
            label.setMinWidth(Region.USE_PREF_SIZE);
            getChildren().add(label);
        }
    }

    /** A piece of a line as it is drawn. */
    public static Node line(RayLine.Style style, ObservableValue<Theme> theme) {
        Canvas line = new Canvas(LENGTH, HEIGHT);
        paint(line, style, theme.getValue());
        theme.addListener((property, old, now) -> paint(line, style, now));
        return line;
    }

    private static void paint(Canvas line, RayLine.Style style, Theme theme) {
        GraphicsContext g = line.getGraphicsContext2D();
        g.clearRect(0, 0, LENGTH, HEIGHT);
        Segment at = new Segment(0, HEIGHT / 2, LENGTH, HEIGHT / 2);
        RayPainter.on(g, theme, (from, to) -> List.of(at)).sample(style, at);
    }
}
