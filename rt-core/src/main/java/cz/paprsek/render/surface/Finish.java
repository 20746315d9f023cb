package cz.paprsek.render.surface;

import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;

/** A material ready for shading. */
public final class Finish {
    /** From this α on a lobe is wide, about as the lamps of a room. */
    private static final double WIDE = 0.08;

    public final Material material;
    public final Paint paint;
    public final double diffusion;
    public final double specular;
    /** The share of light that the highlight sends on, about: all of it, where no part of it is below the surface. */
    public final double highlights;
    public final double reflection;
    public final double transparency;
    public final double refractiveIndex;
    public final Fresnel fresnel;
    /** How far facets are spread; 0 if it is smooth. */
    public final double alpha;
    /**
     * Whether lights that rays can see are looked for all the same, and then not seen by the rays it sends: a wide lobe seldom meets a small lamp,
     * a narrow one is seldom met by a point of a large one.
     */
    public final boolean looksForLamps;
    public final boolean isThin;
    /** Whether it mirrors and lets through the same shares at every angle: nearly all surfaces do, and are shaded by a shorter way. */
    public final boolean isPlain;
    /** Whether it gives off light of its own: {@link #red} and so on, linear. */
    public final boolean glows;
    public final double red;
    public final double green;
    public final double blue;
    private final double shininess;
    /** The exponent if it is a whole number, else −1. */
    private final int wholeShininess;

    public Finish(Material material, Paint paint) {
        this.material = material;
        this.paint = paint;
        diffusion = material.diffusion();
        specular = material.specular();
        shininess = material.shininess();
        wholeShininess = shininess == Math.rint(shininess) ? (int) shininess : -1;
        highlights = 2 * specular / (shininess + 1);
        reflection = material.reflection();
        transparency = material.transparency();
        refractiveIndex = material.refractiveIndex();
        fresnel = material.fresnel();
        alpha = material.roughness() * material.roughness();
        looksForLamps = alpha >= WIDE;
        isThin = material.thin();
        isPlain = fresnel == Fresnel.FALSE && alpha == 0 && !isThin;
        red = material.emission().linearRed() * material.emissionStrength();
        green = material.emission().linearGreen() * material.emissionStrength();
        blue = material.emission().linearBlue() * material.emissionStrength();
        glows = red > 0 || green > 0 || blue > 0;
    }

    /** Whether light that falls on it shows: if not, no shadow ray is needed. */
    public boolean isLit() {
        return diffusion > 0 || specular > 0 || alpha > 0;
    }

    /**
     * kS · max(0, cos)ⁿ. Whole exponents by squaring, which is fast and rounds alike on every JDK; {@link Math#pow} need not.
     *
     * @param cosine of the angle between the mirrored eye ray and the light
     */
    public double highlight(double cosine) {
        if (!(cosine > 0) || specular == 0) {
            return 0;
        }
        if (wholeShininess < 0) {
            return specular * StrictMath.pow(cosine, shininess);
        }
        double result = specular;
        double factor = cosine;
        for (int n = wholeShininess; n > 0; n >>= 1) {
            if ((n & 1) != 0) {
                result *= factor;
            }
            factor *= factor;
        }
        return result;
    }
}
