package cz.paprsek.render.glow;

import cz.paprsek.material.Rgb;
import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.light.Lamp;

/** A picture of everything around, which paths look for as they do for lights: in its directions as often as they are bright. Scratch of one worker. */
public final class SkyLamp extends Lamp {
    private final SkyLight picture;
    private final Glows glows;
    private final Hit there = new Hit();

    /** @param glows what hides it: suns that are seen */
    public SkyLamp(SkyLight picture, Glows glows) {
        super(Rgb.WHITE, 1);
        this.picture = picture;
        this.glows = glows;
    }

    @Override
    public int samples() {
        return BODY_SAMPLES;
    }

    @Override
    public double density(double x, double y, double z, double dx, double dy, double dz, double distance) {
        return picture.density(dx, dy, dz);
    }

    /** Each direction brings its radiance by π times its density. */
    @Override
    public boolean sample(Hit from, double u, double v, Arrival out) {
        double density = picture.choose(u, v, out, there);
        if (!(density > 0) || glows.sky(out.x, out.y, out.z, out) != Glows.NONE) {
            return false;
        }
        double k = Math.min(MOST, 1 / (Math.PI * density));
        out.light(k * there.red, k * there.green, k * there.blue);
        return there.red > 0 || there.green > 0 || there.blue > 0;
    }
}
