package cz.paprsek.format.openscad;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Extrude;
import cz.paprsek.shape.Lathe;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Torus;
import cz.paprsek.shape.mesh.Triangles;
import java.util.Optional;

/** How figures of the plane become bodies. What is done to figures (union, difference …) is then done to the bodies, which comes to the same. */
interface Extrusion {
    /** From y, which is up in shapes that are round, to z. */
    Affine ROUND = Affine.rotation(new Vec3(90, 0, 0));
    /** Of a figure left of the axis that it is turned about. */
    Affine MIRRORED = Affine.scaling(new Vec3(-1, 1, 1));

    /**
     * The body of a figure.
     *
     * @param inPlane what has been done to the figure in the plane
     * @param map where the body goes
     */
    Optional<Operand> body(Figure figure, Affine inPlane, Affine map, Meshes meshes);

    /** Makes a solid of triangles. */
    interface Meshes {
        /** @param isRound whether it stands for something round, and its edges should not be seen */
        Solid solid(Triangles triangles, boolean isRound);
    }

    static Extrusion linear(Node node) throws FormatFault {
        double height = node.number("height", 100);
        double from = node.flag("center") ? -height / 2 : 0;
        double twist = node.number("twist", 0);
        double[] scale = node.numbers("scale", 2, 1);
        if (!(height > 0)) {
            return (figure, inPlane, map, meshes) -> Optional.empty();
        }
        if (twist == 0 && scale[0] == 1 && scale[1] == 1) {
            return new Straight(from, from + height);
        }
        double wanted = Math.max(node.number("slices", 1), Math.abs(twist) / 5);
        int slices = (int) Math.max(1, Math.min(1000, Math.ceil(wanted)));
        return new Twisted(from, from + height, Math.max(0, scale[0]), Math.max(0, scale[1]), twist, slices);
    }

    static Extrusion rotating(Node node) throws FormatFault {
        double angle = Math.max(-360, Math.min(360, node.number("angle", 360)));
        int sides = Bodies.sides(node);
        double fn = node.number("$fn", 0);
        int steps = sides > 0 ? sides : (int) Math.max(2, Math.ceil(Math.min(720, Math.max(fn, 120)) * Math.abs(angle) / 360));
        return new Turned(angle, steps, sides > 0);
    }

    /** Straight up: what is round stays round. */
    record Straight(double from, double to) implements Extrusion {
        @Override
        public Optional<Operand> body(Figure figure, Affine inPlane, Affine map, Meshes meshes) {
            if (figure instanceof Figure.Square square) {
                return Placing.placed(new Block(new Vec3(square.minX(), square.minY(), from), new Vec3(square.maxX(), square.maxY(), to)), map.after(inPlane));
            }
            if (figure instanceof Figure.Circle circle && circle.sides() == 0) {
                Affine up = Affine.translation(new Vec3(0, 0, from)).after(ROUND);
                return Placing.placed(new Cylinder(circle.radius(), to - from), map.after(inPlane).after(up));
            }
            return new Twisted(from, to, 1, 1, 0, 1).body(figure, inPlane, map, meshes);
        }
    }

    /** Turned or made larger on the way; of triangles only where an {@link Extrude} is another body, or would be slower. */
    record Twisted(double from, double to, double scaleX, double scaleY, double twist, int slices) implements Extrusion {
        @Override
        public Optional<Operand> body(Figure figure, Affine inPlane, Affine map, Meshes meshes) {
            double[] corners = figure.corners(inPlane);
            if (Figure.area(corners) <= 0) {
                return Optional.empty();
            }
            Optional<Outlined> outline = Outlined.of(figure, inPlane);
            if (outline.isPresent() && scaleX == scaleY && Math.abs(twist) <= Extrude.MOST_TWIST) {
                // Ours turns the other way.
                double turn = twist == 0 ? 0 : -twist;
                return Placing.placed(new Extrude(outline.get().path(), outline.get().points(), to - from, turn, scaleX), map.after(Affine.translation(new Vec3(0, 0, from))));
            }
            boolean isRound = twist != 0 || figure.isRound();
            return Placing.placed(meshes.solid(Sweep.up(corners, from, to, scaleX, scaleY, twist, slices), isRound), map);
        }
    }

    /** Around the z axis; of triangles only where a {@link Lathe} is another body, or would be slower. */
    record Turned(double angle, int steps, boolean isFaceted) implements Extrusion {
        @Override
        public Optional<Operand> body(Figure figure, Affine inPlane, Affine map, Meshes meshes) {
            if (figure instanceof Figure.Circle circle && circle.sides() == 0 && !isFaceted && Math.abs(angle) == 360) {
                double scale = inPlane.uniformScale();
                double distance = Math.abs(inPlane.xt());
                if (scale > 0 && distance > circle.radius() * scale) {
                    Affine up = Affine.translation(new Vec3(0, 0, inPlane.yt())).after(ROUND);
                    return Placing.placed(new Torus(distance, circle.radius() * scale), map.after(up));
                }
            }
            double[] corners = figure.corners(inPlane);
            double least = Double.POSITIVE_INFINITY;
            double most = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < corners.length; i += 2) {
                least = Math.min(least, corners[i]);
                most = Math.max(most, corners[i]);
            }
            if (Figure.area(corners) <= 0 || (least < -1e-6 * most && most > 0) || angle == 0) {
                return Optional.empty();
            }
            boolean isLeft = most <= 0;
            double slack = 1e-6 * Math.max(most, -least);
            Optional<Outlined> outline = isFaceted ? Optional.empty() : Outlined.rightOfAxis(figure, isLeft ? MIRRORED.after(inPlane) : inPlane, slack);
            if (outline.isPresent()) {
                double first = (isLeft ? 180 : 0) + (angle < 0 && angle > -360 ? angle : 0);
                Affine up = Affine.rotation(new Vec3(0, 0, first)).after(ROUND);
                return Placing.placed(new Lathe(outline.get().path(), outline.get().points(), Math.abs(angle)), map.after(up));
            }
            for (int i = 0; i < corners.length; i += 2) {
                corners[i] = most > 0 && Math.abs(corners[i]) <= 1e-6 * most ? 0 : corners[i];
            }
            return Placing.placed(meshes.solid(Sweep.around(corners, angle, steps), !isFaceted), map);
        }
    }
}
