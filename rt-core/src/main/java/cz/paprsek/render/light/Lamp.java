package cz.paprsek.render.light;

import cz.paprsek.material.Rgb;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.buffer.LightPlace;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.CustomLight;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.tree.Bundle;
import java.util.Optional;

/** A light ready for shading: one class for each kind. Immutable. */
public abstract class Lamp {
    /** By no more than this is light multiplied, however near: so that pictures are of finite numbers. */
    public static final double MOST = 1e20;

    /** More than 1: a body that shines has many points to look for. A path looks for one of them. */
    public static final int BODY_SAMPLES = 16;

    private final double red;
    private final double green;
    private final double blue;

    protected Lamp(Rgb color, double intensity) {
        red = color.linearRed() * intensity;
        green = color.linearGreen() * intensity;
        blue = color.linearBlue() * intensity;
    }

    public static Lamp of(Light light) {
        Lamp lamp = bright(light);
        return light.intensity() > 0 || light instanceof CustomLight ? lamp : new DarkLamp(light, lamp);
    }

    private static Lamp bright(Light light) {
        if (light instanceof PointLight point) {
            return point.referenceDistance() == 0 ? new PointLamp(point) : new FadingLamp(point);
        } else if (light instanceof SpotLight spot) {
            return new SpotLamp(spot);
        } else if (light instanceof AreaLight area) {
            return area.form() instanceof AreaLight.Size size ? new RectangleLamp(area, size) : new DiscLamp(area, (AreaLight.Radius) area.form());
        } else if (light instanceof SphereLight ball) {
            return new BallLamp(ball);
        } else if (light instanceof CustomLight custom) {
            return new CustomLamp(custom);
        }
        SunLight sun = (SunLight) light;
        return sun.angle() == 0 ? new SunLamp(sun) : new SunDiscLamp(sun);
    }

    /** Its colour times its intensity, linear. */
    public final double red() {
        return red;
    }

    public final double green() {
        return green;
    }

    public final double blue() {
        return blue;
    }

    /** How many shadow rays a point sends; if it is 1, always the same one, for which nothing random is asked. */
    public abstract int samples();

    /**
     * Chooses a point of the light, and tells where it is, and what arrives of the light if nothing stands in the way: the mean of all that is
     * chosen is the light that arrives.
     *
     * @param from the point it is looked for from
     * @param u which point, 0–1; without meaning for a light of no size
     * @param v likewise
     * @return whether anything arrives
     */
    public abstract boolean sample(Hit from, double u, double v, Arrival out);

    /**
     * How probable it is that {@link #sample} chooses a direction from a point, per solid angle; 0 for a light of no size, and for directions
     * that it never chooses.
     *
     * @param x the point
     * @param dx the direction, of length 1, in which the light is
     * @param distance how far away it is
     */
    public double density(double x, double y, double z, double dx, double dy, double dz, double distance) {
        return 0;
    }

    /**
     * Makes a bundle of the lines from the light to many hits; false if they do not start in one place, and cannot be bundled.
     *
     * @param hits the lines from the origin to the hits
     */
    public boolean bundle(Bundle hits, Bundle bundle) {
        return false;
    }

    /** Where all its light comes from, if that is one place. */
    public Optional<LightPlace> place() {
        return Optional.empty();
    }

    /** Makes its own light, times a factor, what arrives. */
    final boolean arrives(double factor, Arrival out) {
        double k = factor < MOST ? factor : MOST;
        out.light(k * red, k * green, k * blue);
        return k > 0;
    }
}
