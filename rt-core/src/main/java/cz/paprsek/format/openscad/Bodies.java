package cz.paprsek.format.openscad;

import cz.paprsek.format.model.FormatFault;
import cz.paprsek.format.model.Polygon;
import cz.paprsek.math.Affine;
import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Solid;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.mesh.Triangles;
import java.util.List;
import java.util.Optional;

/**
 * The bodies that need no others. What is round is exactly round, but for those with a {@code $fn} from 3 to {@value #MOST_SIDES}: so few sides are meant, as of a nut, and
 * are made as OpenSCAD makes them.
 */
final class Bodies {
    static final int MOST_SIDES = 12;

    private final Extrusion.Meshes meshes;

    Bodies(Extrusion.Meshes meshes) {
        this.meshes = meshes;
    }

    /** How many sides stand for what is round; 0 if it is to be round. */
    static int sides(Node node) throws FormatFault {
        double wanted = node.number("$fn", 0);
        return wanted >= 3 && wanted < MOST_SIDES + 1 ? (int) wanted : 0;
    }

    Optional<Operand> cube(Node node, Affine map) throws FormatFault {
        double[] size = node.numbers("size", 3, 1);
        if (!(size[0] > 0 && size[1] > 0 && size[2] > 0)) {
            return Optional.empty();
        }
        Vec3 all = new Vec3(size[0], size[1], size[2]);
        Vec3 min = node.flag("center") ? all.times(-0.5) : Vec3.ZERO;
        return Placing.placed(new Block(min, min.plus(all)), map);
    }

    Optional<Operand> sphere(Node node, Affine map) throws FormatFault {
        double radius = node.number("r", 1);
        if (!(radius > 0)) {
            return Optional.empty();
        }
        int sides = sides(node);
        return Placing.placed(sides == 0 ? new Sphere(radius) : meshes.solid(globe(radius, sides), false), map);
    }

    /** Rings of corners halfway between what would be equal angles from pole to pole. */
    private static Triangles globe(double radius, int sides) {
        Triangles.Builder builder = Triangles.builder();
        int rings = (sides + 1) / 2;
        for (int i = 0; i < rings; i++) {
            double angle = Math.PI * (i + 0.5) / rings;
            double[] ring = Figure.ring(radius * StrictMath.sin(angle), sides);
            for (int k = 0; k < sides; k++) {
                builder.vertex(ring[2 * k], ring[2 * k + 1], radius * StrictMath.cos(angle));
            }
        }
        for (int k = 0; k < sides; k++) {
            int next = (k + 1) % sides;
            for (int i = 0; i + 1 < rings; i++) {
                builder.triangle(i * sides + k, (i + 1) * sides + k, (i + 1) * sides + next);
                builder.triangle(i * sides + k, (i + 1) * sides + next, i * sides + next);
            }
            if (k > 0 && next > 0) {
                builder.triangle(0, k, next);
                builder.triangle((rings - 1) * sides, (rings - 1) * sides + next, (rings - 1) * sides + k);
            }
        }
        return builder.build().oriented();
    }

    Optional<Operand> cylinder(Node node, Affine map) throws FormatFault {
        double height = node.number("h", 1);
        double bottom = node.number("r1", node.number("r", 1));
        double top = node.number("r2", node.number("r", 1));
        if (!(height > 0) || !(bottom >= 0 && top >= 0) || bottom + top == 0) {
            return Optional.empty();
        }
        double from = node.flag("center") ? -height / 2 : 0;
        int sides = sides(node);
        if (sides > 0) {
            double[] corners = Figure.ring(Math.max(bottom, top), sides);
            boolean isUpright = bottom >= top;
            Triangles body = Sweep.up(corners, isUpright ? from : from + height, isUpright ? from + height : from, Math.min(bottom, top) / Math.max(bottom, top),
                    Math.min(bottom, top) / Math.max(bottom, top), 0, 1);
            return Placing.placed(meshes.solid(body, false), map);
        }
        boolean isUpright = bottom > 0;
        Solid solid = bottom == top ? new Cylinder(bottom, height) : isUpright ? new Cone(bottom, top, height) : new Cone(top, 0, height);
        Affine up = Affine.translation(new Vec3(0, 0, isUpright ? from : from + height)).after(isUpright ? Extrusion.ROUND : Affine.rotation(new Vec3(-90, 0, 0)));
        return Placing.placed(solid, map.after(up));
    }

    /** Faces are listed clockwise as seen from outside. */
    Optional<Operand> polyhedron(Node node, Affine map) throws FormatFault {
        List<Value> points = node.list("points");
        List<Value> faces = node.list("faces").isEmpty() ? node.list("triangles") : node.list("faces");
        Triangles.Builder builder = Triangles.builder();
        double[] places = new double[3 * points.size()];
        for (int i = 0; i < points.size(); i++) {
            double[] place = node.vector(points.get(i), 3, "points");
            builder.vertex(place[0], place[1], place[2]);
            System.arraycopy(place, 0, places, 3 * i, 3);
        }
        Polygon polygon = new Polygon();
        for (Value face : faces) {
            polygon.clear();
            for (int corner : node.indexes(face, points.size(), "faces")) {
                polygon.add(corner, places[3 * corner], places[3 * corner + 1], places[3 * corner + 2]);
            }
            if (polygon.count() >= 3) {
                polygon.cut((a, b, c) -> {
                    if (a != b && b != c && a != c) {
                        builder.triangle(a, c, b);
                    }
                });
            }
        }
        return builder.triangleCount() == 0 ? Optional.empty() : Placing.placed(meshes.solid(builder.build().oriented(), false), map);
    }
}
