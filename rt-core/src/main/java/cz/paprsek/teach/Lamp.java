package cz.paprsek.teach;

import static cz.paprsek.teach.mistake.Mistake.FALL_OFF_ADDED;
import static cz.paprsek.teach.mistake.Mistake.FALL_OFF_LINEAR;
import static cz.paprsek.teach.mistake.Mistake.NO_FALL_OFF;
import static cz.paprsek.teach.mistake.Mistake.SPOT_FULL_ANGLE;
import static cz.paprsek.teach.mistake.Mistake.SPOT_HARD;
import static cz.paprsek.teach.mistake.Mistake.WHITE_LIGHT;

import cz.paprsek.math.Angles;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PlacedLight;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.teach.mistake.Mistakes;

/** A light of no size. */
final class Lamp {
    /** By no more than this is light multiplied, however near. */
    private static final double MOST = 1e20;

    private final Light light;
    private final Vec full;
    private final Mistakes made;

    Lamp(Light light, Mistakes made) {
        Vec white = new Vec(light.intensity(), light.intensity(), light.intensity());
        this.light = light;
        this.made = made;
        this.full = made.has(WHITE_LIGHT) ? white : Paint.light(light.color(), made).times(light.intensity());
    }

    /** A light as it is from a point: in which direction, of length 1, how far, and what arrives of it if nothing stands in the way. */
    record Seen(Vec direction, double distance, Vec light) {}

    Seen from(Vec point) {
        if (light instanceof SunLight sun) {
            return new Seen(Vec.of(sun.direction().normalized().negated()), Double.POSITIVE_INFINITY, full);
        }
        Vec towards = Vec.of(((PlacedLight) light).position()).minus(point);
        double distance = towards.length();
        Vec direction = towards.times(1 / distance);
        double share = light instanceof SpotLight spot ? cone(spot, -direction.dot(Vec.of(spot.direction()))) * fallOff(spot.referenceDistance(), distance)
                : fallOff(((PointLight) light).referenceDistance(), distance);
        return new Seen(direction, distance, full.times(Math.min(share, MOST)));
    }

    /** What is left of light after a distance, if it falls at all. */
    private double fallOff(double reference, double distance) {
        if (reference == 0) {
            return made.has(FALL_OFF_ADDED) ? 1 / (distance * distance) : 1;
        } else if (made.has(NO_FALL_OFF)) {
            return 1;
        }
        return reference * reference / (made.has(FALL_OFF_LINEAR) ? distance : distance * distance);
    }

    /** With c the cosine of the angle to the middle of a spot: 3t² − 2t³, where t = (c − cos outer)/(cos inner − cos outer), within 0 and 1. */
    private double cone(SpotLight spot, double c) {
        double inner = Angles.cos(made.has(SPOT_FULL_ANGLE) ? spot.fullAngle() / 2 : spot.fullAngle());
        double outer = Angles.cos(made.has(SPOT_FULL_ANGLE) ? spot.outerAngle() / 2 : spot.outerAngle());
        if (c >= inner) {
            return 1;
        } else if (!(c > outer)) {
            return 0;
        }
        double t = (c - outer) / (inner - outer);
        return made.has(SPOT_HARD) ? t : t * t * (3 - 2 * t);
    }
}
