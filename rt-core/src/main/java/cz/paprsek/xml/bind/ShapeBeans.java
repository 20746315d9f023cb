package cz.paprsek.xml.bind;

import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Capsule;
import cz.paprsek.shape.Cone;
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
import cz.paprsek.xml.mistake.Problems;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlRootElement;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import java.util.Arrays;
import java.util.stream.Stream;

/** One bean for each primitive: its element, and the attributes of that. */
final class ShapeBeans {
    private ShapeBeans() {}

    /** All there are, operations too. */
    static Stream<Class<?>> all() {
        return Stream.of(ShapeBeans.class, CsgBean.class).flatMap(holder -> Arrays.stream(holder.getDeclaredClasses()));
    }

    @XmlRootElement(name = "sphere")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class SphereBean extends ShapeBean {
        @XmlAttribute(required = true) double radius;

        @Override
        Shape toShape(Problems problems) {
            return new Sphere(radius);
        }
    }

    @XmlRootElement(name = "block")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class BlockBean extends ShapeBean {
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 min = Vec3.ZERO;
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 max = Vec3.ZERO;
        @XmlAttribute double rounding;

        @Override
        Shape toShape(Problems problems) {
            return new Block(min, max, rounding);
        }
    }

    @XmlRootElement(name = "ellipsoid")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class EllipsoidBean extends ShapeBean {
        @XmlAttribute(required = true, name = "semi-axes") @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 semiAxes = Vec3.ZERO;

        @Override
        Shape toShape(Problems problems) {
            return new Ellipsoid(semiAxes);
        }
    }

    @XmlRootElement(name = "rectangle")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class RectangleBean extends ShapeBean {
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Pair.class) double[] min = {0, 0};
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Pair.class) double[] max = {0, 0};

        @Override
        Shape toShape(Problems problems) {
            return new Rectangle(min[0], min[1], max[0], max[1]);
        }
    }

    @XmlRootElement(name = "disc")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class DiscBean extends ShapeBean {
        @XmlAttribute(required = true) double radius;

        @Override
        Shape toShape(Problems problems) {
            return new Disc(radius);
        }
    }

    @XmlRootElement(name = "plane")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class PlaneBean extends ShapeBean {
        @Override
        Shape toShape(Problems problems) {
            return new Plane();
        }
    }

    @XmlRootElement(name = "cylinder")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class CylinderBean extends ShapeBean {
        @XmlAttribute(required = true) double radius;
        @XmlAttribute(required = true) double height;

        @Override
        Shape toShape(Problems problems) {
            return new Cylinder(radius, height);
        }
    }

    @XmlRootElement(name = "cone")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class ConeBean extends ShapeBean {
        @XmlAttribute(required = true) double radius;
        @XmlAttribute(name = "top-radius") double topRadius;
        @XmlAttribute(required = true) double height;
        @XmlAttribute int sides;

        @Override
        Shape toShape(Problems problems) {
            return new Cone(radius, topRadius, height, sides);
        }
    }

    @XmlRootElement(name = "capsule")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class CapsuleBean extends ShapeBean {
        @XmlAttribute(required = true) double radius;
        @XmlAttribute(required = true) double height;

        @Override
        Shape toShape(Problems problems) {
            return new Capsule(radius, height);
        }
    }

    @XmlRootElement(name = "prism")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class PrismBean extends ShapeBean {
        @XmlAttribute int sides = 6;
        @XmlAttribute(required = true) double radius;
        @XmlAttribute(required = true) double height;

        @Override
        Shape toShape(Problems problems) {
            return new Prism(sides, radius, height);
        }
    }

    @XmlRootElement(name = "superellipsoid")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class SuperellipsoidBean extends ShapeBean {
        @XmlAttribute(required = true, name = "semi-axes") @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 semiAxes = Vec3.ZERO;
        @XmlAttribute double east = 1;
        @XmlAttribute double north = 1;

        @Override
        Shape toShape(Problems problems) {
            return new Superellipsoid(semiAxes, east, north);
        }
    }

    @XmlRootElement(name = "extrude")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class ExtrudeBean extends ShapeBean {
        @XmlAttribute String path = "";
        @XmlAttribute String points = "";
        @XmlAttribute(required = true) double height;
        @XmlAttribute double twist;
        @XmlAttribute double taper = 1;

        @Override
        Shape toShape(Problems problems) {
            return new Extrude(path, points, height, twist, taper);
        }
    }

    @XmlRootElement(name = "lathe")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class LatheBean extends ShapeBean {
        @XmlAttribute String path = "";
        @XmlAttribute String points = "";
        @XmlAttribute double angle = 360;

        @Override
        Shape toShape(Problems problems) {
            return new Lathe(path, points, angle);
        }
    }

    @XmlRootElement(name = "text")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class TextBean extends ShapeBean {
        @XmlAttribute(required = true) String value = "";
        @XmlAttribute String font = Text.USUAL_FONT;
        @XmlAttribute double size = 1;
        @XmlAttribute double depth = 0.2;

        @Override
        Shape toShape(Problems problems) {
            return new Text(value, font, size, depth, Text.Content.UNREAD);
        }
    }

    @XmlRootElement(name = "isosurface")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class IsosurfaceBean extends ShapeBean {
        @XmlAttribute(required = true) String expression = "";
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 min = new Vec3(-1, -1, -1);
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 max = Vec3.ONE;

        @Override
        Shape toShape(Problems problems) {
            return new Isosurface(expression, min, max);
        }
    }

    @XmlRootElement(name = "height-field")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class HeightFieldBean extends ShapeBean {
        @XmlAttribute(required = true) String file = "";
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 extent = Vec3.ONE;
        @XmlAttribute boolean smooth;

        @Override
        Shape toShape(Problems problems) {
            return new HeightField(file, extent, smooth, HeightField.Content.UNREAD);
        }
    }

    @XmlRootElement(name = "mesh")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class MeshBean extends ShapeBean {
        @XmlAttribute(required = true) String file = "";
        @XmlAttribute String part = "";
        @XmlAttribute(name = "smooth-angle") double smoothAngle;
        @XmlAttribute double weld = Mesh.USUAL_WELD;

        @Override
        Shape toShape(Problems problems) {
            return new Mesh(file, part, smoothAngle, weld, Mesh.Content.UNREAD);
        }
    }

    @XmlRootElement(name = "torus")
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class TorusBean extends ShapeBean {
        @XmlAttribute(required = true, name = "major-radius") double majorRadius;
        @XmlAttribute(required = true, name = "minor-radius") double minorRadius;

        @Override
        Shape toShape(Problems problems) {
            return new Torus(majorRadius, minorRadius);
        }
    }
}
