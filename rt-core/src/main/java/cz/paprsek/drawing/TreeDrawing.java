package cz.paprsek.drawing;

import cz.paprsek.math.Vec3;
import cz.paprsek.render.explain.TracedRay;
import cz.paprsek.render.explain.text.Outline;
import cz.paprsek.scene.Scene;
import cz.paprsek.words.Words;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** A tree of rays drawn as SVG in three projections, with the outlines of what the rays meet. */
public final class TreeDrawing {
    private static final int SIDE = 420;
    private static final int GAP = 16;
    private static final int TITLE = 24;

    private final StringBuilder svg = new StringBuilder();
    private final DrawingFrame frame;
    private final List<RayLine> lines;
    private final List<List<Vec3>> outlines;
    private final Projection projection;
    private final int left;

    private TreeDrawing(DrawingFrame frame, List<RayLine> lines, List<List<Vec3>> outlines, Projection projection, int left) {
        this.frame = frame;
        this.lines = lines;
        this.outlines = outlines;
        this.projection = projection;
        this.left = left;
    }

    /**
     * The drawing of one ray from the eye, about where it and those it gives rise to hit something.
     *
     * @param smallestShare rays of a {@linkplain Outline#share share} below this are left out
     * @return a whole SVG document
     */
    public static String svg(Scene scene, TracedRay ray, double smallestShare, Words words) {
        Outline outline = Outline.of(ray).pruned(smallestShare);
        DrawingFrame frame = DrawingFrame.of(scene, outline);
        List<RayLine> lines = RayLine.of(outline, frame.size());
        int width = GAP + Projection.values().length * (SIDE + GAP);
        int height = TITLE + SIDE + 3 * GAP;
        StringBuilder views = new StringBuilder();
        int left = GAP;
        for (Projection projection : Projection.values()) {
            views.append(new TreeDrawing(frame, lines, frame.outlines(projection), projection, left).view(words));
            left += SIDE + GAP;
        }
        return String.format(Locale.ROOT, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\""
                + " font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"%d\" height=\"%d\" fill=\"#ffffff\"/>\n",
                width, height, width, height, width, height) + views + legend(height - GAP, words) + "</svg>\n";
    }

    private String view(Words words) {
        text(left, TITLE - 6, "#30343a", projection.title(words));
        svg.append(String.format(Locale.ROOT, "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"#f7f8fa\" stroke=\"#c9ced6\"/>\n",
                left, TITLE, SIDE, SIDE));
        outlines.forEach(points -> {
            StringBuilder path = new StringBuilder();
            for (int i = 1; i < points.size(); i++) {
                path.append(path(points.get(i - 1), points.get(i)));
            }
            draw(path.toString(), "stroke=\"#9aa3b0\" stroke-width=\"1\"");
        });
        lines.forEach(line -> draw(path(line.from(), line.to()), stroke(line.style())));
        lines.stream().filter(line -> line.isRay() || line.style() == RayLine.Style.NORMAL).forEach(this::arrow);
        lines.stream().filter(RayLine::isRay).forEach(this::label);
        return svg.toString();
    }

    private void draw(String path, String stroke) {
        if (!path.isEmpty()) {
            svg.append("<path fill=\"none\" ").append(stroke).append(" d=\"").append(path.strip()).append("\"/>\n");
        }
    }

    /** A straight line as far as it is within the frame, in the words of SVG; empty if none of it is. */
    private String path(Vec3 from, Vec3 to) {
        return segment(from, to).within(SIDE, SIDE).map(seen -> "M" + number(left + seen.x1()) + "," + number(TITLE + seen.y1())
                + " L" + number(left + seen.x2()) + "," + number(TITLE + seen.y2()) + " ").orElse("");
    }

    /** A small triangle at the end of a line, unless the line is seen from its end or the end is not seen. */
    private void arrow(RayLine line) {
        double endX = x(line.to());
        double endY = y(line.to());
        double dx = endX - x(line.from());
        double dy = endY - y(line.from());
        double length = Math.sqrt(dx * dx + dy * dy);
        if (length > 2 && endX > 0 && endY > 0 && endX < SIDE && endY < SIDE) {
            double ux = 8 * dx / length;
            double uy = 8 * dy / length;
            svg.append(String.format(Locale.ROOT, "<path stroke=\"none\" fill=\"%s\" d=\"M%s,%s L%s,%s L%s,%s Z\"/>\n", line.style().color(),
                    number(left + endX), number(TITLE + endY),
                    number(left + endX - ux + 0.35 * uy), number(TITLE + endY - uy - 0.35 * ux),
                    number(left + endX - ux - 0.35 * uy), number(TITLE + endY - uy + 0.35 * ux)));
        }
    }

    /** The ray's name beside the middle of what is seen of it. */
    private void label(RayLine line) {
        segment(line.from(), line.to()).within(SIDE, SIDE).ifPresent(seen -> {
            double x = Math.min(SIDE - 8 - 8 * line.ray().length(), (seen.x1() + seen.x2()) / 2 + 4);
            text(left + x, TITLE + Math.max(14, (seen.y1() + seen.y2()) / 2 - 4), line.style().color(), line.ray());
        });
    }

    private void text(double x, double y, String color, String text) {
        svg.append(String.format(Locale.ROOT, "<text x=\"%s\" y=\"%s\" stroke=\"none\" fill=\"%s\">%s</text>\n", number(x), number(y), color, text));
    }

    private static String legend(int y, Words words) {
        StringBuilder legend = new StringBuilder();
        int x = GAP;
        for (RayLine.Style style : RayLine.Style.values()) {
            legend.append(String.format(Locale.ROOT, "<line fill=\"none\" x1=\"%d\" y1=\"%d\" x2=\"%d\" y2=\"%d\" %s/>\n<text stroke=\"none\" fill=\"#30343a\" x=\"%d\" y=\"%d\">%s</text>\n",
                    x, y - 4, x + 40, y - 4, stroke(style), x + 46, y, style.title(words)));
            x += 160;
        }
        return legend.toString();
    }

    private static String stroke(RayLine.Style style) {
        String dashes = style.dashes().stream().map(String::valueOf).collect(Collectors.joining(" "));
        return "stroke=\"" + style.color() + "\" stroke-width=\"1.5\"" + (dashes.isEmpty() ? "" : " stroke-dasharray=\"" + dashes + "\"");
    }

    private Segment segment(Vec3 from, Vec3 to) {
        return new Segment(x(from), y(from), x(to), y(to));
    }

    private double x(Vec3 point) {
        return SIDE / 2.0 + projection.right(point.minus(frame.middle())) / frame.size() * SIDE;
    }

    private double y(Vec3 point) {
        return SIDE / 2.0 - projection.up(point.minus(frame.middle())) / frame.size() * SIDE;
    }

    private static String number(double pixels) {
        return String.format(Locale.ROOT, "%.2f", pixels);
    }
}
