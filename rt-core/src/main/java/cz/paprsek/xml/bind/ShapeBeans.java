package cz.paprsek.xml.bind;

import cz.paprsek.math.Vec3;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Ellipsoid;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;

/** One bean for each primitive: the attributes of its element. */
final class ShapeBeans {
    private ShapeBeans() {}

    @XmlAccessorType(XmlAccessType.FIELD)
    static final class SphereBean extends ShapeBean {
        @XmlAttribute(required = true) double radius;

        @Override
        Shape toShape(Problems problems) {
            return new Sphere(radius);
        }
    }

    @XmlAccessorType(XmlAccessType.FIELD)
    static final class BlockBean extends ShapeBean {
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 min = Vec3.ZERO;
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 max = Vec3.ZERO;

        @Override
        Shape toShape(Problems problems) {
            return new Block(min, max);
        }
    }

    @XmlAccessorType(XmlAccessType.FIELD)
    static final class EllipsoidBean extends ShapeBean {
        @XmlAttribute(required = true, name = "semi-axes") @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 semiAxes = Vec3.ZERO;

        @Override
        Shape toShape(Problems problems) {
            return new Ellipsoid(semiAxes);
        }
    }

    @XmlAccessorType(XmlAccessType.FIELD)
    static final class RectangleBean extends ShapeBean {
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Pair.class) double[] min = {0, 0};
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Pair.class) double[] max = {0, 0};

        @Override
        Shape toShape(Problems problems) {
            return new Rectangle(min[0], min[1], max[0], max[1]);
        }
    }

    @XmlAccessorType(XmlAccessType.FIELD)
    static final class DiscBean extends ShapeBean {
        @XmlAttribute(required = true) double radius;

        @Override
        Shape toShape(Problems problems) {
            return new Disc(radius);
        }
    }

    @XmlAccessorType(XmlAccessType.FIELD)
    static final class PlaneBean extends ShapeBean {
        @Override
        Shape toShape(Problems problems) {
            return new Plane();
        }
    }

    @XmlAccessorType(XmlAccessType.FIELD)
    static final class CylinderBean extends ShapeBean {
        @XmlAttribute(required = true) double radius;
        @XmlAttribute(required = true) double height;

        @Override
        Shape toShape(Problems problems) {
            return new Cylinder(radius, height);
        }
    }

    @XmlAccessorType(XmlAccessType.FIELD)
    static final class ConeBean extends ShapeBean {
        @XmlAttribute(required = true) double radius;
        @XmlAttribute(name = "top-radius") double topRadius;
        @XmlAttribute(required = true) double height;

        @Override
        Shape toShape(Problems problems) {
            return new Cone(radius, topRadius, height);
        }
    }

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
