package cz.paprsek.render.surface;

import cz.paprsek.material.Material;

/** What a substance takes of light on its way through: per unit of length σ = (1 − c)/D of each channel. */
public final class Absorption {
    public final Material material;
    public final double red;
    public final double green;
    public final double blue;

    Absorption(Material material) {
        this.material = material;
        double distance = material.attenuationDistance();
        red = (1 - material.attenuationColor().linearRed()) / distance;
        green = (1 - material.attenuationColor().linearGreen()) / distance;
        blue = (1 - material.attenuationColor().linearBlue()) / distance;
    }

    /** Whether it takes anything. */
    boolean isAny() {
        return red > 0 || green > 0 || blue > 0;
    }

    /** σ·d, 0 also of an infinite way if nothing is taken. */
    public static double depth(double coefficient, double way) {
        return coefficient > 0 ? coefficient * way : 0;
    }

    /** What is left of light after a depth. */
    public static double left(double depth) {
        return depth > 0 ? StrictMath.exp(-depth) : 1;
    }
}
