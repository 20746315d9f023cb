package cz.paprsek.xml.bind;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.adapters.CollapsedStringAdapter;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/** {@code <material>}, named or within an object. */
@XmlAccessorType(XmlAccessType.FIELD)
final class MaterialBean extends Located {
    @XmlAttribute String name = "";
    @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) @Nullable Rgb color;
    @XmlAttribute double diffusion = Material.DEFAULT.diffusion();
    @XmlAttribute double specular = Material.DEFAULT.specular();
    @XmlAttribute double shininess = Material.DEFAULT.shininess();
    @XmlAttribute double reflection = Material.DEFAULT.reflection();
    @XmlAttribute double transparency = Material.DEFAULT.transparency();
    @XmlAttribute(name = "refractive-index") double refractiveIndex = Material.DEFAULT.refractiveIndex();
    @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String fresnel = Described.word(Material.DEFAULT.fresnel());
    @XmlElement @Nullable CheckerboardBean checkerboard;
    @XmlElement @Nullable CheckerBean checker;

    Material toMaterial() {
        return new Material(pattern(), diffusion, specular, shininess, reflection, transparency, refractiveIndex,
                Fresnel.valueOf(fresnel.toUpperCase(Locale.ROOT)));
    }

    private Pattern pattern() {
        Require.that(checker == null || checkerboard == null, "a material has one pattern at most; remove one of them");
        Require.that(color == null || (checker == null && checkerboard == null),
                "a material has either a color or a pattern, not both; remove one of them");
        if (checkerboard != null) {
            return new Pattern.Checkerboard(checkerboard.columns, checkerboard.rows, checkerboard.even, checkerboard.odd);
        }
        if (checker != null) {
            return new Pattern.Checker(checker.size, checker.origin, checker.even, checker.odd);
        }
        return color == null ? Material.DEFAULT.pattern() : new Pattern.Plain(color);
    }

    /** {@code <checkerboard>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class CheckerboardBean {
        @XmlAttribute(required = true) int columns;
        @XmlAttribute(required = true) int rows;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) Rgb even = Rgb.WHITE;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) Rgb odd = Rgb.BLACK;
    }

    /** {@code <checker>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class CheckerBean {
        @XmlAttribute(required = true) double size;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 origin = Vec3.ZERO;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) Rgb even = Rgb.WHITE;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) Rgb odd = Rgb.BLACK;
    }
}
