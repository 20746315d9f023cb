package cz.paprsek.render.glow;

import cz.paprsek.ray.Arrival;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.texture.Brightness;
import cz.paprsek.render.texture.Texture;

/** A picture of everything around as light that comes from its directions, which can be chosen as often as they are bright. Immutable. */
public final class SkyPicture implements SkyLight {
    private final Texture texture;
    private final double turned;
    private final double intensity;
    private final Brightness brightness;

    /**
     * A picture that stands around a scene.
     *
     * @param turned about y, in turns
     * @param intensity what its light is multiplied by
     */
    public SkyPicture(Texture texture, double turned, double intensity) {
        this.texture = texture;
        this.turned = turned;
        this.intensity = intensity;
        brightness = texture.brightness();
    }

    /** Whether any light comes from it. */
    public boolean shines() {
        return intensity > 0 && !brightness.isNone();
    }

    /** The u of a direction, 0–1. */
    public static double u(double dx, double dz, double turned) {
        double u = StrictMath.atan2(dz, dx) / (2 * Math.PI) + turned;
        return u - Math.floor(u);
    }

    /** The v of a direction, 0–1. */
    public static double v(double dy) {
        return 0.5 + StrictMath.asin(Math.max(-1, Math.min(1, dy))) / Math.PI;
    }

    @Override
    public void look(double dx, double dy, double dz, Hit out) {
        out.u = u(dx, dz, turned);
        out.v = v(dy);
        texture.bilinear(out.u, out.v, out);
        out.color(intensity * out.red, intensity * out.green, intensity * out.blue);
    }

    @Override
    public double density(double dx, double dy, double dz) {
        return brightness.density(u(dx, dz, turned), dy);
    }

    @Override
    public double choose(double u, double v, Arrival out, Hit scratch) {
        double height = brightness.height(v);
        double across = brightness.across(height, u);
        double angle = 2 * Math.PI * (across - turned);
        double cosine = Math.sqrt(Math.max(0, 1 - height * height));
        out.along(cosine * StrictMath.cos(angle), height, cosine * StrictMath.sin(angle));
        look(out.x, out.y, out.z, scratch);
        return brightness.density(across, height);
    }
}
