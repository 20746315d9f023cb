package cz.paprsek.format.openscad;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** The outlines of a polygon: what lies within an even number of others is body, within an odd number hole. */
final class Paths {
    private static final int MOST = 2000;

    private final List<double[]> paths = new ArrayList<>();

    private Paths() {}

    /** Makes bodies of one outline. */
    interface Maker {
        List<Operand> bodies(Figure path) throws IOException;
    }

    static Paths of(Node node) throws FormatFault {
        List<Value> points = node.list("points");
        Paths all = new Paths();
        List<Value> paths = node.list("paths");
        if (paths.size() > MOST) {
            throw node.fault("a polygon may have at most " + MOST + " paths, but has " + paths.size());
        }
        if (paths.isEmpty()) {
            double[] outline = new double[2 * points.size()];
            for (int i = 0; i < points.size(); i++) {
                System.arraycopy(node.vector(points.get(i), 2, "points"), 0, outline, 2 * i, 2);
            }
            all.add(outline);
        }
        for (Value path : paths) {
            int[] corners = node.indexes(path, points.size(), "paths");
            double[] outline = new double[2 * corners.length];
            for (int i = 0; i < corners.length; i++) {
                System.arraycopy(node.vector(points.get(corners[i]), 2, "points"), 0, outline, 2 * i, 2);
            }
            all.add(outline);
        }
        return all;
    }

    private void add(double[] outline) {
        if (outline.length >= 6 && Figure.area(outline) != 0) {
            paths.add(outline);
        }
    }

    /** One for each outline that is not a hole, less the holes right within it. */
    List<Operand> bodies(Maker maker) throws IOException {
        int[] depths = new int[paths.size()];
        for (int i = 0; i < depths.length; i++) {
            for (int j = 0; j < depths.length; j++) {
                depths[i] += i != j && isWithin(paths.get(i), paths.get(j)) ? 1 : 0;
            }
        }
        List<Operand> all = new ArrayList<>();
        for (int i = 0; i < depths.length; i++) {
            if (depths[i] % 2 == 0) {
                List<Operand> operands = new ArrayList<>(maker.bodies(new Figure.Path(paths.get(i))));
                for (int j = 0; j < depths.length && !operands.isEmpty(); j++) {
                    if (depths[j] == depths[i] + 1 && isWithin(paths.get(j), paths.get(i))) {
                        operands.addAll(maker.bodies(new Figure.Path(paths.get(j))));
                    }
                }
                if (operands.size() > 1) {
                    all.add(Operand.of(new Csg(Csg.Operation.DIFFERENCE, operands)).madeOf(operands.get(0).material()));
                } else {
                    all.addAll(operands);
                }
            }
        }
        return all;
    }

    /** Whether the first corner of one outline lies in another. */
    private static boolean isWithin(double[] one, double[] other) {
        boolean isWithin = false;
        for (int i = 0, j = other.length - 2; i < other.length; j = i, i += 2) {
            if ((other[i + 1] > one[1]) != (other[j + 1] > one[1])
                    && one[0] < (other[j] - other[i]) * (one[1] - other[i + 1]) / (other[j + 1] - other[i + 1]) + other[i]) {
                isWithin = !isWithin;
            }
        }
        return isWithin;
    }
}
