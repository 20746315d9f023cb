package cz.paprsek.fx.view.explain;

import cz.paprsek.drawing.TreeDrawing;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.sheet.Worksheet;
import cz.paprsek.words.Words;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalLong;

/** The forms in which the tree of a pixel can be kept; one is a worksheet. */
enum TreeFiles {
    TXT, JSON, SVG, HTML;

    /** With the dot. */
    String extension() {
        return switch (this) {
            case TXT -> ".txt";
            case JSON -> ".json";
            case SVG -> ".svg";
            case HTML -> ".html";
        };
    }

    /**
     * @param ray which of the pixel's rays is drawn, counted from 0
     */
    void write(PicturePoint point, Explained pixel, int ray, Words words, Path file) throws IOException {
        String content = switch (this) {
            case TXT -> pixel.text(words) + "\n";
            case JSON -> pixel.json() + "\n";
            case HTML -> new Worksheet(point.scene().scene(), point.scene(), point.settings(), List.of(new int[] {point.column(), point.row()}), OptionalLong.empty(), words).html();
            case SVG -> TreeDrawing.svg(point.scene().scene(), pixel.ray(ray), pixel.smallestShare(), words);
        };
        AtomicFile.write(file, out -> out.write(content.getBytes(StandardCharsets.UTF_8)));
    }
}
