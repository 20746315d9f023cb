package cz.paprsek.xml.bind;

import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.math.Require;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.Integrator;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SceneRules;
import cz.paprsek.text.Similar;
import cz.paprsek.xml.mistake.Problems;
import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlElementRef;
import jakarta.xml.bind.annotation.XmlElements;
import jakarta.xml.bind.annotation.XmlRootElement;
import jakarta.xml.bind.annotation.XmlType;
import jakarta.xml.bind.annotation.adapters.CollapsedStringAdapter;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/** {@code <scene>} and what only a scene holds. */
@XmlRootElement(name = "scene")
@XmlAccessorType(XmlAccessType.FIELD)
@XmlType(propOrder = {})
final class SceneBean extends Located {
    @XmlAttribute String name = "";
    @XmlAttribute List<String> tags = new ArrayList<>();
    @XmlElement String description = "";
    @XmlElement RenderBean render = new RenderBean();
    @XmlElement @Nullable ColoredBean background;
    @XmlElement @Nullable SkyBean sky;
    @XmlElement @Nullable ColoredBean ambient;
    @XmlElement(name = "camera") List<CameraBean> cameras = new ArrayList<>();
    @XmlElements({
        @XmlElement(name = "point-light", type = LightBeans.PointLightBean.class),
        @XmlElement(name = "spot-light", type = LightBeans.SpotLightBean.class),
        @XmlElement(name = "area-light", type = LightBeans.AreaLightBean.class),
        @XmlElement(name = "sphere-light", type = LightBeans.SphereLightBean.class),
        @XmlElement(name = "sun-light", type = LightBeans.SunLightBean.class)})
    List<LightBeans.LightBean> lights = new ArrayList<>();
    @XmlElement(name = "material") List<MaterialBean> materials = new ArrayList<>();
    @XmlElementRef List<ShapeBean> objects = new ArrayList<>();
    @XmlElement(name = "animate") List<AnimationBean> animations = new ArrayList<>();

    /** The scene; null, and at least one problem reported, if there is none. */
    @Nullable Scene toScene(Problems problems) {
        if (cameras.isEmpty() && Similar.nearest("camera", problems.skipped()).isEmpty()) {
            problems.add(this, "a scene needs a camera; add <camera position=\"0 1 5\" direction=\"0 0 -1\"/>");
        }
        List<Camera> eyes = made(cameras, problems, CameraBean::toCamera);
        SceneRules.checkCameras(eyes, (culprit, attribute, sentence) -> problems.add(problems.origin(culprit, this), sentence, attribute));
        checkTexts(problems);
        RenderSettings settings = problems.make(render, render::toSettings);
        Sky above = sky == null ? Sky.NONE : problems.make(sky, sky::toSky);
        if (sky != null && background != null) {
            problems.add(sky, Scene.EITHER_SKY);
        }
        Map<String, Material> named = named(problems);
        List<Light> lamps = made(lights, problems, LightBeans.LightBean::toLight);
        List<SceneObject> made = made(objects, problems, bean -> bean.toObject(problems));
        // References to materials that were refused are no fault of those who refer.
        if (Similar.nearest("material", problems.skipped()).isEmpty()) {
            SceneRules.check(lamps, named, made, (culprit, attribute, sentence) -> problems.add(problems.origin(culprit, this), sentence, attribute));
        }
        List<Animation> moves = made(animations, problems, bean -> bean.toAnimation(problems));
        if (problems.size() > 0 || eyes.isEmpty() || settings == null || above == null) {
            return null;
        }
        Scene still = new Scene(name, description, tags, settings, background == null ? Rgb.BLACK : background.color, above,
                ambient == null ? Rgb.BLACK : ambient.color, eyes, lamps, named, made);
        SceneRules.checkAnimations(still, moves, (culprit, attribute, sentence) -> problems.add(problems.origin(culprit, this), sentence, attribute));
        return problems.size() > 0 ? null : still.withAnimations(moves);
    }

    private static <B extends Located, T> List<T> made(List<B> beans, Problems problems, Function<B, T> maker) {
        List<T> made = new ArrayList<>(beans.size());
        for (B bean : beans) {
            T one = problems.make(bean, () -> maker.apply(bean));
            if (one != null) {
                made.add(one);
            }
        }
        return made;
    }

    /** The materials by name. One that refuses counts as there, so that only itself is a problem. */
    private Map<String, Material> named(Problems problems) {
        Map<String, Material> named = new LinkedHashMap<>();
        for (MaterialBean bean : materials) {
            Material material = problems.make(bean, bean::toMaterial);
            if (named.put(bean.name, material == null ? Material.DEFAULT : material) != null) {
                problems.add(bean, "there is already a material named \"" + bean.name + "\" here; give one of them another name", "name");
            }
        }
        return named;
    }

    private void checkTexts(Problems problems) {
        check("name", name.isEmpty() ? List.of() : List.of(name), problems);
        check("tags", tags, problems);
    }

    private void check(String attribute, List<String> texts, Problems problems) {
        try {
            texts.forEach(text -> SceneRules.checkName(attribute.equals("name") ? "scene name" : "scene tag", text));
        } catch (IllegalArgumentException refused) {
            problems.add(this, String.valueOf(refused.getMessage()), attribute);
        }
    }

    /** {@code <render>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class RenderBean extends Located {
        @XmlAttribute int width = RenderSettings.DEFAULT.width();
        @XmlAttribute int height = RenderSettings.DEFAULT.height();
        @XmlAttribute(name = "max-depth") int maxDepth = RenderSettings.DEFAULT.maxDepth();
        @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String integrator = RenderSettings.DEFAULT.integrator().toString();
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.FromTo.class) int @Nullable [] samples;
        @XmlAttribute double error = RenderSettings.DEFAULT.error();
        @XmlAttribute double confidence = RenderSettings.DEFAULT.confidence();
        @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String filter = RenderSettings.DEFAULT.filter().toString();
        @XmlAttribute double exposure = RenderSettings.DEFAULT.exposure();
        @XmlAttribute @XmlJavaTypeAdapter(CollapsedStringAdapter.class) String tone = RenderSettings.DEFAULT.tone().toString();
        @XmlAttribute double fps = RenderSettings.DEFAULT.fps();
        @XmlAttribute double shutter = RenderSettings.DEFAULT.shutter();

        RenderSettings toSettings() {
            Integrator kind = Integrator.valueOf(integrator.toUpperCase(Locale.ROOT));
            int least = samples == null ? kind.usualSamples() : samples[0];
            int most = samples == null ? 0 : samples[1];
            return new RenderSettings(width, height, maxDepth, kind, least, most, error, confidence, PixelFilter.valueOf(filter.toUpperCase(Locale.ROOT)),
                    exposure, Tone.valueOf(tone.toUpperCase(Locale.ROOT)), fps, shutter);
        }
    }

    /** {@code <background>} and {@code <ambient>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class ColoredBean extends Located {
        @XmlAttribute(required = true) @XmlJavaTypeAdapter(Adapters.Color.class) Rgb color = Rgb.BLACK;
    }

    /** {@code <sky>}. */
    @XmlAccessorType(XmlAccessType.FIELD)
    static final class SkyBean extends Located {
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) @Nullable Rgb zenith;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) @Nullable Rgb horizon;
        @XmlAttribute @XmlJavaTypeAdapter(Adapters.Color.class) @Nullable Rgb ground;
        @XmlAttribute @Nullable String file;
        @XmlAttribute @Nullable Double rotation;
        @XmlAttribute @Nullable Double intensity;

        Sky toSky() {
            if (file != null) {
                Require.that(zenith == null && horizon == null && ground == null, "a sky has either a file or colours, not both; remove one of them");
                return new Sky.Picture(file, rotation == null ? 0 : rotation, intensity == null ? 1 : intensity);
            }
            Require.that(rotation == null && intensity == null, "the rotation and intensity of a sky are those of its picture; give it a file");
            Sky.Gradient usual = Sky.Gradient.DEFAULT;
            return new Sky.Gradient(zenith == null ? usual.zenith() : zenith, horizon == null ? usual.horizon() : horizon, ground == null ? usual.ground() : ground);
        }
    }
}
