package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Require;

/**
 * How a scene wishes to be rendered when the caller does not say otherwise.
 *
 * @param width picture width in pixels, 1–{@value #LARGEST_SIDE}
 * @param height picture height in pixels, 1–{@value #LARGEST_SIDE}
 * @param maxDepth levels of rays, the eye ray being level 1; 1–{@value #DEEPEST}
 * @param samples rays along each side of a pixel: 1 for one ray through its centre, n for a regular grid of n × n; 1–16
 */
@Element(name = "render", value = "How the scene wishes to be rendered.")
public record RenderSettings(
        @Attribute(value = Kind.PIXELS, means = "Picture width in pixels", otherwise = "800") int width,
        @Attribute(value = Kind.PIXELS, means = "Picture height in pixels", otherwise = "600") int height,
        @Attribute(value = Kind.DEPTH, means = "Levels of rays, the eye ray being level 1", otherwise = "5") int maxDepth,
        @Attribute(value = Kind.SAMPLES, means = "Rays along each side of a pixel", otherwise = "1") int samples) {
    public static final int LARGEST_SIDE = 32_768;
    public static final int DEEPEST = 250;
    public static final RenderSettings DEFAULT = new RenderSettings(800, 600, 5, 1);

    public RenderSettings {
        Require.within("render width", width, 1, LARGEST_SIDE);
        Require.within("render height", height, 1, LARGEST_SIDE);
        Require.within("render max-depth", maxDepth, 1, DEEPEST);
        Require.within("render samples", samples, 1, 16);
    }

    public RenderSettings withSize(int newWidth, int newHeight) {
        return new RenderSettings(newWidth, newHeight, maxDepth, samples);
    }

    public RenderSettings withMaxDepth(int levels) {
        return new RenderSettings(width, height, levels, samples);
    }

    public RenderSettings withSamples(int perSide) {
        return new RenderSettings(width, height, maxDepth, perSide);
    }
}
