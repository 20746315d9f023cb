package cz.paprsek.xml.bind;

import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import org.jspecify.annotations.Nullable;

/** The elements of lights. */
final class LightBeans {
    private LightBeans() {}

    /** What all have. */
    @XmlAccessorType(XmlAccessType.FIELD)
    abstract static class LightBean extends Located {
        @XmlAttribute String name = "";
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) Rgb color = Rgb.WHITE;
        @XmlAttribute double intensity = 1;

        abstract Light toLight();
    }

    /** {@code <point-light>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class PointLightBean extends LightBean {
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 position = Vec3.ZERO;
        @XmlAttribute(name = "reference-distance") double referenceDistance;

        @Override
        Light toLight() {
            return new PointLight(name, position, color, intensity, referenceDistance);
        }
    }

    /** {@code <spot-light>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class SpotLightBean extends LightBean {
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 position = Vec3.ZERO;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) @Nullable Vec3 direction;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) @Nullable Vec3 target;
        @XmlAttribute(name = "reference-distance") double referenceDistance;
        @XmlAttribute(name = "inner-angle") @Nullable Double innerAngle;
        @XmlAttribute(name = "outer-angle") double outerAngle = 45;

        @Override
        Light toLight() {
            SpotLight usual = SpotLight.from(position, position.plus(Vec3.Y));
            SpotLight light = new SpotLight(name, position, CameraBean.aim("spot-light", direction, target), color, intensity, referenceDistance,
                    innerAngle == null ? usual.innerAngle() : innerAngle, outerAngle);
            if (innerAngle != null) {
                SpotLight.checkInner(innerAngle, outerAngle);
            }
            return light;
        }
    }

    /** {@code <area-light>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class AreaLightBean extends LightBean {
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 position = Vec3.ZERO;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 rotation = Vec3.ZERO;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Pair.class) double @Nullable [] size;
        @XmlAttribute @Nullable Double radius;
        @XmlAttribute(name = "reference-distance") double referenceDistance = 1;
        @XmlAttribute int samples = 16;
        @XmlAttribute boolean visible = true;

        @Override
        Light toLight() {
            return new AreaLight(name, position, rotation, form(), color, intensity, referenceDistance, samples, visible);
        }

        private AreaLight.Form form() {
            Require.that(size == null || radius == null, "<area-light> has either a size or a radius, not both; remove one of them");
            if (radius != null) {
                return new AreaLight.Radius(radius);
            } else if (size != null) {
                return new AreaLight.Size(size[0], size[1]);
            }
            throw new IllegalArgumentException("<area-light> needs a size or a radius");
        }
    }

    /** {@code <sphere-light>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class SphereLightBean extends LightBean {
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 position = Vec3.ZERO;
        @XmlAttribute(required = true) double radius;
        @XmlAttribute(name = "reference-distance") double referenceDistance = 1;
        @XmlAttribute int samples = 16;
        @XmlAttribute boolean visible = true;

        @Override
        Light toLight() {
            return new SphereLight(name, position, radius, color, intensity, referenceDistance, samples, visible);
        }
    }

    /** {@code <sun-light>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class SunLightBean extends LightBean {
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 direction = Vec3.ZERO;
        @XmlAttribute double angle;
        @XmlAttribute boolean visible;

        @Override
        Light toLight() {
            return new SunLight(name, direction, color, intensity, angle, visible);
        }
    }
}
