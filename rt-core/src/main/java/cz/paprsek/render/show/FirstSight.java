package cz.paprsek.render.show;

import cz.paprsek.render.integrate.Ledger;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;

/** Watches what rays from the eye meet first, and keeps a ledger of the light of each. Scratch of one worker. */
final class FirstSight extends Ledger {
    final FirstHits hits = new FirstHits();
    private final World scene;
    /** Of the ray at hand. */
    double albedoRed;
    double albedoGreen;
    double albedoBlue;

    FirstSight(World scene) {
        this.scene = scene;
    }

    /** Begins another ray from the eye. */
    void begin() {
        clear();
        hits.begin();
        albedoRed = 0;
        albedoGreen = 0;
        albedoBlue = 0;
    }

    /** Whether it meets anything. */
    boolean isMet() {
        return hits.object() > 0;
    }

    @Override
    public void met(Level level) {
        if (isEmpty()) {
            hits.meet(level, scene.parts().object(level.ray.part));
            double diffusion = scene.parts().finish(level.ray.part).diffusion;
            albedoRed = diffusion * level.colorRed;
            albedoGreen = diffusion * level.colorGreen;
            albedoBlue = diffusion * level.colorBlue;
        }
        super.met(level);
    }

    /** Bodies of lights are bodies like others; the disc of a sun is sky. */
    @Override
    public void seen(Level level, int lamp) {
        if (isEmpty() && Double.isFinite(level.ray.max)) {
            hits.meet(level, scene.scene().objects().size() + lamp);
        }
        super.seen(level, lamp);
    }
}
