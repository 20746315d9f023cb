package cz.paprsek.xml;

import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SceneRules;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Solid;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlElements;
import jakarta.xml.bind.annotation.XmlRootElement;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** {@code <scene>} and what only a scene holds. */
@XmlRootElement(name = "scene")
@XmlAccessorType(XmlAccessType.FIELD)
final class SceneBean extends Located {
    @XmlAttribute String name = "";
    @XmlAttribute List<String> tags = new ArrayList<>();
    @XmlElement(name = "description") List<String> descriptions = new ArrayList<>();
    @XmlElement(name = "render") List<RenderBean> renders = new ArrayList<>();
    @XmlElement(name = "background") List<ColoredBean> backgrounds = new ArrayList<>();
    @XmlElement(name = "ambient") List<ColoredBean> ambients = new ArrayList<>();
    @XmlElement(name = "camera") List<CameraBean> cameras = new ArrayList<>();
    @XmlElement(name = "point-light") List<LightBean> lights = new ArrayList<>();
    @XmlElement(name = "material") List<MaterialBean> materials = new ArrayList<>();
    @XmlElements({
        @XmlElement(name = "sphere", type = ShapeBeans.SphereBean.class),
        @XmlElement(name = "block", type = ShapeBeans.BlockBean.class),
        @XmlElement(name = "ellipsoid", type = ShapeBeans.EllipsoidBean.class),
        @XmlElement(name = "rectangle", type = ShapeBeans.RectangleBean.class),
        @XmlElement(name = "disc", type = ShapeBeans.DiscBean.class),
        @XmlElement(name = "plane", type = ShapeBeans.PlaneBean.class),
        @XmlElement(name = "cylinder", type = ShapeBeans.CylinderBean.class),
        @XmlElement(name = "cone", type = ShapeBeans.ConeBean.class),
        @XmlElement(name = "torus", type = ShapeBeans.TorusBean.class),
        @XmlElement(name = "union", type = CsgBean.UnionBean.class),
        @XmlElement(name = "difference", type = CsgBean.DifferenceBean.class),
        @XmlElement(name = "intersection", type = CsgBean.IntersectionBean.class)})
    List<ShapeBean> objects = new ArrayList<>();

    /** The scene; null, and at least one problem reported, if there is none. */
    @Nullable Scene toScene(Problems problems) {
        int before = problems.size();
        atMostOne("description", descriptions, problems);
        atMostOne("render", renders, problems);
        atMostOne("background", backgrounds, problems);
        atMostOne("ambient", ambients, problems);
        atMostOne("camera", cameras, problems);
        if (cameras.isEmpty()) {
            problems.add(this, "a scene needs a camera; add <camera position=\"0 1 5\" direction=\"0 0 -1\"/>");
        }
        List<Camera> camera = new ArrayList<>();
        cameras.forEach(bean -> problems.attempt(bean, () -> camera.add(bean.toCamera())));
        Map<String, Material> named = new LinkedHashMap<>();
        for (MaterialBean bean : materials) {
            problems.attempt(bean, () -> Require.that(named.put(bean.name, bean.toMaterial()) == null,
                    "there is already a material named \"" + bean.name + "\" here; give one of them another name"));
        }
        List<Light> lamps = lights.stream().map(LightBean::toLight).toList();
        List<SceneObject> made = new ArrayList<>(objects.size());
        for (ShapeBean bean : objects) {
            problems.attempt(bean, () -> made.add(
                    new SceneObject(bean.name, bean.toShape(problems), bean.toPlacement(), bean.toMaterial())));
        }
        if (problems.size() == before) {
            SceneRules.check(lamps, named, made, (culprit, sentence) -> problems.add(find(culprit, lamps, made), sentence));
        }
        return problems.size() > before ? null
                : new Scene(name, descriptions.isEmpty() ? "" : descriptions.get(0), tags,
                        renders.isEmpty() ? RenderSettings.DEFAULT : renders.get(0).toSettings(),
                        backgrounds.isEmpty() ? Rgb.BLACK : backgrounds.get(0).color,
                        ambients.isEmpty() ? Rgb.BLACK : ambients.get(0).color,
                        camera.get(0), lamps, named, made);
    }

    private void atMostOne(String element, List<?> found, Problems problems) {
        if (found.size() > 1) {
            Located where = found.get(1) instanceof Located bean ? bean : this;
            problems.add(where, "a scene has at most one <" + element + ">, but here are " + found.size());
        }
    }

    /** The bean that a light, object or operand was made from: every list of records runs parallel to one of beans. */
    private Located find(Object culprit, List<Light> lamps, List<SceneObject> made) {
        for (int i = 0; i < lamps.size(); i++) {
            if (lamps.get(i) == culprit) {
                return lights.get(i);
            }
        }
        for (int i = 0; i < made.size(); i++) {
            Located found = made.get(i) == culprit ? objects.get(i) : find(culprit, made.get(i).shape(), objects.get(i));
            if (found != null) {
                return found;
            }
        }
        return this;
    }

    private static @Nullable Located find(Object culprit, Object shape, ShapeBean bean) {
        if (shape instanceof Csg csg && bean instanceof CsgBean csgBean) {
            for (int i = 0; i < csg.operands().size(); i++) {
                Solid solid = csg.operands().get(i).solid();
                Located found = csg.operands().get(i) == culprit ? csgBean.operands.get(i) : find(culprit, solid, csgBean.operands.get(i));
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }

    /** {@code <render>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class RenderBean extends Located {
        @XmlAttribute int width = RenderSettings.DEFAULT.width();
        @XmlAttribute int height = RenderSettings.DEFAULT.height();
        @XmlAttribute(name = "max-depth") int maxDepth = RenderSettings.DEFAULT.maxDepth();
        @XmlAttribute int samples = RenderSettings.DEFAULT.samples();

        RenderSettings toSettings() {
            return new RenderSettings(width, height, maxDepth, samples);
        }
    }

    /** {@code <background>} and {@code <ambient>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class ColoredBean extends Located {
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) Rgb color = Rgb.BLACK;
    }

    /** {@code <camera>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class CameraBean extends Located {
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 position = Vec3.ZERO;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) @Nullable Vec3 direction;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) @Nullable Vec3 target;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 up = Camera.DEFAULT.up();
        @XmlAttribute double fovy = Camera.DEFAULT.fovy();

        Camera toCamera() {
            Require.that(direction != null || target != null, "<camera> needs a direction or a target");
            Require.that(direction == null || target == null, "<camera> has either a direction or a target, not both; remove one of them");
            Camera.Aim aim = direction != null ? new Camera.Direction(direction)
                    : new Camera.Target(java.util.Objects.requireNonNull(target));
            return new Camera(position, aim, up, fovy);
        }
    }

    /** {@code <point-light>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class LightBean extends Located {
        @XmlAttribute String name = "";
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Vector.class) Vec3 position = Vec3.ZERO;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) Rgb color = Rgb.WHITE;
        @XmlAttribute double intensity = 1;

        Light toLight() {
            return new Light(name, position, color, intensity);
        }
    }
}
