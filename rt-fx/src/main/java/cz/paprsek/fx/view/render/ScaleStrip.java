package cz.paprsek.fx.view.render;

import cz.paprsek.drawing.Legend;
import cz.paprsek.fx.view.picture.PictureBuffer;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageOptions;
import cz.paprsek.render.Tile;
import cz.paprsek.render.mode.RenderMode.HeatScale;
import javafx.geometry.Pos;
import javafx.scene.image.ImageView;
import javafx.scene.layout.StackPane;

/** What the colours of a heat map stand for: the strip that saved pictures have below them. */
final class ScaleStrip extends StackPane {
    private static final int WIDTH = 480;

    ScaleStrip(HeatScale scale) {
        Image strip = Legend.below(new Image(WIDTH, 1), scale);
        PictureBuffer buffer = new PictureBuffer(strip.width(), strip.height());
        buffer.paint(strip, new Tile(0, 0, strip.width(), strip.height()), 1, ImageOptions.DEFAULT);
        setAlignment(Pos.CENTER);
        setId("render-scale");
        getStyleClass().add("render-scale");
        getChildren().add(new ImageView(buffer.image()));
    }
}
