package cz.paprsek.material;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.math.Require;
import java.util.Objects;

/**
 * How a surface answers light.
 *
 * @param pattern its colour C at each point
 * @param diffusion share of diffusely reflected light kD, 0–1
 * @param specular strength of the highlight kS, 0–1; the highlight has the light's colour
 * @param shininess exponent n of the highlight, 0–1 000 000; the higher, the smaller and sharper
 * @param reflection share of mirrored light kR, 0–1
 * @param transparency share of transmitted light kT, 0–1
 * @param refractiveIndex index of the medium inside relative to the vacuum, above 0 and at most 100
 */
@Element("How a surface answers light. A pattern inside takes the place of the colour.")
public record Material(
        Pattern pattern,
        @Attribute(value = Kind.SHARE, means = "Share of diffusely reflected light", otherwise = "0.8") double diffusion,
        @Attribute(value = Kind.SHARE, means = "Strength of the highlight", otherwise = "0") double specular,
        @Attribute(value = Kind.EXPONENT, means = "Exponent of the highlight", otherwise = "30") double shininess,
        @Attribute(value = Kind.SHARE, means = "Share of mirrored light", otherwise = "0") double reflection,
        @Attribute(value = Kind.SHARE, means = "Share of transmitted light", otherwise = "0") double transparency,
        @Attribute(value = Kind.REFRACTIVE_INDEX, means = "Index of the medium inside", otherwise = "1") double refractiveIndex) implements MaterialSource {

    /** Matte white: what an object without a material is made of. */
    public static final Material DEFAULT = new Material(new Pattern.Plain(Rgb.WHITE), 0.8, 0, 30, 0, 0, 1);

    /** @throws IllegalArgumentException if a number is outside its range */
    public Material {
        Objects.requireNonNull(pattern, "pattern");
        Require.within("diffusion", diffusion, 0, 1);
        Require.within("specular", specular, 0, 1);
        Require.within("shininess", shininess, 0, 1e6);
        Require.within("reflection", reflection, 0, 1);
        Require.within("transparency", transparency, 0, 1);
        Require.positive("refractive-index", refractiveIndex);
        Require.within("refractive-index", refractiveIndex, 0, 100);
    }

    /** The default material in a colour of sRGB channels 0–255. */
    public static Material color(double red, double green, double blue) {
        return color(new Rgb(red, green, blue));
    }

    /** The default material in a colour. */
    public static Material color(Rgb color) {
        return DEFAULT.withPattern(new Pattern.Plain(color));
    }

    public Material withPattern(Pattern value) {
        return new Material(value, diffusion, specular, shininess, reflection, transparency, refractiveIndex);
    }

    public Material withDiffusion(double value) {
        return new Material(pattern, value, specular, shininess, reflection, transparency, refractiveIndex);
    }

    /** With a highlight of the given strength and exponent. */
    public Material withHighlight(double strength, double exponent) {
        return new Material(pattern, diffusion, strength, exponent, reflection, transparency, refractiveIndex);
    }

    public Material withReflection(double value) {
        return new Material(pattern, diffusion, specular, shininess, value, transparency, refractiveIndex);
    }

    /** Letting the given share of light through, bent by the given refractive index. */
    public Material withTransparency(double share, double index) {
        return new Material(pattern, diffusion, specular, shininess, reflection, share, index);
    }
}
