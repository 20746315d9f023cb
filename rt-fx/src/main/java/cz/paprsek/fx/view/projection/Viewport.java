package cz.paprsek.fx.view.projection;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Locale;
import javafx.geometry.BoundingBox;
import javafx.geometry.Bounds;

/**
 * Which part of a projection's plane is shown how large.
 *
 * @param centreU what is in the middle of the pane
 * @param centreV what is in the middle of the pane
 * @param scale pixels per scene unit
 * @param width of the pane, pixels
 * @param height of the pane, pixels
 */
record Viewport(double centreU, double centreV, double scale, double width, double height) {
    static final double LEAST_SCALE = 1e-6;
    static final double LARGEST_SCALE = 1e9;
    private static final int MOST_DECIMALS = 12;

    Viewport withSize(double newWidth, double newHeight) {
        return new Viewport(centreU, centreV, scale, newWidth, newHeight);
    }

    double x(double u) {
        return width / 2 + (u - centreU) * scale;
    }

    double y(double v) {
        return height / 2 - (v - centreV) * scale;
    }

    double u(double x) {
        return centreU + (x - width / 2) / scale;
    }

    double v(double y) {
        return centreV - (y - height / 2) / scale;
    }

    /** Zoomed by a factor; what is at the point stays there. */
    Viewport zoomed(double factor, double x, double y) {
        double fresh = Math.max(LEAST_SCALE, Math.min(LARGEST_SCALE, scale * factor));
        double u = u(x);
        double v = v(y);
        return new Viewport(u - (x - width / 2) / fresh, v + (y - height / 2) / fresh, fresh, width, height);
    }

    /** Moved with the mouse by pixels. */
    Viewport panned(double dx, double dy) {
        return new Viewport(centreU - dx / scale, centreV + dy / scale, scale, width, height);
    }

    /** Showing a box with some air around; a box without extent is put in the middle. */
    Viewport fitting(Box box) {
        if (box.isEmpty() || width <= 0 || height <= 0) {
            return this;
        }
        double air = 0.8;
        double fit = Math.min(air * width / box.width(), air * height / box.height());
        double fresh = Double.isFinite(fit) ? Math.max(LEAST_SCALE, Math.min(LARGEST_SCALE, fit)) : scale;
        return new Viewport(box.centreU(), box.centreV(), fresh, width, height);
    }

    /** Where a box is on the pane, pixels, with some air around. */
    Bounds of(Box box, double air) {
        return new BoundingBox(x(box.minU()) - air, y(box.maxV()) - air, x(box.maxU()) - x(box.minU()) + 2 * air, y(box.minV()) - y(box.maxV()) + 2 * air);
    }

    /** All squares of so many pixels that a rectangle touches, side by side from the pane's corner. */
    static Bounds whole(Bounds part, int size) {
        double x = Math.floor(part.getMinX() / size) * size;
        double y = Math.floor(part.getMinY() / size) * size;
        return new BoundingBox(x, y, Math.max(0, Math.ceil(part.getMaxX() / size) * size - x), Math.max(0, Math.ceil(part.getMaxY() / size) * size - y));
    }

    /** A rectangle around some, as far as it is on the pane. */
    Bounds around(List<Bounds> parts) {
        double left = parts.stream().mapToDouble(Bounds::getMinX).min().orElse(0);
        double top = parts.stream().mapToDouble(Bounds::getMinY).min().orElse(0);
        double right = parts.stream().mapToDouble(Bounds::getMaxX).max().orElse(0);
        double bottom = parts.stream().mapToDouble(Bounds::getMaxY).max().orElse(0);
        return new BoundingBox(Math.max(0, left), Math.max(0, top), Math.min(width, right) - Math.max(0, left), Math.min(height, bottom) - Math.max(0, top));
    }

    /** Whether all of a box is in sight. */
    boolean contains(Box box) {
        return x(box.minU()) >= 1 && x(box.maxU()) <= width - 1 && y(box.maxV()) >= 1 && y(box.minV()) <= height - 1;
    }

    /** Whether a box is in sight at all. */
    boolean shows(Box box) {
        return x(box.maxU()) >= 0 && x(box.minU()) <= width && y(box.minV()) >= 0 && y(box.maxV()) <= height;
    }

    /** A length as it is read from a projection: as fine as a pixel shows. */
    String text(double length, Locale locale) {
        return text("", length, locale);
    }

    /** With + or − before it. */
    String signed(double length, Locale locale) {
        return text("+", length, locale);
    }

    private String text(String flag, double length, Locale locale) {
        int decimals = Math.max(0, Math.min(MOST_DECIMALS, (int) Math.ceil(Math.log10(scale))));
        // Not as a double, which would show the rest of a rounding as −0.00.
        BigDecimal shown = new BigDecimal(length).setScale(decimals, RoundingMode.HALF_EVEN);
        return String.format(locale, "%" + flag + "." + decimals + "f", shown);
    }
}
