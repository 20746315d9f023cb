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
    TXT, JSON, SVG, PDF, HTML;

    /** With the dot. */
    String extension() {
        return switch (this) {
            case TXT -> ".txt";
            case JSON -> ".json";
            case SVG -> ".svg";
            case PDF -> ".pdf";
            case HTML -> ".html";
        };
    }

    /**
     * @param ray which of the pixel's rays is drawn, counted from 0
     */
    void write(PicturePoint point, Explained pixel, int ray, Words words, Path file) throws IOException {
        byte[] content = switch (this) {
            case TXT -> bytes(pixel.text(words) + "\n");
            case JSON -> bytes(pixel.json() + "\n");
            case PDF -> worksheet(point, words).pdf();
            case HTML -> bytes(worksheet(point, words).html());
            case SVG -> bytes(TreeDrawing.svg(point.scene().scene(), pixel.ray(ray), pixel.smallestShare(), words));
        };
        AtomicFile.write(file, out -> out.write(content));
    }

    private static Worksheet worksheet(PicturePoint point, Words words) {
        return new Worksheet(point.scene().scene(), point.scene(), point.settings(), List.of(new int[] {point.column(), point.row()}), OptionalLong.empty(), words);
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
