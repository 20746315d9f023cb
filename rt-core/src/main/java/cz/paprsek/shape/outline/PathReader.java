package cz.paprsek.shape.outline;

import java.util.ArrayList;
import java.util.List;

/**
 * Reads outlines: the path data of SVG, all of its commands, with y up as everywhere else here; or corners. Whatever is left open is closed.
 *
 * @source SVG 1.1, §8.3, and for arcs appendix F.6
 */
final class PathReader {
    private static final String ARGUMENTS = "M2L2H1V1C6S4Q4T2A7Z0";

    private final String what;
    private final String text;
    private final List<List<Piece>> contours = new ArrayList<>();
    private List<Piece> current = new ArrayList<>();
    private int at;
    private double x;
    private double y;
    private double startX;
    private double startY;
    private double controlX;
    private double controlY;

    PathReader(String what, String text) {
        this.what = what;
        this.text = text;
    }

    /** Corners, each two numbers. */
    List<List<Piece>> points() {
        boolean isFirst = true;
        skip();
        while (at < text.length()) {
            double px = number("points");
            double py = number("points");
            if (isFirst) {
                move(px, py);
            } else {
                straight(px, py);
            }
            isFirst = false;
        }
        close();
        return contours;
    }

    /** The contours of path data, all closed. */
    List<List<Piece>> path() {
        return path(true);
    }

    /** As they are: what is left open stays so. */
    List<List<Piece>> open() {
        return path(false);
    }

    private List<List<Piece>> path(boolean closes) {
        closesAll = closes;
        char command = 0;
        skip();
        while (at < text.length()) {
            char c = text.charAt(at);
            if (Character.isLetter(c)) {
                command = c;
                at++;
                if (ARGUMENTS.indexOf(Character.toUpperCase(c)) < 0) {
                    throw refused("path", "one of the commands M L H V C S Q T A Z", "'" + c + "'", at);
                }
                skip();
            } else if (command == 0 || Character.toUpperCase(command) == 'Z') {
                throw refused("path", "a command such as M", "'" + c + "'", at + 1);
            }
            if (contours.isEmpty() && current.isEmpty() && Character.toUpperCase(command) != 'M' && !isStarted) {
                throw refused("path", "M first", "'" + command + "'", at);
            }
            step(command);
            command = command == 'M' ? 'L' : command == 'm' ? 'l' : command;
            skip();
        }
        end();
        return contours;
    }

    private boolean isStarted;
    private boolean closesAll = true;

    /** Ends a contour that is not said to be closed. */
    private void end() {
        if (closesAll) {
            close();
        } else if (!current.isEmpty()) {
            contours.add(current);
            current = new ArrayList<>();
        }
    }

    private void step(char command) {
        boolean isRelative = Character.isLowerCase(command);
        double ox = isRelative ? x : 0;
        double oy = isRelative ? y : 0;
        switch (Character.toUpperCase(command)) {
            case 'M' -> {
                end();
                move(ox + number("path"), oy + number("path"));
            }
            case 'L' -> straight(ox + number("path"), oy + number("path"));
            case 'H' -> straight(ox + number("path"), y);
            case 'V' -> straight(x, oy + number("path"));
            case 'C' -> curve(ox + number("path"), oy + number("path"), ox + number("path"), oy + number("path"), ox + number("path"), oy + number("path"));
            case 'S' -> curve(2 * x - controlX, 2 * y - controlY, ox + number("path"), oy + number("path"), ox + number("path"), oy + number("path"));
            case 'Q' -> quadratic(ox + number("path"), oy + number("path"), ox + number("path"), oy + number("path"));
            case 'T' -> quadratic(2 * x - controlX, 2 * y - controlY, ox + number("path"), oy + number("path"));
            case 'A' -> arc(number("path"), number("path"), number("path"), flag(), flag(), ox + number("path"), oy + number("path"));
            default -> close();
        }
        isStarted = true;
    }

    private void move(double toX, double toY) {
        x = toX;
        y = toY;
        startX = toX;
        startY = toY;
        smoothFrom(toX, toY);
    }

    private void smoothFrom(double cx, double cy) {
        controlX = cx;
        controlY = cy;
    }

    private void straight(double toX, double toY) {
        if (toX != x || toY != y) {
            current.add(new Straight(x, y, toX, toY));
        }
        x = toX;
        y = toY;
        smoothFrom(x, y);
    }

    private void curve(double ax, double ay, double bx, double by, double toX, double toY) {
        if (ax != x || ay != y || bx != x || by != y || toX != x || toY != y) {
            current.add(new Bezier(x, y, ax, ay, bx, by, toX, toY));
        }
        x = toX;
        y = toY;
        smoothFrom(bx, by);
    }

    private void quadratic(double cx, double cy, double toX, double toY) {
        curve(x + (cx - x) * 2 / 3, y + (cy - y) * 2 / 3, toX + (cx - toX) * 2 / 3, toY + (cy - toY) * 2 / 3, toX, toY);
        smoothFrom(cx, cy);
    }

    private void arc(double radiusX, double radiusY, double degrees, boolean isLarge, boolean isPositive, double toX, double toY) {
        double rx = Math.abs(radiusX);
        double ry = Math.abs(radiusY);
        if (rx == 0 || ry == 0 || (toX == x && toY == y)) {
            straight(toX, toY);
            return;
        }
        double cos = StrictMath.cos(degrees * Math.PI / 180);
        double sin = StrictMath.sin(degrees * Math.PI / 180);
        double hx = (x - toX) / 2;
        double hy = (y - toY) / 2;
        double ux = (cos * hx + sin * hy) / rx;
        double uy = (cos * hy - sin * hx) / ry;
        double square = ux * ux + uy * uy;
        double grown = square > 1 ? Math.sqrt(square) : 1;
        double away = Math.sqrt(Math.max(0, 1 / Math.max(square, 1e-300) - 1)) * (square > 1 ? 0 : 1) * (isLarge == isPositive ? -1 : 1);
        // The middle on the unit circle's scale: at right angles to the chord.
        double cx = away * uy;
        double cy = -away * ux;
        rx *= grown;
        ry *= grown;
        double from = StrictMath.atan2(uy - cy, ux - cx);
        double until = StrictMath.atan2(-uy - cy, -ux - cx);
        double turn = until - from;
        turn += isPositive && turn <= 0 ? 2 * Math.PI : !isPositive && turn >= 0 ? -2 * Math.PI : 0;
        double mx = (x + toX) / 2 + cos * rx * cx - sin * ry * cy;
        double my = (y + toY) / 2 + sin * rx * cx + cos * ry * cy;
        ellipse(mx, my, new double[] {cos * rx, sin * rx, -sin * ry, cos * ry}, from, turn, toX, toY);
    }

    private void ellipse(double mx, double my, double[] axes, double from, double turn, double toX, double toY) {
        int parts = (int) Math.ceil(Math.abs(turn) / (Math.PI / 2) - 1e-9);
        for (int i = 1; i <= parts; i++) {
            double low = from + turn * (i - 1) / parts;
            double high = from + turn * i / parts;
            double nextX = i == parts ? toX : mx + axes[0] * StrictMath.cos(high) + axes[2] * StrictMath.sin(high);
            double nextY = i == parts ? toY : my + axes[1] * StrictMath.cos(high) + axes[3] * StrictMath.sin(high);
            double[] ends = turn > 0 ? new double[] {x, y, nextX, nextY} : new double[] {nextX, nextY, x, y};
            current.add(new Arc(ends, mx, my, axes[0], axes[1], axes[2], axes[3], Math.min(low, high), Math.max(low, high), turn < 0));
            x = nextX;
            y = nextY;
        }
        smoothFrom(x, y);
    }

    private void close() {
        straight(startX, startY);
        if (!current.isEmpty()) {
            contours.add(current);
            current = new ArrayList<>();
        }
    }

    private boolean flag() {
        skip();
        if (at < text.length() && (text.charAt(at) == '0' || text.charAt(at) == '1')) {
            return text.charAt(at++) == '1';
        }
        throw refused("path", "0 or 1 for an arc", found(), at + 1);
    }

    /** In path data a number ends where another one begins: 1-2 and 1.5.5 are two each. */
    private double number(String where) {
        skip();
        int begin = at;
        boolean hasPoint = false;
        boolean hasExponent = false;
        while (at < text.length()) {
            char c = text.charAt(at);
            boolean isSign = (c == '-' || c == '+') && (at == begin || "eE".indexOf(text.charAt(at - 1)) >= 0);
            boolean isPoint = c == '.' && !hasPoint && !hasExponent;
            boolean isExponent = (c == 'e' || c == 'E') && !hasExponent && at > begin;
            if (!(c >= '0' && c <= '9') && !isSign && !isPoint && !isExponent) {
                break;
            }
            hasPoint |= isPoint;
            hasExponent |= isExponent;
            at++;
        }
        try {
            double value = Double.parseDouble(text.substring(begin, at));
            if (Math.abs(value) <= Outline.LARGEST) {
                return value;
            }
        } catch (NumberFormatException e) {
            // Told below, with its place.
        }
        at = begin;
        throw refused(where, "a number from -" + (long) Outline.LARGEST + " to " + (long) Outline.LARGEST, found(), begin + 1);
    }

    private String found() {
        if (at >= text.length()) {
            return "its end";
        }
        int end = at;
        while (end < text.length() && end < at + 20 && !Character.isWhitespace(text.charAt(end)) && text.charAt(end) != ',') {
            end++;
        }
        return "'" + text.substring(at, Math.max(end, at + 1)) + "'";
    }

    private IllegalArgumentException refused(String where, String expected, String found, int column) {
        return new IllegalArgumentException(what + " " + where + " must have " + expected + " at character " + column + ", but has " + found);
    }

    private void skip() {
        while (at < text.length() && (Character.isWhitespace(text.charAt(at)) || text.charAt(at) == ',')) {
            at++;
        }
    }
}
