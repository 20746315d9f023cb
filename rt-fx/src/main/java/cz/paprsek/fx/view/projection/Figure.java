package cz.paprsek.fx.view.projection;

import cz.paprsek.math.Affine;
import cz.paprsek.math.Curve;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Body;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Shape;
import java.util.ArrayList;
import java.util.List;

/**
 * An object or operand as a projection draws it: lines in the projection's plane.
 *
 * @param lines each as u and v in turn, as it was drawn first
 * @param byU how far it has been moved since
 * @param byV how far it has been moved since
 * @param operands the same of its operands
 * @param ghost whether it takes away rather than adds, or is left out of pictures
 * @param box around the lines, its own and those of operands that add; empty for what has no end
 */
record Figure(List<double[]> lines, double byU, double byV, List<Figure> operands, boolean ghost, Box box) {
    /** How fine lines are, by the straight pieces of a circle: of all shapes, and of meshes. */
    enum Fineness {
        FINE(72, 72),
        /** If there are so many that speed counts more than smoothness. */
        COARSE(24, 24),
        /** While a hand moves it: what turns is drawn anew each time, and a large mesh could not follow. */
        MOVING(72, 12);

        private final int steps;
        private final int ofMeshes;

        Fineness(int steps, int ofMeshes) {
            this.steps = steps;
            this.ofMeshes = ofMeshes;
        }
    }

    static Figure of(Body body, Axes axes, Fineness fineness) {
        return of(body, Affine.IDENTITY, axes, fineness, false);
    }

    private static Figure of(Body body, Affine parentToWorld, Axes axes, Fineness fineness, boolean takenAway) {
        boolean ghost = takenAway || body.hidden();
        Affine toWorld = parentToWorld.after(body.placement().toParent());
        List<double[]> lines = lines(body.shape(), toWorld, axes, fineness);
        List<Figure> operands = new ArrayList<>();
        if (body.shape() instanceof Csg csg) {
            for (Operand operand : csg.operands()) {
                boolean takesAway = csg.operation() == Csg.Operation.DIFFERENCE && !operands.isEmpty();
                operands.add(of(Body.of(operand), toWorld, axes, fineness, ghost != takesAway));
            }
        }
        Box box = body.shape() instanceof Plane ? Box.EMPTY : box(lines);
        for (Figure operand : operands) {
            if (operand.ghost == ghost) {
                box = box.union(operand.box);
            }
        }
        return new Figure(lines, 0, 0, operands, ghost, box);
    }

    private static List<double[]> lines(Shape shape, Affine toWorld, Axes axes, Fineness fineness) {
        Vec3 along = toWorld.inverse().direction(axes.along());
        List<double[]> lines = new ArrayList<>();
        for (Curve curve : shape.outline(along, shape instanceof Mesh ? fineness.ofMeshes : fineness.steps)) {
            double[] line = new double[2 * curve.points().size()];
            int i = 0;
            for (Vec3 p : curve.points()) {
                line[i++] = axes.u(toWorld, p);
                line[i++] = axes.v(toWorld, p);
            }
            lines.add(line);
        }
        return lines;
    }

    private static Box box(List<double[]> lines) {
        Box box = Box.EMPTY;
        for (double[] line : lines) {
            for (int i = 0; i < line.length; i += 2) {
                box = box.with(line[i], line[i + 1]);
            }
        }
        return box;
    }

    /** How many figures are drawn for it: its operands instead of an operation. */
    int count() {
        return operands.isEmpty() ? 1 : operands.stream().mapToInt(Figure::count).sum();
    }

    /** The same elsewhere. */
    Figure moved(double u, double v) {
        return new Figure(lines, byU + u, byV + v, operands.stream().map(operand -> operand.moved(u, v)).toList(), ghost, box.moved(u, v));
    }

    /** The figure of what is at the end of a path below this one. */
    Figure at(List<Integer> path) {
        return path.isEmpty() ? this : operands.get(path.get(0)).at(path.subList(1, path.size()));
    }

    /** How far a point is from the nearest of its lines, operands' included. */
    double distance(double u, double v) {
        double nearest = Double.POSITIVE_INFINITY;
        for (double[] line : lines) {
            for (int i = 2; i < line.length; i += 2) {
                nearest = Math.min(nearest, distance(u - byU, v - byV, line[i - 2], line[i - 1], line[i], line[i + 1]));
            }
        }
        for (Figure operand : operands) {
            nearest = Math.min(nearest, operand.distance(u, v));
        }
        return nearest;
    }

    private static double distance(double u, double v, double u0, double v0, double u1, double v1) {
        double du = u1 - u0;
        double dv = v1 - v0;
        double length = du * du + dv * dv;
        double t = length == 0 ? 0 : Math.max(0, Math.min(1, ((u - u0) * du + (v - v0) * dv) / length));
        return Math.hypot(u - u0 - t * du, v - v0 - t * dv);
    }
}
