package cz.paprsek.xml.bind;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Fresnel;
import cz.paprsek.material.Material.Relief;
import cz.paprsek.material.Material.Shares;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share;
import cz.paprsek.material.Share.Even;
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
final class MaterialBean extends PatternBeans.AroundBean {
    @XmlAttribute String name = "";
    @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) @Nullable Rgb color;
    @XmlAttribute @Nullable Double diffusion;
    @XmlAttribute @Nullable Double specular;
    @XmlAttribute double shininess = Material.DEFAULT.shininess();
    @XmlAttribute @Nullable Double reflection;
    @XmlAttribute @Nullable Double transparency;
    @XmlAttribute(name = "refractive-index") double refractiveIndex = Material.DEFAULT.refractiveIndex();
    @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String fresnel = Described.word(Material.DEFAULT.fresnel());
    @XmlAttribute @Nullable Double roughness;
    @XmlAttribute boolean thin = Material.DEFAULT.thin();
    @XmlAttribute(name = "attenuation-color") @XmlJavaTypeAdapter(Adapters.Color.class) Rgb attenuationColor = Material.DEFAULT.attenuationColor();
    @XmlAttribute(name = "attenuation-distance") double attenuationDistance = Material.DEFAULT.attenuationDistance();
    @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) Rgb emission = Material.DEFAULT.emission();
    @XmlAttribute(name = "emission-strength") double emissionStrength = Material.DEFAULT.emissionStrength();
    @XmlElement(name = "diffusion") List<ReliefBeans.ShareBean> diffusions = new ArrayList<>();
    @XmlElement(name = "specular") List<ReliefBeans.ShareBean> speculars = new ArrayList<>();
    @XmlElement(name = "reflection") List<ReliefBeans.ShareBean> reflections = new ArrayList<>();
    @XmlElement(name = "transparency") List<ReliefBeans.ShareBean> transparencies = new ArrayList<>();
    @XmlElement(name = "roughness") List<ReliefBeans.ShareBean> roughnesses = new ArrayList<>();
    @XmlElements({
        @XmlElement(name = "bump", type = ReliefBeans.BumpBean.class),
        @XmlElement(name = "normal-map", type = ReliefBeans.NormalMapBean.class)})
    List<ReliefBeans.Bending> reliefs = new ArrayList<>();

    Material toMaterial() {
        Material standard = Material.DEFAULT;
        Shares shares = new Shares(share("diffusion", diffusion, diffusions), share("specular", specular, speculars), share("reflection", reflection, reflections),
                share("transparency", transparency, transparencies), share("roughness", roughness, roughnesses));
        Require.that(reliefs.size() <= 1, "a material has one <bump> or <normal-map> at most; remove one of them");
        return new Material(pattern(), or(diffusion, standard.diffusion()), or(specular, standard.specular()), shininess, or(reflection, standard.reflection()),
                or(transparency, standard.transparency()), refractiveIndex, Fresnel.valueOf(fresnel.toUpperCase(Locale.ROOT)), or(roughness, standard.roughness()), thin,
                attenuationColor, attenuationDistance, emission, emissionStrength, shares, reliefs.isEmpty() ? Relief.FLAT : reliefs.get(0).toRelief());
    }

    private static double or(@Nullable Double given, double otherwise) {
        return given == null ? otherwise : given;
    }

    private static Share share(String name, @Nullable Double given, List<ReliefBeans.ShareBean> patterns) {
        Require.that(patterns.size() <= 1, "a material has one <" + name + "> at most; remove one of them");
        Require.that(given == null || patterns.isEmpty(), "a material has the attribute " + name + " or the element <" + name + ">, not both; remove one of them");
        return patterns.isEmpty() ? new Even() : patterns.get(0).toShare();
    }

    private Pattern pattern() {
        Require.that(patterns.size() <= 1, "a material has one pattern at most; remove one of them");
        Require.that(color == null || patterns.isEmpty(), "a material has either a color or a pattern, not both; remove one of them");
        return !patterns.isEmpty() ? patterns.get(0).toPattern() : color == null ? Material.DEFAULT.pattern() : new Pattern.Plain(color);
    }
}
