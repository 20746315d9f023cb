package cz.paprsek.fx.view.explain;

import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.render.explain.Pixel;
import cz.paprsek.render.explain.Pixel.PathPixel;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.text.Decoration;
import cz.paprsek.render.explain.text.PathJson;
import cz.paprsek.render.explain.text.PathLines;
import cz.paprsek.render.explain.text.PathWords;
import cz.paprsek.render.explain.text.TreeJson;
import cz.paprsek.render.explain.text.TreeText;
import cz.paprsek.words.Words;

/** A pixel that is explained, by what is listed of it: its rays, or typical paths by which its light came. */
public sealed interface Explained {
    /** Explains the pixel at a point of a picture. */
    static Explained of(PicturePoint point) {
        return of(point, RenderMonitor.NONE);
    }

    /**
     * Explains the pixel at a point of a picture unless the monitor cancels.
     *
     * @throws java.util.concurrent.CancellationException if it does
     */
    static Explained of(PicturePoint point, RenderMonitor monitor) {
        RenderOptions options = RenderOptions.of(point.settings());
        return point.settings().isPath() ? new OfPaths(point.scene().explainPaths(options, point.column(), point.row(), monitor))
                : new OfRays(point.scene().explain(options, point.column(), point.row(), monitor));
    }

    /** How many rays or paths there are to be chosen from. */
    int size();

    /** Which of them to begin with. */
    int typical();

    /** The pixel's light. */
    LinearRgb light();

    /** What it is and how it comes about, in one line. */
    String sum(Words words);

    /** One that is listed, with what it gives rise to. */
    TracedRay ray(int number);

    /** What it brings, in one line. */
    String line(int number, Words words);

    /** Rays of a smaller share are left out. */
    double smallestShare();

    String text(Words words);

    String json();

    record OfRays(Pixel pixel) implements Explained {
        @Override
        public int size() {
            return pixel.rays().size();
        }

        @Override
        public int typical() {
            return pixel.typical();
        }

        @Override
        public LinearRgb light() {
            return pixel.light();
        }

        @Override
        public String sum(Words words) {
            return TreeText.sum(pixel, words);
        }

        @Override
        public TracedRay ray(int number) {
            return pixel.rays().get(number);
        }

        @Override
        public String line(int number, Words words) {
            return TreeText.sample(pixel, number, words);
        }

        @Override
        public double smallestShare() {
            return ExplainPane.SMALLEST_SHARE;
        }

        @Override
        public String text(Words words) {
            return String.join("\n", TreeText.lines(pixel, smallestShare(), Decoration.NONE, words));
        }

        @Override
        public String json() {
            return TreeJson.of(pixel).toString();
        }
    }

    record OfPaths(PathPixel pixel) implements Explained {
        @Override
        public int size() {
            return pixel.examples().size();
        }

        @Override
        public int typical() {
            return 0;
        }

        @Override
        public LinearRgb light() {
            return pixel.light();
        }

        @Override
        public String sum(Words words) {
            return new PathWords(words).sum(pixel);
        }

        @Override
        public TracedRay ray(int number) {
            return pixel.examples().get(number).ray();
        }

        @Override
        public String line(int number, Words words) {
            PathPixel.Way way = pixel.ways().get(pixel.examples().get(number).way());
            return new PathWords(words).of(way) + "  " + new PathWords(words).amount(pixel, way).strip();
        }

        /** What comes late on a path is part of it. */
        @Override
        public double smallestShare() {
            return 0;
        }

        @Override
        public String text(Words words) {
            return String.join("\n", PathLines.lines(pixel, ExplainPane.SMALLEST_SHARE, Decoration.NONE, words));
        }

        @Override
        public String json() {
            return PathJson.of(pixel).toString();
        }
    }
}
