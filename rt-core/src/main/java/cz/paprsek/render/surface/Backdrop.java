package cz.paprsek.render.surface;

import cz.paprsek.material.Rgb;
import cz.paprsek.ray.Hit;
import cz.paprsek.render.glow.SkyLight;
import cz.paprsek.render.glow.SkyPicture;
import cz.paprsek.render.texture.Texture;
import cz.paprsek.render.texture.Textures;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Sky;
import java.util.Optional;

/** What rays see that hit nothing: the sky, ready to be asked, or one colour. */
public abstract class Backdrop {
    Backdrop() {}

    static Backdrop of(Scene scene, Textures textures) {
        if (scene.sky() instanceof Sky.Gradient gradient) {
            return new Gradient(gradient);
        } else if (scene.sky() instanceof Sky.Picture picture) {
            return new Panorama(picture, textures.texture(picture.file(), true));
        }
        return new Even(scene.background());
    }

    /**
     * Sets the colour of the level's hit, though there is none, to the light that its ray brings, linear; and u and v to the place in the
     * picture, if there is one.
     */
    public abstract void look(Level level);

    /** The picture that it is, ready to be looked for; empty if it is none, or black. */
    public Optional<SkyLight> picture() {
        return Optional.empty();
    }

    /** Whether it asks for the footprint of the ray. */
    boolean isPicture() {
        return false;
    }

    private static final class Even extends Backdrop {
        private final double red;
        private final double green;
        private final double blue;

        Even(Rgb color) {
            red = color.linearRed();
            green = color.linearGreen();
            blue = color.linearBlue();
        }

        @Override
        public void look(Level level) {
            level.hit.color(red, green, blue);
        }
    }

    private static final class Gradient extends Backdrop {
        private final double[] linear;

        Gradient(Sky.Gradient sky) {
            linear = new double[] {
                sky.horizon().linearRed(), sky.horizon().linearGreen(), sky.horizon().linearBlue(),
                sky.zenith().linearRed(), sky.zenith().linearGreen(), sky.zenith().linearBlue(),
                sky.ground().linearRed(), sky.ground().linearGreen(), sky.ground().linearBlue()};
        }

        @Override
        public void look(Level level) {
            double y = level.ray.dy;
            int end = y < 0 ? 6 : 3;
            double share = Math.min(1, Math.abs(y));
            level.hit.color(linear[0] + share * (linear[end] - linear[0]), linear[1] + share * (linear[end + 1] - linear[1]),
                    linear[2] + share * (linear[end + 2] - linear[2]));
        }
    }

    private static final class Panorama extends Backdrop {
        /** Nearer to straight up or down than the square root of this, all around is covered anyway. */
        private static final double ZENITH = 1e-12;

        private final Texture texture;
        private final double turned;
        private final double intensity;

        Panorama(Sky.Picture sky, Texture texture) {
            this.texture = texture;
            turned = sky.rotation() / 360;
            intensity = sky.intensity();
        }

        @Override
        boolean isPicture() {
            return true;
        }

        @Override
        public Optional<SkyLight> picture() {
            return Optional.of(new SkyPicture(texture, turned, intensity)).filter(SkyPicture::shines).map(found -> found);
        }

        @Override
        public void look(Level level) {
            Hit hit = level.hit;
            hit.u = SkyPicture.u(level.ray.dx, level.ray.dz, turned);
            hit.v = SkyPicture.v(level.ray.dy);
            double across = level.ray.dx * level.ray.dx + level.ray.dz * level.ray.dz;
            double perU = 1 / (2 * Math.PI * Math.max(ZENITH, across));
            double perV = 1 / (Math.PI * Math.sqrt(Math.max(ZENITH, across)));
            double[] beside = level.footprint.direction;
            texture.smooth(hit.u, hit.v, perU * (level.ray.dx * beside[2] - level.ray.dz * beside[0]), perV * beside[1],
                    perU * (level.ray.dx * beside[5] - level.ray.dz * beside[3]), perV * beside[4], hit);
            hit.color(intensity * hit.red, intensity * hit.green, intensity * hit.blue);
        }
    }
}
