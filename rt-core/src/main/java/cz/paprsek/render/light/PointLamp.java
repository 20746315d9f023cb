package cz.paprsek.render.light;

import cz.paprsek.ray.Hit;
import cz.paprsek.scene.Light;
import cz.paprsek.tree.Bundle;

/** A light of no size, without fall-off. */
final class PointLamp extends Lamp {
    private final double x;
    private final double y;
    private final double z;

    PointLamp(Light light) {
        super(light.color(), light.intensity());
        x = light.position().x();
        y = light.position().y();
        z = light.position().z();
    }

    @Override
    public int samples() {
        return 1;
    }

    @Override
    public void sample(Hit from, double u, double v, Arrival out) {
        double lx = x - from.px;
        double ly = y - from.py;
        double lz = z - from.pz;
        double distance = Math.sqrt(lx * lx + ly * ly + lz * lz);
        double k = 1 / distance;
        out.x = lx * k;
        out.y = ly * k;
        out.z = lz * k;
        out.distance = distance;
    }

    @Override
    public boolean start(Bundle bundle) {
        bundle.start(x, y, z);
        return true;
    }

    @Override
    public double add(Hit hit, Bundle bundle) {
        double dx = hit.px - x;
        double dy = hit.py - y;
        double dz = hit.pz - z;
        bundle.add(dx, dy, dz);
        return Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
    }
}
