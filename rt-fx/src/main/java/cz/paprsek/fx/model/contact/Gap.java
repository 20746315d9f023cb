package cz.paprsek.fx.model.contact;

import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import org.jspecify.annotations.Nullable;

/**
 * The way between moved bodies and another one, on all lines along an axis: the shortest way is that to their contact. It is looked for on a lattice of lines
 * first, and then about the best of these by dividing intervals, one within the other. That finds it exactly where both are convex, else nearly always. Any
 * line is a lower bound of it, so that most are given up after a few.
 */
final class Gap {
    private static final int LINES = 15;
    private static final int SAMPLES = 9;
    private static final int DIVISIONS = 30;
    private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;
    /** So far within the borders, in parts of the size: what grazes a side may miss it. */
    private static final double INSET = 1e-9;
    /** A line on which there is no way is worse than any with one, the more so the farther it is from these. */
    private static final double NONE = -1e30;
    /** As near to the best of a line, and of all lines, scene units. */
    private static final double INNER = 1e-9;
    private static final double OUTER = 1e-8;

    private final Axis axis;
    private final Bounds box;
    private final Moved moved;
    private final Surface other;
    private final Work work;
    private final boolean isFromWithout;
    private final Axis across;
    private final Axis aside;
    private final double middle;
    private final double[] us;
    private final double[] vs;
    private final Ray ray = new Ray(new Spans());
    private @Nullable Moved near;
    private final Map<Found, Touch> known = new HashMap<>();
    private final @Nullable Way[][] ways;

    /**
     * A contact.
     *
     * @param by how far the bodies are moved then
     * @param place where along the axis they touch the other one
     */
    record Touch(double by, double place) {}

    /** The best line of the lattice. */
    private record Best(boolean isAbove, int i, int j, double value) {}

    /** What a search began with: the best line, and of how many on which there is a way. */
    private record Found(Best best, int count) {}

    /** On one line, seen from the middle of the box. */
    private static final class Way {
        /** Where the bodies begin and end; not a number if the line misses them. */
        private final double least;
        private final double most;
        /** Where the line meets the other body, sorted. */
        private final double[] others;
        private final boolean isFromWithout;

        Way(double least, double most, double[] others, boolean isFromWithout) {
            this.least = least;
            this.most = most;
            this.others = others;
            this.isFromWithout = isFromWithout;
        }

        /** How far the other one is above the lower side of the bodies, if it is below their middle, or the other way round; else not a number. */
        double value(boolean isAbove, double by) {
            double place = place(isAbove, by);
            return isAbove ? most - place : place - least;
        }

        double place(boolean isAbove, double by) {
            double centre = (least + most) / 2 + by;
            double found = Double.NaN;
            if (isFromWithout && Arrays.stream(others).filter(one -> one > centre).count() % 2 != 0) {
                return found;
            }
            for (double one : others) {
                found = !isAbove && one <= centre ? one : isAbove && one >= centre && Double.isNaN(found) ? one : found;
            }
            return found;
        }
    }

    /**
     * A way.
     *
     * @param box around the bodies as they have been moved before
     * @param isFromWithout whether it counts only where the middle of the bodies is not within the other one
     */
    Gap(Moved moved, Bounds box, Surface other, Work work, boolean isFromWithout) {
        this.isFromWithout = isFromWithout;
        this.axis = moved.axis();
        this.box = box;
        this.moved = moved;
        this.other = other;
        this.work = work;
        across = moved.across();
        aside = moved.aside();
        middle = axis.of(box.middle());
        us = lines(across);
        vs = lines(aside);
        ways = new Way[us.length][vs.length];
    }

    private double[] lines(Axis side) {
        double least = Math.max(side.least(box), side.least(other.bounds()));
        double most = Math.min(side.most(box), side.most(other.bounds()));
        double inset = INSET * (most - least);
        double[] lines = new double[most < least ? 0 : LINES];
        for (int i = 0; i < lines.length; i++) {
            lines[i] = least + inset + (most - least - 2 * inset) * i / (LINES - 1);
        }
        return lines;
    }

    boolean isInTheWay() {
        return us.length > 0 && vs.length > 0;
    }

    Bounds other() {
        return other.bounds();
    }

    /**
     * How far from a contact the bodies are by their boxes, about; infinite where there is none within reach.
     *
     * @param reach how far from it they may be
     */
    double estimate(boolean isAbove, double by, double reach) {
        Bounds there = other.bounds();
        if (axis.least(there) - axis.most(box) > by + reach || axis.most(there) - axis.least(box) < by - reach) {
            return Double.POSITIVE_INFINITY;
        }
        Moved here = near();
        if (here.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        double most = isAbove ? here.most() - axis.least(there) : axis.most(there) - here.least();
        double far = most - (isAbove ? -by : by);
        // Of what has no end the box says nothing.
        return far < -reach ? Double.POSITIVE_INFINITY : there.isFinite() && Double.isFinite(far) ? Math.abs(far) : 0;
    }

    private Moved near() {
        Moved found = near == null ? moved.within(us[0], us[LINES - 1], vs[0], vs[LINES - 1]) : near;
        near = found;
        return found;
    }

    /**
     * The contact of the bodies with what is below them, or above, when they are moved.
     *
     * @param reach how far from it they may be
     */
    Optional<Touch> touch(boolean isAbove, double by, double reach) {
        double aim = isAbove ? -by : by;
        Best best = new Best(isAbove, -1, -1, Double.NEGATIVE_INFINITY);
        double u = 0;
        double v = 0;
        int count = 0;
        for (int n = 0; n < LINES * LINES; n++) {
            // From the middle, where most of what is too far is found to be.
            int line = (n + LINES * LINES / 2) % (LINES * LINES);
            int i = line / LINES;
            int j = line % LINES;
            Way way = ways[i][j];
            if (way == null) {
                if (work.isOver()) {
                    return Optional.empty();
                }
                way = way(us[i], vs[j]);
                ways[i][j] = way;
            }
            double value = way.value(isAbove, by);
            if (value > aim + reach) {
                return Optional.empty();
            }
            if (!Double.isNaN(value)) {
                u += us[i];
                v += vs[j];
                count++;
                best = value > best.value ? new Best(isAbove, i, j, value) : best;
            }
        }
        double cell = Math.max(us[LINES - 1] - us[0], vs[LINES - 1] - vs[0]) / (LINES - 1);
        if (count == 0 || best.value < aim - reach - 4 * cell) {
            return Optional.empty();
        }
        Found start = new Found(best, count);
        Touch found = known.get(start);
        if (found == null) {
            if (work.isOver()) {
                return Optional.empty();
            }
            found = search(best, by, u / count, v / count);
            known.put(start, found);
        }
        return Optional.of(found);
    }

    /** @param u a line that is not far from any, which those without a way are drawn to */
    private Touch search(Best best, double by, double u, double v) {
        double[] at = {us[best.i], vs[best.j]};
        double[] most = {Double.NEGATIVE_INFINITY};
        DoubleUnaryOperator outer = x -> {
            DoubleUnaryOperator inner = y -> {
                double value = way(x, y).value(best.isAbove, by);
                if (Double.isNaN(value)) {
                    return NONE * (1 + Math.hypot(x - u, y - v));
                }
                if (value > most[0]) {
                    most[0] = value;
                    at[0] = x;
                    at[1] = y;
                }
                return value;
            };
            double[] ys = samples(vs);
            int k = 0;
            double highest = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < ys.length; i++) {
                double value = inner.applyAsDouble(ys[i]);
                if (value > highest) {
                    highest = value;
                    k = i;
                }
            }
            return Math.max(highest, highest(inner, ys[Math.max(0, k - 1)], ys[Math.min(ys.length - 1, k + 1)], INNER));
        };
        double value = Math.max(outer.applyAsDouble(us[best.i]), highest(outer, us[Math.max(0, best.i - 1)], us[Math.min(LINES - 1, best.i + 1)], OUTER));
        double place = way(at[0], at[1]).place(best.isAbove, by);
        return new Touch(best.isAbove ? -value : value, middle + place);
    }

    private static double[] samples(double[] lines) {
        double[] samples = new double[SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            samples[i] = lines[0] + (lines[LINES - 1] - lines[0]) * i / (SAMPLES - 1);
        }
        return samples;
    }

    /** The highest value between two places, by the golden section, until it cannot be higher by more than what is left out; of concave functions at least. */
    private static double highest(DoubleUnaryOperator function, double from, double to, double leftOut) {
        double a = from;
        double b = to;
        double x = b - GOLDEN * (b - a);
        double y = a + GOLDEN * (b - a);
        double atA = Double.NEGATIVE_INFINITY;
        double atB = Double.NEGATIVE_INFINITY;
        double atX = function.applyAsDouble(x);
        double atY = function.applyAsDouble(y);
        double highest = Math.max(atX, atY);
        for (int i = 0; i < DIVISIONS && a < x && x < y && y < b; i++) {
            double rise = (atY - atX) / (y - x);
            double beside = Math.max(atY + Math.max(0, rise) * (b - y), atX + Math.max(0, -rise) * (x - a));
            double between = (y - x) * Math.max(0, Math.min((atX - atA) / (x - a), (atY - atB) / (b - y)));
            if (Math.max(beside, Math.max(atX, atY) + between) - highest < leftOut) {
                break;
            }
            if (atX < atY) {
                a = x;
                atA = atX;
                x = y;
                atX = atY;
                y = a + GOLDEN * (b - a);
                atY = function.applyAsDouble(y);
            } else {
                b = y;
                atB = atY;
                y = x;
                atY = atX;
                x = b - GOLDEN * (b - a);
                atX = function.applyAsDouble(x);
            }
            highest = Math.max(highest, Math.max(atX, atY));
        }
        return highest;
    }

    /** Only the first and the last of the bodies count, which are looked for from without. */
    private Way way(double u, double v) {
        double least = Double.NaN;
        double most = Double.NaN;
        for (Moved.Part part : near().upwards()) {
            if (!Double.isNaN(least) && part.least() >= least + middle) {
                break;
            }
            double[] crossed = part.isOn(u, v) ? crossings(part.surface(), u - moved.byU(), v - moved.byV()) : new double[0];
            if (crossed.length > 0) {
                least = Double.isNaN(least) ? crossed[0] : Math.min(least, crossed[0]);
                most = Double.isNaN(most) ? crossed[crossed.length - 1] : Math.max(most, crossed[crossed.length - 1]);
            }
        }
        if (Double.isNaN(least)) {
            return new Way(least, most, new double[0], isFromWithout);
        }
        for (Moved.Part part : near().downwards()) {
            if (part.most() <= most + middle) {
                break;
            }
            double[] crossed = part.isOn(u, v) ? crossings(part.surface(), u - moved.byU(), v - moved.byV()) : new double[0];
            most = crossed.length == 0 ? most : Math.max(most, crossed[crossed.length - 1]);
        }
        return new Way(least, most, crossings(other, u, v), isFromWithout);
    }

    /** Where a line along the axis meets a surface, seen from the middle of the box. */
    private double[] crossings(Surface surface, double u, double v) {
        Vec3 from = across.times(u).plus(aside.times(v)).plus(axis.times(middle));
        Vec3 way = axis.times(1);
        work.ask();
        Spans spans = ray.spans;
        ray.start(from.x(), from.y(), from.z(), way.x(), way.y(), way.z());
        ray.min = Double.NEGATIVE_INFINITY;
        int mark = spans.size();
        surface.crossings(ray, spans);
        double[] found = new double[spans.size() - mark];
        int count = 0;
        for (int i = mark; i < spans.size(); i++) {
            if (Double.isFinite(spans.t(i))) {
                found[count++] = spans.t(i);
            }
        }
        spans.release(mark);
        double[] sorted = Arrays.copyOf(found, count);
        Arrays.sort(sorted);
        return sorted;
    }
}
