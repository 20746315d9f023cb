package cz.paprsek.xml.bind;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Material.Bump;
import cz.paprsek.material.Material.ByPattern;
import cz.paprsek.material.Material.ColorChannel;
import cz.paprsek.material.Material.NormalMap;
import cz.paprsek.material.Material.Relief;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlElements;
import jakarta.xml.bind.annotation.adapters.CollapsedStringAdapter;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/** The elements that have a pattern inside other than for the colour, and those of bumps. */
final class ReliefBeans {
    private ReliefBeans() {}

    /** What all are that bend normals, and some others. */
    @XmlAccessorType(XmlAccessType.FIELD)
    abstract static class PartBean {}

    /** What bends normals. */
    interface Bending {
        Relief toRelief();
    }

    /** What has a pattern inside. */
    @XmlAccessorType(XmlAccessType.FIELD)
    abstract static class AroundBean extends PartBean {
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
        PatternBeans.@Nullable PatternBean pattern;

        /** If it is missing, the schema has said so. */
        final Pattern toPattern() {
            return pattern == null ? new Pattern.Checker(1, Vec3.ZERO, Rgb.WHITE, Rgb.BLACK) : pattern.toPattern();
        }
    }

    /** {@code <reflection>} and so on. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class ShareBean extends AroundBean {
        @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String channel = Described.word(ColorChannel.LUMINANCE);

        ByPattern toShare() {
            return new ByPattern(ColorChannel.valueOf(channel.toUpperCase(Locale.ROOT)), toPattern());
        }
    }

    /** {@code <bump>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class BumpBean extends AroundBean implements Bending {
        @XmlAttribute double strength = 0.02;

        @Override
        public Relief toRelief() {
            return new Bump(strength, toPattern());
        }
    }

    /** {@code <normal-map>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class NormalMapBean extends PartBean implements Bending {
        @XmlAttribute(required = true) String file = "";
        @XmlAttribute double strength = 1;
        @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String filter = Described.word(Pattern.Filter.SMOOTH);
        @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String mapping = Described.word(Pattern.Mapping.UV);
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 position = Vec3.ZERO;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 rotation = Vec3.ZERO;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Scale.class) Vec3 scale = Vec3.ONE;

        @Override
        public Relief toRelief() {
            return new NormalMap(file, strength, Pattern.Filter.valueOf(filter.toUpperCase(Locale.ROOT)), Pattern.Mapping.valueOf(mapping.toUpperCase(Locale.ROOT)),
                    new Pattern.Lay(position, rotation, scale));
        }
    }
}
