package cz.paprsek.fx.view.rays;

import cz.paprsek.drawing.RayLine;
import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.math.Vec3;
import java.util.List;
import javafx.geometry.VPos;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import javafx.scene.shape.StrokeLineCap;
import javafx.scene.text.Font;
import javafx.scene.text.FontWeight;
import javafx.scene.text.TextAlignment;

/** Draws rays on a canvas: kinds told apart by colour and by dash, normals as arrows, the highlighted ray bold and with its name. */
public final class RayPainter {
    private static final Color HALO = Color.rgb(0, 0, 0, 0.45);
    private static final double ARROW = 9;
    /** Lines are cut this far beyond the edges, so that thick ones and arrows do not end within sight. */
    private static final double BEYOND = 12;

    private final GraphicsContext g;
    private final RayColors colors;
    private final boolean hasHalo;
    private final Mapping mapping;
    private final double width;
    private final double height;

    /** Where a straight line of the world is on the canvas: nowhere, one straight piece, or those that a curve is made of. */
    @FunctionalInterface
    public interface Mapping {
        List<Segment> line(Vec3 from, Vec3 to);
    }

    private RayPainter(GraphicsContext g, RayColors colors, boolean hasHalo, Mapping mapping) {
        this.g = g;
        this.colors = colors;
        this.hasHalo = hasHalo;
        this.mapping = mapping;
        this.width = g.getCanvas().getWidth();
        this.height = g.getCanvas().getHeight();
    }

    /** For a canvas whose ground has the theme's colour. */
    public static RayPainter on(GraphicsContext g, Theme theme, Mapping mapping) {
        return new RayPainter(g, RayColors.of(theme), false, mapping);
    }

    /** For a canvas above a picture of any colour: bright lines with dark edges. */
    public static RayPainter overPicture(GraphicsContext g, Mapping mapping) {
        return new RayPainter(g, RayColors.ON_DARK, true, mapping);
    }

    public void draw(DrawnRays rays) {
        g.save();
        rays.visible().forEach(line -> draw(line, mapping.line(line.from(), line.to()), rays.isHighlighted(line)));
        g.restore();
    }

    /** One line as long as it is, without arrow and name. */
    public void sample(RayLine.Style style, Segment at) {
        stroke(style, at, 2);
    }

    private void draw(RayLine line, List<Segment> pieces, boolean isBold) {
        boolean hasArrow = line.isRay() || line.style() == RayLine.Style.NORMAL;
        for (int i = 0; i < pieces.size(); i++) {
            draw(line, pieces.get(i), isBold, hasArrow && i == pieces.size() - 1, line.isRay() && isBold && i == pieces.size() / 2);
        }
    }

    private void draw(RayLine line, Segment whole, boolean isBold, boolean hasArrow, boolean hasName) {
        // A dashed line that goes on for thousands of pixels out of sight would be cut into its dashes there, too.
        new Segment(whole.x1() + BEYOND, whole.y1() + BEYOND, whole.x2() + BEYOND, whole.y2() + BEYOND)
                .within(width + 2 * BEYOND, height + 2 * BEYOND)
                .map(cut -> new Segment(cut.x1() - BEYOND, cut.y1() - BEYOND, cut.x2() - BEYOND, cut.y2() - BEYOND))
                .ifPresent(seen -> {
                    stroke(line.style(), seen, !isBold ? 1.6 : line.isRay() ? 3.5 : 2.4);
                    if (hasArrow) {
                        arrow(line.style(), whole, isBold ? ARROW * 1.4 : ARROW);
                    }
                    if (hasName) {
                        name(line, seen);
                    }
                });
    }

    private void stroke(RayLine.Style style, Segment at, double thickness) {
        // Square ends would fill the gaps between dashes.
        g.setLineCap(StrokeLineCap.BUTT);
        g.setLineDashes();
        if (hasHalo) {
            g.setStroke(HALO);
            g.setLineWidth(thickness + 2.5);
            g.strokeLine(at.x1(), at.y1(), at.x2(), at.y2());
        }
        g.setStroke(colors.of(style));
        g.setLineWidth(thickness);
        g.setLineDashes(style.dashes().stream().mapToDouble(Integer::doubleValue).toArray());
        g.strokeLine(at.x1(), at.y1(), at.x2(), at.y2());
    }

    private void arrow(RayLine.Style style, Segment at, double size) {
        double length = at.length();
        if (length > 2) {
            double ux = size * (at.x2() - at.x1()) / length;
            double uy = size * (at.y2() - at.y1()) / length;
            g.setFill(colors.of(style));
            g.fillPolygon(new double[] {at.x2(), at.x2() - ux + 0.35 * uy, at.x2() - ux - 0.35 * uy},
                    new double[] {at.y2(), at.y2() - uy - 0.35 * ux, at.y2() - uy + 0.35 * ux}, 3);
        }
    }

    /** The ray's name beside the middle of what is seen of it. */
    private void name(RayLine line, Segment seen) {
        g.setFont(Font.font("System", FontWeight.BOLD, 13));
        g.setTextAlign(TextAlignment.LEFT);
        g.setTextBaseline(VPos.BASELINE);
        double x = Math.max(4, Math.min(width - 6 - 10 * line.ray().length(), (seen.x1() + seen.x2()) / 2 + 7));
        double y = Math.max(16, Math.min(height - 6, (seen.y1() + seen.y2()) / 2 - 6));
        if (hasHalo) {
            g.setLineDashes();
            g.setStroke(HALO);
            g.setLineWidth(3);
            g.strokeText(line.ray(), x, y);
        }
        g.setFill(colors.of(line.style()));
        g.fillText(line.ray(), x, y);
    }
}
