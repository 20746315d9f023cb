package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;
import static cz.paprsek.text.Numbers.text;

import cz.paprsek.shape.Block;
import cz.paprsek.shape.Capsule;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.CustomShape;
import cz.paprsek.shape.CustomSolid;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Ellipsoid;
import cz.paprsek.shape.Extrude;
import cz.paprsek.shape.Isosurface;
import cz.paprsek.shape.Lathe;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Prism;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Superellipsoid;
import cz.paprsek.shape.Text;
import cz.paprsek.shape.Torus;
import cz.paprsek.shape.height.HeightField;
import cz.paprsek.text.MadeInCode;
import java.util.List;

/** The shapes in POV-Ray's words. */
final class PovShapes {
    private static final String ORIGIN = "<0, 0, 0>";

    private PovShapes() {}

    /** One primitive in its own space, with what modifies it. */
    static String primitive(Shape shape, String modifiers) {
        return geometry(shape) + (modifiers.isEmpty() ? "" : " " + modifiers) + " }";
    }

    private static String geometry(Shape shape) {
        if (shape instanceof Sphere s) {
            return "sphere { " + ORIGIN + ", " + text(s.radius());
        } else if (shape instanceof Block b) {
            return b.rounding() > 0 ? PovRounds.block(b) : "box { " + vector(b.min()) + ", " + vector(b.max());
        } else if (shape instanceof Ellipsoid e) {
            return "sphere { " + ORIGIN + ", 1 scale " + vector(e.semiAxes());
        } else if (shape instanceof Plane) {
            return "plane { y, 0";
        } else if (shape instanceof Cylinder c) {
            return "cylinder { " + ORIGIN + ", " + vector(0, c.height(), 0) + ", " + text(c.radius());
        } else if (shape instanceof Cone c && c.sides() > 0) {
            return PovRounds.sided(c.sides(), c.radius(), c.topRadius(), c.height());
        } else if (shape instanceof Cone c) {
            return "cone { " + ORIGIN + ", " + text(c.radius()) + ", " + vector(0, c.height(), 0) + ", " + text(c.topRadius());
        } else if (shape instanceof Torus t) {
            // The default solver is fast, and loses thin rings and crossings close together.
            String torus = "torus { " + text(t.majorRadius()) + ", " + text(t.minorRadius()) + " sturm";
            return t.minorRadius() > t.majorRadius() ? PovRounds.spindle(t.majorRadius(), t.minorRadius(), torus) : torus;
        } else if (shape instanceof Capsule c) {
            return PovRounds.capsule(c);
        } else if (shape instanceof Prism p) {
            return PovRounds.sided(p.sides(), p.radius(), p.radius(), p.height());
        } else if (shape instanceof Superellipsoid s) {
            // Its poles lie on z.
            return "superellipsoid { <" + text(s.east()) + ", " + text(s.north()) + "> rotate x*90 scale " + vector(s.semiAxes());
        } else if (shape instanceof Rectangle r) {
            String first = vector(r.minX(), r.minY(), 0);
            return "polygon { 5, " + first + ", " + vector(r.maxX(), r.minY(), 0) + ", " + vector(r.maxX(), r.maxY(), 0) + ", "
                    + vector(r.minX(), r.maxY(), 0) + ", " + first;
        } else if (shape instanceof Disc d) {
            return "disc { " + ORIGIN + ", z, " + text(d.radius());
        }
        if (shape instanceof Extrude e) {
            return PovOutlines.extrude(e);
        }
        if (shape instanceof Lathe l) {
            return PovOutlines.lathe(l);
        }
        if (shape instanceof Text t) {
            return PovOutlines.letters(t);
        }
        if (shape instanceof Isosurface i) {
            return PovFormulas.isosurface(i);
        }
        if (shape instanceof HeightField field) {
            return PovPictures.heights(field);
        }
        if (shape instanceof Mesh mesh) {
            return PovMesh.of(mesh, List.of());
        }
        if (shape instanceof CustomSolid || shape instanceof CustomShape) {
            throw MadeInCode.refusedBy("a scene for POV-Ray", shape.kind(), "shape");
        }
        throw new IllegalArgumentException("a scene for POV-Ray cannot hold the shape \"" + shape.kind() + "\": nobody has found words for it yet");
    }

    /** A union in POV-Ray keeps the walls inside; ours is its merge. A single operand is itself, whatever is done. */
    static String keyword(Csg csg) {
        if (csg.operands().size() == 1) {
            return "object";
        }
        return switch (csg.operation()) {
            case UNION -> "merge";
            case DIFFERENCE -> "difference";
            case INTERSECTION -> "intersection";
        };
    }
}
