package cz.paprsek.render.light;

import cz.paprsek.ray.Hit;
import cz.paprsek.scene.PlacedLight;
import cz.paprsek.tree.Bundle;

/** A light of no size. */
abstract class LampAtPoint extends Lamp {
    final double x;
    final double y;
    final double z;

    LampAtPoint(PlacedLight light) {
        super(light.color(), light.intensity());
        x = light.position().x();
        y = light.position().y();
        z = light.position().z();
    }

    @Override
    public final int samples() {
        return 1;
    }

    @Override
    public final boolean start(Bundle bundle) {
        bundle.start(x, y, z);
        return true;
    }

    @Override
    public final double add(Hit hit, Bundle bundle) {
        double dx = hit.px - x;
        double dy = hit.py - y;
        double dz = hit.pz - z;
        bundle.add(dx, dy, dz);
        return Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
    }
}
