package cz.paprsek.render.light;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.scene.SpotLight;

/**
 * A cone of light. With c the cosine of the angle between its middle and the way to the point, it is multiplied by 3t² − 2t³, where
 * t = (c − cos outer)/(cos inner − cos outer), within 0 and 1.
 */
final class SpotLamp extends LampAtPoint {
    private final Vec3 axis;
    private final double cosInner;
    private final double cosOuter;
    /** 0 for light that does not fall. */
    private final double square;

    SpotLamp(SpotLight light) {
        super(light);
        axis = light.direction();
        cosInner = Angles.cos(light.fullAngle());
        cosOuter = Angles.cos(light.outerAngle());
        square = light.referenceDistance() * light.referenceDistance();
    }

    @Override
    public boolean sample(Hit from, double u, double v, Arrival out) {
        out.towards(from, x, y, z);
        double share = share(-(out.x * axis.x() + out.y * axis.y() + out.z * axis.z()));
        return arrives(square == 0 ? share : share * (square / (out.distance * out.distance)), out);
    }

    private double share(double cosine) {
        if (cosine >= cosInner) {
            return 1;
        } else if (!(cosine > cosOuter)) {
            return 0;
        }
        double t = (cosine - cosOuter) / (cosInner - cosOuter);
        return t * t * (3 - 2 * t);
    }
}
