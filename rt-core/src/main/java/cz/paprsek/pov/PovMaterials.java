package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;
import static cz.paprsek.text.Numbers.text;

import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Solid;
import java.util.Comparator;
import java.util.Set;

/**
 * Materials in POV-Ray's words. POV-Ray weakens diffuse and ambient light by what shines through; ours is a plain sum, so both are
 * written the stronger.
 */
final class PovMaterials {
    /** The attributes that words are found for here. */
    static final Set<String> TOLD = Set.of("color", "diffusion", "specular", "shininess", "reflection", "transparency", "refractive-index", "fresnel");

    /** 1 − 2⁻²⁰: the most that is written as shining through, so that diffuse light is not multiplied by 0. No step of 16 bits. */
    private static final double MOST = 1 - 0x1p-20;

    private PovMaterials() {}

    /** A linear colour times a factor. */
    static String rgb(Rgb color, double factor) {
        return "rgb " + vector(factor * color.linearRed(), factor * color.linearGreen(), factor * color.linearBlue());
    }

    /** A material of anything but a checkerboard. */
    static String texture(Material material) {
        return texture(material, new PovPatterns(transmit(material)).pigment(material.pattern()));
    }

    /** A material as it lies on a shape. */
    static String texture(Material material, Shape shape) {
        return material.pattern() instanceof Pattern.Checkerboard board
                ? texture(material, new PovPatterns(transmit(material)).board(board, shape))
                : texture(material);
    }

    /** What is inside of an object: nothing special, unless light shines through. */
    static String interior(Scene scene, SceneObject object) {
        boolean isSolid = object.shape() instanceof Solid;
        return PovWarnings.materials(scene, object).stream()
                .filter(material -> material.transparency() > 0 ? isSolid : material.fresnel() == Fresnel.TRUE)
                .max(Comparator.comparing(material -> material.transparency() > 0))
                .map(material -> "interior { ior " + text(material.refractiveIndex()) + " }").orElse("");
    }

    private static String texture(Material material, String pigment) {
        double weakened = 1 - transmit(material);
        return "texture { pigment { " + pigment + " } finish { ambient " + text(1 / weakened) + " diffuse " + text(material.diffusion() / weakened)
                + (material.specular() > 0 ? " phong " + text(material.specular()) + " phong_size " + text(material.shininess()) : "")
                + reflection(material) + " } }";
    }

    private static String reflection(Material material) {
        String share = text(material.reflection());
        if (material.fresnel() == Fresnel.TRUE) {
            return " reflection { 0, " + share + " fresnel on } conserve_energy";
        }
        return material.reflection() == 0 ? "" : material.fresnel() == Fresnel.FALSE ? " reflection " + share
                : " reflection { " + rgb(metal(material.pattern()), material.reflection()) + ", " + share + " falloff 5 }";
    }

    /** A metal's colour as POV-Ray is told it: one for all of its surface. */
    private static Rgb metal(Pattern pattern) {
        return pattern instanceof Pattern.Plain plain ? plain.color() : pattern instanceof Pattern.Checker checker ? checker.even()
                : pattern instanceof Pattern.Checkerboard board ? board.even() : Rgb.WHITE;
    }

    private static double transmit(Material material) {
        return Math.min(material.transparency(), MOST);
    }
}
