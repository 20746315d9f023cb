package cz.paprsek.shape.outline;

import cz.paprsek.ray.Line;

/** From one corner to the next. */
final class Straight extends Piece {
    Straight(double x0, double y0, double x1, double y1) {
        super(x0, y0, x1, y1);
    }

    @Override
    double x(double u) {
        return x0 + u * (x1 - x0);
    }

    @Override
    double y(double u) {
        return y0 + u * (y1 - y0);
    }

    @Override
    double dx(double u) {
        return x1 - x0;
    }

    @Override
    double dy(double u) {
        return y1 - y0;
    }

    @Override
    double[] controls() {
        return new double[] {x0, y0, x(1.0 / 3), y(1.0 / 3), x(2.0 / 3), y(2.0 / 3), x1, y1};
    }

    @Override
    double parameter(double x, double y) {
        double dx = x1 - x0;
        double dy = y1 - y0;
        return Math.max(0, Math.min(1, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy)));
    }

    @Override
    void cross(double a, double b, double c, int face, Line out) {
        double from = a * x0 + b * y0 + c;
        double to = a * x1 + b * y1 + c;
        if (isAbove(from) != isAbove(to)) {
            double u = from / (from - to);
            double start = b * x0 - a * y0;
            out.cross(start + u * (b * (x1 - x0) - a * (y1 - y0)), isAbove(to) ? face + 1 : face);
        }
    }
}
