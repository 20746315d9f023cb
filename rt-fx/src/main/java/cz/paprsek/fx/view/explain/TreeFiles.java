package cz.paprsek.fx.view.explain;

import cz.paprsek.drawing.TreeDrawing;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.text.Decoration;
import cz.paprsek.render.explain.text.TreeJson;
import cz.paprsek.render.explain.text.TreeText;
import cz.paprsek.words.Words;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/** The forms in which the tree of a pixel can be kept. */
enum TreeFiles {
    TXT, JSON, SVG;

    /** With the dot. */
    String extension() {
        return switch (this) {
            case TXT -> ".txt";
            case JSON -> ".json";
            case SVG -> ".svg";
        };
    }

    /**
     * @param ray which of the pixel's rays is drawn, counted from 0
     * @param smallestShare rays of a smaller share in the pixel are left out of text and drawing
     */
    void write(PicturePoint point, Pixel pixel, int ray, double smallestShare, Words words, Path file) throws IOException {
        String content = switch (this) {
            case TXT -> String.join("\n", TreeText.lines(pixel, smallestShare, Decoration.NONE, words)) + "\n";
            case JSON -> TreeJson.of(pixel) + "\n";
            case SVG -> TreeDrawing.svg(point.scene().scene(), pixel.rays().get(ray), smallestShare, words);
        };
        AtomicFile.write(file, out -> out.write(content.getBytes(StandardCharsets.UTF_8)));
    }
}
