package cz.paprsek.xml.bind;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
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
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** The elements of patterns. */
final class PatternBeans {
    private PatternBeans() {}

    /** What all are. */
    interface PatternBean {
        Pattern toPattern();
    }

    /** What has patterns inside. */
    @XmlAccessorType(XmlAccessType.FIELD)
    abstract static class AroundBean extends Located {
        @XmlElements({
            @XmlElement(name = "checkerboard", type = CheckerboardBean.class),
            @XmlElement(name = "checker", type = CheckerBean.class),
            @XmlElement(name = "gradient", type = GradientBean.class),
            @XmlElement(name = "stripes", type = StripesBean.class),
            @XmlElement(name = "brick", type = BrickBean.class),
            @XmlElement(name = "marble", type = MarbleBean.class),
            @XmlElement(name = "wood", type = WoodBean.class),
            @XmlElement(name = "granite", type = GraniteBean.class),
            @XmlElement(name = "noise", type = NoiseBean.class),
            @XmlElement(name = "image", type = ImageBean.class)})
        List<PatternBean> patterns = new ArrayList<>();
    }

    /** What those have that lie in space. */
    @XmlAccessorType(XmlAccessType.FIELD)
    abstract static class LaidBean {
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 position = Vec3.ZERO;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 rotation = Vec3.ZERO;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Scale.class) Vec3 scale = Vec3.ONE;

        final Pattern.Lay lay() {
            return new Pattern.Lay(position, rotation, scale);
        }
    }

    /** What those have that are of one colour or of another. */
    @XmlAccessorType(XmlAccessType.FIELD)
    abstract static class EvenOrOddBean extends LaidBean {
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) Rgb even = Rgb.WHITE;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) Rgb odd = Rgb.BLACK;
    }

    /** What those have that mix colours. */
    @XmlAccessorType(XmlAccessType.FIELD)
    abstract static class MixedBean extends LaidBean {
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) @Nullable Rgb even;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) @Nullable Rgb odd;
        @XmlElement(name = "stop") List<StopBean> stops = new ArrayList<>();

        final Pattern.Colors colors() {
            Require.that(stops.isEmpty() || (even == null && odd == null), "a pattern has either two colours or stops, not both; remove one of them");
            return !stops.isEmpty() ? new Pattern.Stops(stops.stream().map(stop -> new Pattern.Stop(stop.at, stop.color)).toList())
                    : new Pattern.TwoColors(Objects.requireNonNullElse(even, Rgb.WHITE), Objects.requireNonNullElse(odd, Rgb.BLACK));
        }
    }

    /** What pictures have. */
    @XmlAccessorType(XmlAccessType.FIELD)
    abstract static class PictureBean extends LaidBean {
        @XmlAttribute(required = true) String file = "";
        @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String filter = Described.word(Pattern.Filter.SMOOTH);
        @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String mapping = Described.word(Pattern.Mapping.UV);

        final Pattern.Filter filter() {
            return Pattern.Filter.valueOf(filter.toUpperCase(Locale.ROOT));
        }

        final Pattern.Mapping mapping() {
            return Pattern.Mapping.valueOf(mapping.toUpperCase(Locale.ROOT));
        }
    }

    /** {@code <stop>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class StopBean {
        @XmlAttribute(required = true) double at;
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Color.class) Rgb color = Rgb.BLACK;
    }

    /** {@code <checkerboard>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class CheckerboardBean implements PatternBean {
        @XmlAttribute(required = true) int columns;
        @XmlAttribute(required = true) int rows;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) Rgb even = Rgb.WHITE;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) Rgb odd = Rgb.BLACK;

        @Override
        public Pattern toPattern() {
            return new Pattern.Checkerboard(columns, rows, even, odd);
        }
    }

    /** {@code <checker>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class CheckerBean extends EvenOrOddBean implements PatternBean {
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Scale.class) Vec3 size = Vec3.ONE;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 origin = Vec3.ZERO;

        @Override
        public Pattern toPattern() {
            return new Pattern.Checker(size, origin, even, odd, lay());
        }
    }

    /** {@code <gradient>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class GradientBean extends MixedBean implements PatternBean {
        @Override
        public Pattern toPattern() {
            return new Pattern.Gradient(colors(), lay());
        }
    }

    /** {@code <stripes>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class StripesBean extends EvenOrOddBean implements PatternBean {
        @XmlAttribute(required = true) double size;

        @Override
        public Pattern toPattern() {
            return new Pattern.Stripes(size, even, odd, lay());
        }
    }

    /** {@code <brick>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class BrickBean extends EvenOrOddBean implements PatternBean {
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 size = Vec3.ONE;
        @XmlAttribute double mortar = 0.01;

        @Override
        public Pattern toPattern() {
            return new Pattern.Brick(size, mortar, even, odd, lay());
        }
    }

    /** {@code <marble>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class MarbleBean extends MixedBean implements PatternBean {
        @XmlAttribute double frequency = 1;
        @XmlAttribute double turbulence = 1;
        @XmlAttribute int octaves = 4;
        @XmlAttribute int seed;

        @Override
        public Pattern toPattern() {
            return new Pattern.Marble(frequency, turbulence, octaves, seed, colors(), lay());
        }
    }

    /** {@code <wood>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class WoodBean extends MixedBean implements PatternBean {
        @XmlAttribute double frequency = 8;
        @XmlAttribute double turbulence = 0.4;
        @XmlAttribute int octaves = 2;
        @XmlAttribute int seed;

        @Override
        public Pattern toPattern() {
            return new Pattern.Wood(frequency, turbulence, octaves, seed, colors(), lay());
        }
    }

    /** {@code <granite>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class GraniteBean extends MixedBean implements PatternBean {
        @XmlAttribute int octaves = 6;
        @XmlAttribute int seed;

        @Override
        public Pattern toPattern() {
            return new Pattern.Granite(octaves, seed, colors(), lay());
        }
    }

    /** {@code <noise>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class NoiseBean extends MixedBean implements PatternBean {
        @XmlAttribute int octaves = 4;
        @XmlAttribute int seed;

        @Override
        public Pattern toPattern() {
            return new Pattern.Noise(octaves, seed, colors(), lay());
        }
    }

    /** {@code <image>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class ImageBean extends PictureBean implements PatternBean {
        @Override
        public Pattern toPattern() {
            return new Pattern.Picture(file, filter(), mapping(), lay());
        }
    }
}
