package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;
import static cz.paprsek.text.Numbers.text;

import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Material.Shares;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share;
import cz.paprsek.material.Share.ByPattern;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Shape;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * Materials in POV-Ray's words. POV-Ray weakens diffuse and ambient light by what shines through; ours is a plain sum, so both are
 * written the stronger.
 */
final class PovMaterials {
    /** The attributes that words are found for here. */
    static final Set<String> TOLD = Set.of("color", "diffusion", "specular", "shininess", "reflection", "transparency", "refractive-index", "fresnel",
            "attenuation-color", "attenuation-distance", "emission", "emission-strength", "roughness", "thin");

    /** 1 − 2⁻²⁰: the most that is written as shining through, so that diffuse light is not multiplied by 0. No step of 16 bits. */
    private static final double MOST = 1 - 0x1p-20;

    private PovMaterials() {}

    /** A linear colour times a factor. */
    static String rgb(Rgb color, double factor) {
        return "rgb " + vector(factor * color.linearRed(), factor * color.linearGreen(), factor * color.linearBlue());
    }

    /** Whether what a material looks like depends on the shape that it lies on. */
    static boolean isMapped(Material material) {
        return material.relief() instanceof Material.Bump || material.patterns().anyMatch(pattern -> pattern instanceof Pattern.Checkerboard || pattern instanceof Pattern.Picture);
    }

    /** A material as it lies on a shape. */
    static String texture(Material material, Shape shape) {
        return "texture { " + body(material, shape) + " }";
    }

    /**
     * What stands in a texture. Where a share goes by a pattern, that is one of textures: light is a linear function of each share by itself, so that
     * what comes of a mixture of two shares is the mixture of what comes of them.
     */
    private static String body(Material material, Shape shape) {
        for (Named share : NAMED) {
            if (share.of().apply(material.shares()) instanceof ByPattern by && PovPatterns.isTold(by.pattern())) {
                PovPatterns textures = PovPatterns.ofTextures(color -> body(share.with().apply(material, by.channel().of(color)), shape));
                return textures.around(by.pattern(), shape);
            }
        }
        PovPatterns colors = PovPatterns.ofColors(transmit(material));
        return body(material, shape, material.pattern() instanceof Pattern.Picture picture ? PovPictures.pigment(picture, shape, transmit(material))
                : material.pattern() instanceof Pattern.Checkerboard board ? colors.board(board, shape) : colors.pigment(material.pattern()));
    }

    /** A share, and how a material is given it. */
    private record Named(Function<Shares, Share> of, BiFunction<Material, Double, Material> with) {}

    private static final List<Named> NAMED = List.of(
            new Named(Shares::diffusion, Material::withDiffusion),
            new Named(Shares::specular, (material, value) -> material.withHighlight(value, material.shininess())),
            new Named(Shares::reflection, Material::withReflection),
            new Named(Shares::transparency, (material, value) -> material.withTransparency(value, material.refractiveIndex())));

    /** What is inside of an object: nothing special, unless light shines through. */
    static String interior(Scene scene, SceneObject object) {
        boolean isSolid = object.shape().hasInside();
        return PovWarnings.materials(scene, object).stream()
                .filter(material -> material.transparency() > 0 ? isSolid : material.fresnel() == Fresnel.TRUE)
                .max(Comparator.comparing(material -> material.transparency() > 0))
                .map(material -> "interior { ior " + text(material.thin() ? 1 : material.refractiveIndex()) + absorption(material)).orElse("");
    }

    /** The rest of an interior. Of POV-Ray's two ways the one that also takes from what is mirrored within: {@code fade_power} does not. */
    private static String absorption(Material material) {
        Rgb color = material.attenuationColor();
        double per = 1 / material.attenuationDistance();
        return color.equals(Rgb.WHITE) || material.thin() ? " }" : " media { absorption rgb " + vector(per * (1 - color.linearRed()), per * (1 - color.linearGreen()),
                per * (1 - color.linearBlue())) + " } } hollow";
    }

    /** POV-Ray multiplies it by the pigment. */
    private static String emission(Material material, double weakened) {
        Rgb light = material.emission();
        Rgb color = oneColor(material.pattern());
        double strength = material.emissionStrength() / weakened;
        return light.equals(Rgb.BLACK) || strength == 0 ? "" : " emission rgb " + vector(strength * quotient(light.linearRed(), color.linearRed()),
                strength * quotient(light.linearGreen(), color.linearGreen()), strength * quotient(light.linearBlue(), color.linearBlue()));
    }

    private static double quotient(double light, double color) {
        return light == 0 || color == 0 ? 0 : light / color;
    }

    /** Whether POV-Ray can be told what a material gives off: not if the pigment takes it away. */
    static boolean emits(Material material) {
        Rgb light = material.emission();
        return light.equals(Rgb.BLACK) || material.emissionStrength() == 0 || (material.pattern() instanceof Pattern.Plain plain
                && (light.red() == 0 || plain.color().red() > 0) && (light.green() == 0 || plain.color().green() > 0) && (light.blue() == 0 || plain.color().blue() > 0));
    }

    private static String body(Material material, Shape shape, String pigment) {
        double weakened = 1 - transmit(material);
        return "pigment { " + pigment + " }" + PovBumps.normal(material.relief(), shape) + " finish { ambient " + text(1 / weakened) + " diffuse " + text(material.diffusion() / weakened)
                + (material.specular() > 0 ? " phong " + text(material.specular()) + " phong_size " + text(material.shininess()) : "")
                + emission(material, weakened) + reflection(material) + " }";
    }

    private static String reflection(Material material) {
        String share = text(material.reflection());
        if (material.fresnel() == Fresnel.TRUE) {
            return " reflection { 0, " + share + " fresnel on } conserve_energy";
        }
        return material.reflection() == 0 ? "" : material.fresnel() == Fresnel.FALSE ? " reflection " + share
                : " reflection { " + rgb(oneColor(material.pattern()), material.reflection()) + ", " + share + " falloff 5 }";
    }

    /** A colour for all of a surface, where POV-Ray takes one only. */
    private static Rgb oneColor(Pattern pattern) {
        return pattern instanceof Pattern.Plain plain ? plain.color() : pattern instanceof Pattern.Checker checker ? checker.even()
                : pattern instanceof Pattern.Checkerboard board ? board.even() : Rgb.WHITE;
    }

    private static double transmit(Material material) {
        return Math.min(material.transparency(), MOST);
    }
}
