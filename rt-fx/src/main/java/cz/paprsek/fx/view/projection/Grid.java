package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.edit.Rounds;
import cz.paprsek.fx.view.look.Palette;
import java.math.BigDecimal;
import java.math.MathContext;
import java.text.DecimalFormatSymbols;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import javafx.geometry.BoundingBox;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import javafx.scene.text.Font;
import javafx.scene.text.FontWeight;
import javafx.scene.text.TextAlignment;

/** Lines at round numbers, as far apart as the zoom allows, with labels; and the axes. */
final class Grid {
    private static final Font FONT = Font.font("System", 10);
    private static final Font LETTER_FONT = Font.font("System", FontWeight.BOLD, 11);

    private Grid() {}

    static void draw(GraphicsContext g, Viewport view, Axes axes, Palette palette) {
        g.setFill(palette.background());
        g.fillRect(0, 0, view.width(), view.height());
        double step = Rounds.step(view.scale());
        lines(g, view, step, palette.minor());
        lines(g, view, 5 * step, palette.major());
        g.setLineWidth(1);
        axis(g, view, axes, palette);
    }

    /**
     * The numbers of the lines and the names of the axes, over whatever would strike them through.
     *
     * @param letters the room of the names, as of {@link #letters}
     */
    static void numbers(GraphicsContext g, Viewport view, Axes axes, Palette palette, Locale locale, List<Bounds> letters) {
        labels(g, view, axes, 5 * Rounds.step(view.scale()), palette, DecimalFormatSymbols.getInstance(locale).getDecimalSeparator());
        g.setFont(LETTER_FONT);
        g.setTextAlign(TextAlignment.CENTER);
        name(g, axes.right(), letters.get(0), palette);
        name(g, axes.up(), letters.get(1), palette);
    }

    private static void lines(GraphicsContext g, Viewport view, double step, Color color) {
        g.setStroke(color);
        g.setLineWidth(1);
        g.beginPath();
        for (long i = first(view.u(0), step); i * step <= view.u(view.width()); i++) {
            double x = crisp(view.x(i * step));
            g.moveTo(x, 0);
            g.lineTo(x, view.height());
        }
        for (long i = first(view.v(view.height()), step); i * step <= view.v(0); i++) {
            double y = crisp(view.y(i * step));
            g.moveTo(0, y);
            g.lineTo(view.width(), y);
        }
        g.stroke();
    }

    private static void axis(GraphicsContext g, Viewport view, Axes axes, Palette palette) {
        double x = crisp(view.x(0));
        double y = crisp(view.y(0));
        g.setStroke(color(axes.up(), palette));
        g.strokeLine(x, 0, x, view.height());
        g.setStroke(color(axes.right(), palette));
        g.strokeLine(0, y, view.width(), y);
    }

    private static void labels(GraphicsContext g, Viewport view, Axes axes, double step, Palette palette, char point) {
        // Wide numbers need more room than the lines have.
        long skip = step * view.scale() < 55 ? 2 : 1;
        for (long i = first(view.u(0), skip * step); i * skip * step <= view.u(view.width()); i++) {
            double x = view.x(i * skip * step);
            if (x > 34 && x < view.width() - 16) {
                String text = number(axes.worldU(i * skip * step), step, point);
                label(g, view, text, x - Plate.size(FONT, text).getWidth() / 2, view.height() - 4, palette);
            }
        }
        for (long i = first(view.v(view.height()), skip * step); i * skip * step <= view.v(0); i++) {
            double y = view.y(i * skip * step);
            // From the very edge: a bit of the line left of a number would look like its sign.
            if (y > 12 && y < view.height() - 16) {
                label(g, view, number(axes.worldV(i * skip * step), step, point), Plate.MARGIN, y + 3, palette);
            }
        }
    }

    private static void label(GraphicsContext g, Viewport view, String text, double x, double y, Palette palette) {
        Plate.draw(g, view, FONT, text, new Point2D(x, y), palette.text(), palette.background());
    }

    private static void name(GraphicsContext g, Axes.Axis axis, Bounds room, Palette palette) {
        g.setFill(color(axis, palette));
        g.fillText(axis.letter(), room.getCenterX(), room.getMinY() + 9);
    }

    /**
     * The room that the names of the axes take, first to the right, where the axes leave the pane, pixels: farther from the axis, or on its other side, if a sign or the pane's edge is there.
     *
     * @param signs of lights and cameras, pixels
     */
    static List<Bounds> letters(Viewport view, Axes axes, List<Bounds> signs) {
        double y = Math.max(20, Math.min(view.height() - 22, view.y(0)));
        double x = Math.max(14, Math.min(view.width() - 14, view.x(0)));
        boolean isRight = axes.worldU(1) > 0;
        double edge = axes.worldV(1) > 0 ? 14 : view.height() - 20;
        Bounds pane = new BoundingBox(0, 0, view.width(), view.height());
        return List.of(room(pane, signs, DoubleStream.of(-5, -13, 18, 26).mapToObj(by -> isRight ? new Point2D(view.width() - 10, y + by) : new Point2D(10, y - 6 + by))),
                room(pane, signs, DoubleStream.of(9, 16, -9, -16, 23, -23).mapToObj(by -> new Point2D(x + by, edge))));
    }

    /** The first that is free, or just the first. */
    private static Bounds room(Bounds pane, List<Bounds> signs, Stream<Point2D> places) {
        List<Bounds> rooms = places.<Bounds>map(at -> new BoundingBox(at.getX() - 5, at.getY() - 9, 10, 12)).toList();
        return rooms.stream().filter(room -> pane.contains(room) && signs.stream().noneMatch(room::intersects)).findFirst().orElse(rooms.get(0));
    }

    static Color color(Axes.Axis axis, Palette palette) {
        return switch (axis) {
            case X -> palette.x();
            case Y -> palette.y();
            case Z -> palette.z();
        };
    }

    private static long first(double from, double step) {
        return (long) Math.ceil(from / step);
    }

    /** In the middle of a pixel, so that a line of width 1 is not smeared over two. */
    private static double crisp(double x) {
        return Math.floor(x) + 0.5;
    }

    /** A multiple of the step without the rounding errors of multiplying. */
    private static String number(double value, double step, char point) {
        if (value == 0) {
            return "0";
        }
        int digits = Math.max(1, (int) Math.ceil(Math.log10(Math.abs(value) / step)) + 3);
        return new BigDecimal(value).round(new MathContext(digits)).stripTrailingZeros().toPlainString().replace('-', '−').replace('.', point);
    }
}
