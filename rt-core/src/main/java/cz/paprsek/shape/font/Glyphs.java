package cz.paprsek.shape.font;

import java.util.ArrayList;
import java.util.List;

/**
 * The outlines of a font: the tables loca and glyf.
 *
 * @source OpenType 1.9, glyf
 */
final class Glyphs {
    private static final int ON_CURVE = 1;
    private static final int SHORT_X = 2;
    private static final int SHORT_Y = 4;
    private static final int REPEATS = 8;
    private static final int SAME_OR_POSITIVE_X = 16;
    private static final int SAME_OR_POSITIVE_Y = 32;
    private static final int WORDS = 1;
    private static final int OFFSETS = 2;
    private static final int SCALE = 8;
    private static final int MORE = 32;
    private static final int TWO_SCALES = 64;
    private static final int MATRIX = 128;
    /** Of how many glyphs one may be put together, those within others counted. */
    private static final int MOST_COMPONENTS = 256;
    private static final int DEEPEST = 8;
    private static final int MOST_POINTS = 20_000;

    private final Table loca;
    private final Table glyf;
    private final boolean isLong;
    private final int count;

    /**
     * @param isLong whether places are numbers of 4 bytes
     * @param count how many glyphs there are
     */
    Glyphs(Table loca, Table glyf, boolean isLong, int count) {
        this.loca = loca;
        this.glyf = glyf;
        this.isLong = isLong;
        this.count = count;
    }

    /** A point of a contour, font units. */
    private record Point(double x, double y, boolean isOn) {
        Point between(Point other) {
            return new Point((x + other.x) / 2, (y + other.y) / 2, true);
        }

        Point moved(double[] map) {
            return new Point(map[0] * x + map[2] * y + map[4], map[1] * x + map[3] * y + map[5], isOn);
        }
    }

    /** The outline of a glyph as path data of SVG, font units, y up; empty if it shows nothing. */
    String path(int glyph) {
        List<List<Point>> contours = new ArrayList<>();
        collect(glyph, new double[] {1, 0, 0, 1, 0, 0}, 0, new int[1], contours);
        StringBuilder path = new StringBuilder();
        contours.forEach(contour -> write(contour, path));
        return path.toString();
    }

    private long place(int glyph) {
        return isLong ? loca.unsigned32(4L * glyph) : 2L * loca.unsigned16(2L * glyph);
    }

    private void collect(int glyph, double[] map, int depth, int[] components, List<List<Point>> into) {
        if (glyph >= count) {
            throw loca.refused(0, "places of more than " + glyph + " glyphs", count);
        }
        long from = place(glyph);
        if (place(glyph + 1) <= from) {
            return;
        }
        Table data = glyf.at(from);
        int contours = data.signed16(0);
        if (contours >= 0) {
            simple(data, contours, map, into);
            return;
        }
        if (depth >= DEEPEST) {
            throw data.refused(0, "a glyph that is made of others no deeper than " + DEEPEST + " levels", depth + 1);
        }
        long at = 10;
        int flags;
        do {
            if (++components[0] > MOST_COMPONENTS) {
                throw data.refused(at, "no more than " + MOST_COMPONENTS + " parts of a glyph", components[0]);
            }
            flags = data.unsigned16(at);
            int part = data.unsigned16(at + 2);
            if ((flags & OFFSETS) == 0) {
                throw data.refused(at, "a part of a glyph that is placed by its offset, and not by its points,", flags);
            }
            boolean areWords = (flags & WORDS) != 0;
            double dx = areWords ? data.signed16(at + 4) : (byte) data.unsigned8(at + 4);
            double dy = areWords ? data.signed16(at + 6) : (byte) data.unsigned8(at + 5);
            at += areWords ? 8 : 6;
            double[] own = {1, 0, 0, 1, dx, dy};
            if ((flags & SCALE) != 0) {
                own[0] = scale(data, at);
                own[3] = own[0];
                at += 2;
            } else if ((flags & TWO_SCALES) != 0) {
                own[0] = scale(data, at);
                own[3] = scale(data, at + 2);
                at += 4;
            } else if ((flags & MATRIX) != 0) {
                for (int i = 0; i < 4; i++) {
                    own[i] = scale(data, at + 2L * i);
                }
                at += 8;
            }
            collect(part, after(map, own), depth + 1, components, into);
        } while ((flags & MORE) != 0);
    }

    /** A number of 2 bits before the point and 14 behind it. */
    private static double scale(Table data, long at) {
        return data.signed16(at) / 16384.0;
    }

    private static double[] after(double[] outer, double[] inner) {
        return new double[] {
            outer[0] * inner[0] + outer[2] * inner[1], outer[1] * inner[0] + outer[3] * inner[1],
            outer[0] * inner[2] + outer[2] * inner[3], outer[1] * inner[2] + outer[3] * inner[3],
            outer[0] * inner[4] + outer[2] * inner[5] + outer[4], outer[1] * inner[4] + outer[3] * inner[5] + outer[5]};
    }

    private static void simple(Table data, int contours, double[] map, List<List<Point>> into) {
        if (contours == 0) {
            return;
        }
        int points = data.unsigned16(8 + 2L * contours) + 1;
        int known = into.stream().mapToInt(List::size).sum();
        if (points + known > MOST_POINTS) {
            throw data.refused(8 + 2L * contours, "the last of no more than " + MOST_POINTS + " points of a glyph", points + known);
        }
        long at = 12 + 2L * contours + data.unsigned16(10 + 2L * contours);
        int[] flags = new int[points];
        for (int i = 0; i < points;) {
            int flag = data.unsigned8(at++);
            int times = (flag & REPEATS) != 0 ? data.unsigned8(at++) + 1 : 1;
            for (int k = 0; k < times && i < points; k++) {
                flags[i++] = flag;
            }
        }
        double[] x = new double[points];
        at = coordinates(data, at, flags, SHORT_X, SAME_OR_POSITIVE_X, x);
        double[] y = new double[points];
        coordinates(data, at, flags, SHORT_Y, SAME_OR_POSITIVE_Y, y);
        int first = 0;
        for (int i = 0; i < contours; i++) {
            int end = data.unsigned16(10 + 2L * i) + 1;
            if (end <= first || end > points) {
                throw data.refused(10 + 2L * i, "the last point of a contour, from " + first + " to " + points + ",", end - 1);
            }
            List<Point> contour = new ArrayList<>();
            for (int k = first; k < end; k++) {
                contour.add(new Point(x[k], y[k], (flags[k] & ON_CURVE) != 0).moved(map));
            }
            into.add(contour);
            first = end;
        }
    }

    private static long coordinates(Table data, long from, int[] flags, int isShort, int isSame, double[] into) {
        long at = from;
        int value = 0;
        for (int i = 0; i < flags.length; i++) {
            boolean same = (flags[i] & isSame) != 0;
            if ((flags[i] & isShort) != 0) {
                value += same ? data.unsigned8(at) : -data.unsigned8(at);
                at++;
            } else if (!same) {
                value += data.signed16(at);
                at += 2;
            }
            into[i] = value;
        }
        return at;
    }

    /** Between two points that are off the curve lies one that is on it. */
    private static void write(List<Point> contour, StringBuilder path) {
        int size = contour.size();
        if (size < 2) {
            return;
        }
        int begin = 0;
        while (begin < size && !contour.get(begin).isOn()) {
            begin++;
        }
        Point start = begin < size ? contour.get(begin) : contour.get(0).between(contour.get(size - 1));
        begin = begin < size ? begin + 1 : 0;
        int steps = begin > 0 ? size - 1 : size;
        append(path, 'M', start);
        for (int i = 0; i < steps; i++) {
            Point point = contour.get((begin + i) % size);
            if (point.isOn()) {
                append(path, 'L', point);
                continue;
            }
            Point next = i + 1 < steps ? contour.get((begin + i + 1) % size) : start;
            append(path, 'Q', point);
            append(path, ' ', next.isOn() ? next : point.between(next));
            i += next.isOn() ? 1 : 0;
        }
        path.append('Z');
    }

    private static void append(StringBuilder path, char command, Point point) {
        path.append(command).append(point.x()).append(' ').append(point.y());
    }
}
