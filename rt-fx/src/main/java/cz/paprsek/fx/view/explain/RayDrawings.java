package cz.paprsek.fx.view.explain;

import cz.paprsek.drawing.Projection;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.words.Words;
import java.util.List;
import java.util.stream.Stream;
import javafx.beans.value.ObservableValue;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;

/** The rays of a pixel in three projections, beside each other; with the focus here, arrow keys go from pixel to pixel. */
final class RayDrawings extends HBox {
    RayDrawings(ExplainPane pane, Words words, ObservableValue<Theme> theme) {
        super(4);
        List<RayCanvas> drawings = Stream.of(Projection.values())
                .map(projection -> new RayCanvas(projection, projection.title(words), theme)).toList();
        drawings.forEach(drawing -> HBox.setHgrow(drawing, Priority.ALWAYS));
        getChildren().addAll(drawings);
        setId("explain-drawings");
        setFocusTraversable(true);
        setOnMousePressed(event -> requestFocus());
        setOnKeyPressed(pane::step);
        pane.drawnProperty().addListener((property, old, now) -> drawings.forEach(drawing -> drawing.draw(now)));
    }
}
