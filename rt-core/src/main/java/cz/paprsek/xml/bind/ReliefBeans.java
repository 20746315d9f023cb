package cz.paprsek.xml.bind;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Material.Bump;
import cz.paprsek.material.Material.NormalMap;
import cz.paprsek.material.Material.Relief;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share.ByPattern;
import cz.paprsek.material.Share.ColorChannel;
import cz.paprsek.math.Vec3;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.adapters.CollapsedStringAdapter;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import java.util.Locale;

/** The elements that have a pattern inside other than for the colour, and those of bumps. */
final class ReliefBeans {
    private ReliefBeans() {}

    /** What bends normals. */
    interface Bending {
        Relief toRelief();
    }

    /** The pattern inside; if it is missing, the schema has said so. */
    private static Pattern inside(PatternBeans.AroundBean bean) {
        return bean.patterns.isEmpty() ? new Pattern.Checker(1, Vec3.ZERO, Rgb.WHITE, Rgb.BLACK) : bean.patterns.get(0).toPattern();
    }

    /** {@code <reflection>} and so on. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class ShareBean extends PatternBeans.AroundBean {
        @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String channel = Described.word(ColorChannel.LUMINANCE);

        ByPattern toShare() {
            return new ByPattern(ColorChannel.valueOf(channel.toUpperCase(Locale.ROOT)), inside(this));
        }
    }

    /** {@code <bump>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class BumpBean extends PatternBeans.AroundBean implements Bending {
        @XmlAttribute double strength = 0.02;

        @Override
        public Relief toRelief() {
            return new Bump(strength, inside(this));
        }
    }

    /** {@code <normal-map>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class NormalMapBean extends PatternBeans.PictureBean implements Bending {
        @XmlAttribute double strength = 1;

        @Override
        public Relief toRelief() {
            return new NormalMap(file, strength, filter(), mapping(), lay());
        }
    }
}
