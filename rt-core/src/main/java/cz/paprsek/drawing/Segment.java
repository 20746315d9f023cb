package cz.paprsek.drawing;

import java.util.Optional;

/** A straight line on a drawing, y down. */
public record Segment(double x1, double y1, double x2, double y2) {

    /** Its part within the rectangle from 0,0 to width,height; empty if there is none. */
    public Optional<Segment> within(double width, double height) {
        double begin = 0;
        double end = 1;
        double[][] axes = {{x1, x2 - x1, width}, {y1, y2 - y1, height}};
        for (double[] axis : axes) {
            if (axis[1] == 0 && (axis[0] < 0 || axis[0] > axis[2])) {
                return Optional.empty();
            }
            if (axis[1] != 0) {
                double a = -axis[0] / axis[1];
                double b = (axis[2] - axis[0]) / axis[1];
                begin = Math.max(begin, Math.min(a, b));
                end = Math.min(end, Math.max(a, b));
            }
        }
        return begin > end ? Optional.empty() : Optional.of(part(begin, end));
    }

    public double length() {
        return Math.sqrt((x2 - x1) * (x2 - x1) + (y2 - y1) * (y2 - y1));
    }

    private Segment part(double begin, double end) {
        return new Segment(x1 + begin * (x2 - x1), y1 + begin * (y2 - y1), x1 + end * (x2 - x1), y1 + end * (y2 - y1));
    }
}
