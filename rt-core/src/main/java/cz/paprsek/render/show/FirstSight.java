package cz.paprsek.render.show;

import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.render.integrate.Ledger;
import cz.paprsek.render.surface.Finish;
import cz.paprsek.render.surface.Level;
import cz.paprsek.render.surface.World;
import cz.paprsek.scene.Camera;

/** Watches what rays from the eye meet first, and keeps a ledger of the light of each. Scratch of one worker. */
final class FirstSight extends Ledger {
    private static final int NORMAL = 3;
    private static final int FAR = 6;

    final FirstHits hits = new FirstHits();
    private final World scene;
    /** Of the ray at hand. */
    double albedoRed;
    double albedoGreen;
    double albedoBlue;
    /** What {@link Guides} hold, of the ray at hand. */
    final double[] guide = new double[Guides.COUNT];
    private final double near;
    private boolean isGuided;
    private double travelled;

    FirstSight(World scene) {
        this.scene = scene;
        Camera camera = scene.scene().camera();
        near = camera.aim() instanceof Camera.Target aim ? aim.point().minus(camera.position()).length() : 1;
    }

    /** Begins another ray from the eye. */
    void begin() {
        clear();
        hits.begin();
        albedoRed = 0;
        albedoGreen = 0;
        albedoBlue = 0;
        isGuided = false;
        travelled = 0;
        guide(1, 1, 1);
        turn(0, 0, 0);
        guide[FAR] = 1;
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
        if (!isGuided) {
            guide(level, scene.parts().finish(level.ray.part));
        }
        super.met(level);
    }

    /** A mirror, and glass, look as what is seen in them. */
    private void guide(Level level, Finish finish) {
        isGuided = finish.diffusion > 0 || finish.specular > 0 || finish.alpha > 0 || finish.glows;
        double white = finish.alpha > 0 ? finish.reflection + finish.transparency : 0;
        double tinted = finish.diffusion + (finish.fresnel == Fresnel.METAL ? white : 0);
        double rest = finish.fresnel == Fresnel.METAL ? 0 : white;
        guide(tinted * level.colorRed + rest, tinted * level.colorGreen + rest, tinted * level.colorBlue + rest);
        goTo(level);
    }

    private void goTo(Level level) {
        turn(level.hit.sx, level.hit.sy, level.hit.sz);
        travelled += level.ray.max;
        guide[FAR] = travelled / (travelled + near);
    }

    private void guide(double red, double green, double blue) {
        guide[0] = red;
        guide[1] = green;
        guide[2] = blue;
    }

    private void turn(double x, double y, double z) {
        guide[NORMAL] = x;
        guide[NORMAL + 1] = y;
        guide[NORMAL + 2] = z;
    }

    @Override
    public void missed(Level level) {
        endGuide();
        super.missed(level);
    }

    /** What is seen is light itself. */
    private void endGuide() {
        if (!isGuided) {
            isGuided = true;
            guide(1, 1, 1);
            guide[FAR] = 1;
        }
    }

    /** Bodies of lights are bodies like others; the disc of a sun is sky. */
    @Override
    public void seen(Level level, int lamp) {
        if (isEmpty() && Double.isFinite(level.ray.max)) {
            hits.meet(level, scene.scene().objects().size() + lamp);
        }
        if (!isGuided) {
            boolean isBody = Double.isFinite(level.ray.max);
            endGuide();
            if (isBody) {
                goTo(level);
            }
        }
        super.seen(level, lamp);
    }
}
