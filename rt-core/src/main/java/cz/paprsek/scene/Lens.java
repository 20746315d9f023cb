package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Angles;
import cz.paprsek.math.Require;
import cz.paprsek.text.Numbers;

/** How a camera brings the world onto its picture. Scene files say which by {@code projection}, in lower case. */
public sealed interface Lens permits Lens.Perspective, Lens.Orthographic, Lens.Spherical, Lens.Fisheye {
    /** The word for it in scene files. */
    default String projection() {
        return Described.word(this);
    }

    /** About how much of the world the picture shows from top to bottom at a distance from the eye along the view, scene units. */
    double heightAt(double distance);

    /**
     * As a window: straight lines stay straight.
     *
     * @param fovy vertical field of view in degrees, above 0 and below 180
     * @param aperture radius of the lens, scene units; 0 for a pinhole, to which all is sharp
     * @param focus distance along the view of the plane that is sharp, scene units; 0 for that of the camera's target
     */
    record Perspective(
            @Attribute(value = Kind.FOVY, means = "Vertical field of view in degrees; perspective only", otherwise = "45") double fovy,
            @Attribute(value = Kind.NOT_NEGATIVE, means = "Radius of the lens: what is not in focus blurs; perspective only", otherwise = "0") double aperture,
            @Attribute(value = Kind.NOT_NEGATIVE, inForce = "focus", otherwise = "0",
                    means = "Distance along the view of what is sharp, or 0 for that of the target; perspective only")
            double focus) implements Lens {
        /** A pinhole, 45° high. */
        public static final Perspective DEFAULT = new Perspective(45, 0, 0);

        public Perspective {
            Require.that(fovy > 0 && fovy < 180, "camera fovy must be above 0 and below 180 degrees, but is " + Numbers.text(fovy));
            Require.sizeOrZero("camera aperture", aperture);
            Require.sizeOrZero("camera focus", focus);
        }

        public Perspective withFovy(double degrees) {
            return new Perspective(degrees, aperture, focus);
        }

        public Perspective withAperture(double radius) {
            return new Perspective(fovy, radius, focus);
        }

        public Perspective withFocus(double distance) {
            return new Perspective(fovy, aperture, distance);
        }

        @Override
        public double heightAt(double distance) {
            return 2 * distance * Angles.tan(fovy / 2);
        }
    }

    /**
     * From far away: parallel lines stay parallel, and nothing is smaller for being far. Rays start in the plane through the camera's position.
     *
     * @param height of what the picture shows, scene units
     */
    record Orthographic(
            @Attribute(value = Kind.POSITIVE, means = "Height of what the picture shows, scene units; orthographic only, and needed there") double height)
            implements Lens {
        public Orthographic {
            Require.size("camera height", height);
        }

        @Override
        public double heightAt(double distance) {
            return height;
        }
    }

    /** All around: 360° from left to right and 180° from top to bottom, the view in the middle. */
    record Spherical() implements Lens {
        @Override
        public double heightAt(double distance) {
            return Math.PI * distance;
        }
    }

    /**
     * A round picture, in which the distance from the middle is the angle to the view; black around it.
     *
     * @param angle from one edge of the circle, which is as high as the picture, to the other, degrees: above 0, 360 at most
     */
    record Fisheye(
            @Attribute(value = Kind.FISHEYE, means = "What is seen from the top of the picture to the bottom, degrees; fisheye only", otherwise = "180") double angle)
            implements Lens {
        /** Half of all around. */
        public static final Fisheye DEFAULT = new Fisheye(180);

        public Fisheye {
            Require.that(angle > 0 && angle <= 360, "camera angle must be above 0 and at most 360 degrees, but is " + Numbers.text(angle));
        }

        @Override
        public double heightAt(double distance) {
            return StrictMath.toRadians(angle) * distance;
        }
    }
}
