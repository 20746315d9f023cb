package cz.paprsek.xml.quick;

import cz.paprsek.attribute.Described;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Recipe;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SceneRules;
import cz.paprsek.xml.format.SceneFormat;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** Reads {@code <scene>}: what is inside comes in any order. */
final class WholeSceneReader {
    static final byte[] SCENE = Slot.ascii("scene");
    private static final byte[] DESCRIPTION = Slot.ascii("description");
    private static final byte[] RENDER = Slot.ascii("render");
    private static final byte[] BACKGROUND = Slot.ascii("background");
    private static final byte[] AMBIENT = Slot.ascii("ambient");
    private static final byte[] CAMERA = Slot.ascii("camera");

    private static final RecordForm<RenderSettings> SETTINGS = new RecordForm<>(RenderSettings.class);
    /** How many there are if nobody says it depends on another attribute. */
    private static final int SAMPLES = Described.of(RenderSettings.class).stream().map(Described::name).toList().indexOf("samples");
    private static final TagForm SCENE_TAG = new TagForm(List.of(), Described.of(Scene.class).stream().map(Slot::of).toList());
    private static final TagForm SETTINGS_TAG = new TagForm(List.of(), SETTINGS.slots());
    private static final TagForm COLOR_TAG = new TagForm(List.of(), List.of(Slot.required("color", ValueForm.COLOR)));

    private final Markup markup;
    private final double[] room;
    private final MaterialReader materials;
    private final ShapeReader shapes;

    /** @param room for three numbers */
    WholeSceneReader(Markup markup, double[] room) {
        this.markup = markup;
        this.room = room;
        materials = new MaterialReader(markup, room);
        shapes = new ShapeReader(markup, room, materials);
    }

    /** What has been read of the scene at hand; null for what must come once at most, and has not come. */
    private static final class Parts {
        private @Nullable String description;
        private @Nullable RenderSettings settings;
        private @Nullable Rgb background;
        private @Nullable Sky sky;
        private @Nullable Rgb ambient;
        private final List<Camera> cameras = new ArrayList<>();
        private final List<Light> lights = new ArrayList<>();
        private final Map<String, Material> materials = new LinkedHashMap<>();
        private final List<SceneObject> objects = new ArrayList<>();
        private final List<Animation> animations = new ArrayList<>();
    }

    /** The scene whose start tag is at hand, and which is the whole file. */
    Scene readRoot() throws IOException {
        Unusual.unless(markup.isNamed(SCENE));
        return scene(SCENE_TAG.readRoot(markup, room), 1);
    }

    /** The scene whose start tag is at hand. */
    Scene read(int depth) throws IOException {
        Unusual.unless(markup.isNamed(SCENE));
        return scene(SCENE_TAG.read(markup, room), depth);
    }

    @SuppressWarnings("unchecked") // Words come in a list.
    private Scene scene(Object[] values, int depth) throws IOException {
        Parts parts = new Parts();
        if (markup.hasContent(depth)) {
            while (markup.nextTag()) {
                part(parts, depth + 1);
            }
            markup.endTag(SCENE);
        }
        String name = (String) values[0];
        if (!name.isEmpty()) {
            SceneRules.checkName("scene name", name);
        }
        List<String> tags = (List<String>) values[1];
        tags.forEach(tag -> SceneRules.checkName("scene tag", tag));
        Unusual.unless(!parts.cameras.isEmpty() && (parts.background == null || parts.sky == null));
        return new Scene(name, parts.description == null ? "" : parts.description, tags, parts.settings == null ? RenderSettings.DEFAULT : parts.settings,
                parts.background == null ? Rgb.BLACK : parts.background, parts.sky == null ? Sky.NONE : parts.sky, parts.ambient == null ? Rgb.BLACK : parts.ambient,
                parts.cameras, parts.lights, parts.materials, parts.objects, parts.animations, Recipe.NONE);
    }

    private void part(Parts parts, int depth) throws IOException {
        if (markup.isNamed(MaterialReader.ELEMENT)) {
            MaterialReader.Named named = materials.read(depth);
            Unusual.unless(parts.materials.put(named.name(), named.material()) == null);
        } else if (markup.isNamed(CAMERA)) {
            parts.cameras.add(CameraForm.camera(leaf(CameraForm.TAG, CAMERA, depth)));
        } else if (markup.isNamed(RENDER)) {
            Unusual.unless(parts.settings == null);
            parts.settings = settings(leaf(SETTINGS_TAG, RENDER, depth));
        } else if (markup.isNamed(BACKGROUND)) {
            Unusual.unless(parts.background == null);
            parts.background = (Rgb) leaf(COLOR_TAG, BACKGROUND, depth)[0];
        } else if (markup.isNamed(SkyForm.ELEMENT)) {
            Unusual.unless(parts.sky == null);
            parts.sky = SkyForm.sky(leaf(SkyForm.TAG, SkyForm.ELEMENT, depth));
        } else if (markup.isNamed(AMBIENT)) {
            Unusual.unless(parts.ambient == null);
            parts.ambient = (Rgb) leaf(COLOR_TAG, AMBIENT, depth)[0];
        } else if (markup.isNamed(DESCRIPTION)) {
            Unusual.unless(parts.description == null);
            parts.description = text(DESCRIPTION);
        } else if (markup.isNamed(AnimationForm.ELEMENT)) {
            parts.animations.add(AnimationForm.read(markup, room, depth));
        } else {
            bodyOrLight(parts, depth);
        }
    }

    private static RenderSettings settings(Object[] values) {
        RenderSettings settings = SETTINGS.make(values, 0);
        return SETTINGS.isUntouched(values, 0, SAMPLES) ? settings.withSamples(settings.integrator().usualSamples()) : settings;
    }

    private void bodyOrLight(Parts parts, int depth) throws IOException {
        for (LightForm light : LightForm.ALL) {
            if (light.name().isAtHand(markup)) {
                Object[] values = light.tag().read(markup, room);
                if (markup.hasContent(depth)) {
                    Unusual.unless(!markup.nextTag());
                    light.name().end(markup);
                }
                parts.lights.add(light.make(values));
                return;
            }
        }
        parts.objects.add(shapes.object(depth));
        if (parts.objects.size() == ManyObjects.MANY && depth == ManyObjects.DEPTH) {
            markup.readOn(ManyObjects.read(markup.rest(), materials, parts.objects));
        }
    }

    /** The attributes of an element that has nothing inside. */
    private Object[] leaf(TagForm tag, byte[] element, int depth) throws IOException {
        Object[] values = tag.read(markup, room);
        markup.noContent(element, depth);
        return values;
    }

    private String text(byte[] element) throws IOException {
        Unusual.unless(!markup.nextAttribute());
        if (markup.isEmptyElement()) {
            return "";
        }
        String text = markup.content();
        Unusual.unless(text.length() <= SceneFormat.LONGEST_DESCRIPTION && !markup.nextTag());
        markup.endTag(element);
        return text;
    }
}
