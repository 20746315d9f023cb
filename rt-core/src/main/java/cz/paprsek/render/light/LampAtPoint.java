package cz.paprsek.render.light;

import cz.paprsek.math.Vec3;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.buffer.LightPlace;
import cz.paprsek.scene.PlacedLight;
import cz.paprsek.tree.Bundle;
import java.util.Optional;

/** A light of no size. */
public abstract class LampAtPoint extends Lamp {
    private static final double ROUNDING = 1e-13;

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
    public final boolean bundle(Bundle hits, Bundle bundle) {
        bundle.lead(x, y, z, hits);
        return true;
    }

    @Override
    public final Optional<LightPlace> place() {
        return Optional.of(new LightPlace(new Vec3(x, y, z), false));
    }

    /**
     * Whether the light is behind a surface beyond doubt, and need not be looked for: told without a square root. What rounding does to N·L is
     * a hundred times less.
     */
    public final boolean isBehind(Hit hit) {
        double lx = x - hit.px;
        double ly = y - hit.py;
        double lz = z - hit.pz;
        return hit.sx * lx + hit.sy * ly + hit.sz * lz < -ROUNDING * (Math.abs(lx) + Math.abs(ly) + Math.abs(lz));
    }
}
