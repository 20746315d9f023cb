package cz.paprsek.render.light;

import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.lanes.Vec3s;
import cz.paprsek.scene.PointLight;

/** A light of no size, without fall-off: the common one, which those who ask try first. */
public final class PointLamp extends LampAtPoint {
    PointLamp(PointLight light) {
        super(light);
    }

    @Override
    public boolean sample(Hit from, double u, double v, Arrival out) {
        out.towards(from, x, y, z);
        out.light(red(), green(), blue());
        return true;
    }

    /**
     * Finds where it is from many points.
     *
     * @param ways receives the directions, of length 1
     * @param distances receives how far away it is
     */
    public void look(Vec3s from, Vec3s ways, double[] distances, int count) {
        ways.towards(x, y, z, from, count);
        ways.normalize(distances, count);
    }
}
