package cz.paprsek.xml.bind;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlElements;
import jakarta.xml.bind.annotation.adapters.CollapsedStringAdapter;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import java.util.ArrayList;
import java.util.List;
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
    @XmlAttribute double roughness = Material.DEFAULT.roughness();
    @XmlAttribute boolean thin = Material.DEFAULT.thin();
    @XmlAttribute(name = "attenuation-color") @XmlJavaTypeAdapter(Adapters.Color.class) Rgb attenuationColor = Material.DEFAULT.attenuationColor();
    @XmlAttribute(name = "attenuation-distance") double attenuationDistance = Material.DEFAULT.attenuationDistance();
    @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) Rgb emission = Material.DEFAULT.emission();
    @XmlAttribute(name = "emission-strength") double emissionStrength = Material.DEFAULT.emissionStrength();
    @XmlElements({
        @XmlElement(name = "checkerboard", type = PatternBeans.CheckerboardBean.class),
        @XmlElement(name = "checker", type = PatternBeans.CheckerBean.class),
        @XmlElement(name = "gradient", type = PatternBeans.GradientBean.class),
        @XmlElement(name = "stripes", type = PatternBeans.StripesBean.class),
        @XmlElement(name = "brick", type = PatternBeans.BrickBean.class),
        @XmlElement(name = "marble", type = PatternBeans.MarbleBean.class),
        @XmlElement(name = "wood", type = PatternBeans.WoodBean.class),
        @XmlElement(name = "granite", type = PatternBeans.GraniteBean.class),
        @XmlElement(name = "noise", type = PatternBeans.NoiseBean.class),
        @XmlElement(name = "image", type = PatternBeans.ImageBean.class)})
    List<PatternBeans.PatternBean> patterns = new ArrayList<>();

    Material toMaterial() {
        return new Material(pattern(), diffusion, specular, shininess, reflection, transparency, refractiveIndex,
                Fresnel.valueOf(fresnel.toUpperCase(Locale.ROOT)), roughness, thin, attenuationColor, attenuationDistance, emission, emissionStrength);
    }

    private Pattern pattern() {
        Require.that(patterns.size() <= 1, "a material has one pattern at most; remove one of them");
        Require.that(color == null || patterns.isEmpty(), "a material has either a color or a pattern, not both; remove one of them");
        return !patterns.isEmpty() ? patterns.get(0).toPattern() : color == null ? Material.DEFAULT.pattern() : new Pattern.Plain(color);
    }
}
