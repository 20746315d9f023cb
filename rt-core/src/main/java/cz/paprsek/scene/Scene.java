package cz.paprsek.scene;

import cz.paprsek.attribute.Attribute;
import cz.paprsek.attribute.Element;
import cz.paprsek.attribute.Kind;
import cz.paprsek.list.Difference;
import cz.paprsek.list.Pieces;
import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.text.Numbers;
import cz.paprsek.text.Similar;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SortedSet;
import java.util.function.BiFunction;
import java.util.function.DoubleFunction;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * A whole scene: the one immutable truth that files are read into, the editor edits and the renderer renders.
 * Right-handed world, y up.
 *
 * @param name free text; empty for none
 * @param description free text; empty for none
 * @param tags words to find the scene by
 * @param settings how it wishes to be rendered
 * @param background what a ray sees that hits nothing
 * @param sky the same by the direction of the ray; not beside a background other than black
 * @param ambient light that reaches every point alike
 * @param cameras the eyes, at least one; the picture is what the first sees
 * @param lights any number, also none
 * @param materials the named materials, in the order of the file
 * @param objects any number, also none
 * @param animations what is not the same at all times; all else that is here is the scene as it is written, which is rendered if nobody asks for a time
 * @param recipe how the file makes it, with its formulas; {@link Recipe#NONE} if it is only written down
 */
@Element("A scene. Its elements may come in any order; at least one camera, at most one render, background or sky, ambient and description.")
public record Scene(
        @Attribute(value = Kind.NAME, means = "What the scene is called; no control characters, as in all names", otherwise = Attribute.NOTHING) String name,
        @Attribute(value = Kind.FREE_TEXT, isElement = true, means = "Free text", otherwise = Attribute.NOTHING) String description,
        @Attribute(value = Kind.WORDS, means = "Words to find it by", otherwise = Attribute.NOTHING) List<String> tags,
        RenderSettings settings,
        @Attribute(value = Kind.COLOR, isElement = true, means = "What a ray sees that hits nothing", otherwise = "0 0 0") Rgb background,
        Sky sky,
        @Attribute(value = Kind.COLOR, isElement = true, means = "Light that reaches every point", otherwise = "0 0 0") Rgb ambient,
        List<Camera> cameras,
        List<Light> lights,
        Map<String, Material> materials,
        List<SceneObject> objects,
        List<Animation> animations,
        Recipe recipe) {

    /** No object, no light, black all around. */
    public static final Scene EMPTY = new Scene("", "", List.of(), RenderSettings.DEFAULT, Rgb.BLACK, Sky.NONE, Rgb.BLACK,
            List.of(Camera.DEFAULT), List.of(), Map.of(), List.of());

    /** What is said of a scene that has both. */
    public static final String EITHER_SKY = "a scene has either a background or a sky, not both; remove one of them";

    /** @throws IllegalArgumentException with the first sentence of {@link SceneRules} that is broken */
    public Scene {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(description, "description");
        Objects.requireNonNull(settings, "settings");
        Objects.requireNonNull(background, "background");
        Objects.requireNonNull(ambient, "ambient");
        Objects.requireNonNull(sky, "sky");
        Require.that(sky instanceof Sky.None || background.equals(Rgb.BLACK), EITHER_SKY);
        tags = List.copyOf(tags);
        Require.that(!cameras.isEmpty(), "a scene needs a camera");
        cameras = Checked.of(cameras, Camera.class, all -> SceneRules.checkCameras(all, SceneRules.REFUSE));
        lights = Checked.of(lights, Light.class, all -> SceneRules.checkLights(all, SceneRules.REFUSE));
        Checked.Materials palette = materials instanceof Checked.Materials known ? known : new Checked.Materials(materials);
        materials = palette;
        objects = Checked.of(objects, palette, all -> SceneRules.checkObjects(all, palette, SceneRules.REFUSE));
        Objects.requireNonNull(recipe, "recipe");
        animations = animations.isEmpty() ? List.of() : Checked.of(animations, new Scene(name, description, tags, settings, background, sky, ambient, cameras, lights, materials, objects));
    }

    /** A scene that is only written down, and in which nothing moves. */
    public Scene(String name, String description, List<String> tags, RenderSettings settings, Rgb background, Sky sky, Rgb ambient, List<Camera> cameras,
            List<Light> lights, Map<String, Material> materials, List<SceneObject> objects) {
        this(name, description, tags, settings, background, sky, ambient, cameras, lights, materials, objects, List.of(), Recipe.NONE);
    }

    /** With another note of how it is made; what it has stays. */
    public Scene withRecipe(Recipe value) {
        return new Scene(name, description, tags, settings, background, sky, ambient, cameras, lights, materials, objects, animations, value);
    }

    /** @throws IllegalArgumentException if one is of nothing in the scene, of several things, or of an attribute that has no such values */
    public Scene withAnimations(List<Animation> value) {
        return new Scene(name, description, tags, settings, background, sky, ambient, cameras, lights, materials, objects, value, recipe);
    }

    /**
     * The scene at a time, in which nothing moves any more. What does not move is the very same as in this scene. Animations of parameters, and formulas with the time, are for
     * whoever makes scenes of their recipes: the scene files.
     *
     * @param t seconds
     * @throws IllegalArgumentException if a value between two keys is none that it can have
     */
    public Scene at(double t) {
        return moments().apply(t);
    }

    /** As {@link #at}, for many times: what moves is looked up once. */
    public DoubleFunction<Scene> moments() {
        return Animations.of(this);
    }

    public Scene withName(String value) {
        return new Scene(value, description, tags, settings, background, sky, ambient, cameras, lights, materials, objects, animations, recipe);
    }

    public Scene withDescription(String value) {
        return new Scene(name, value, tags, settings, background, sky, ambient, cameras, lights, materials, objects, animations, recipe);
    }

    public Scene withTags(List<String> value) {
        return new Scene(name, description, value, settings, background, sky, ambient, cameras, lights, materials, objects, animations, recipe);
    }

    public Scene withSettings(RenderSettings value) {
        return new Scene(name, description, tags, value, background, sky, ambient, cameras, lights, materials, objects, animations, recipe);
    }

    /** With a background, and no sky. */
    public Scene withBackground(Rgb value) {
        return new Scene(name, description, tags, settings, value, Sky.NONE, ambient, cameras, lights, materials, objects, animations, recipe);
    }

    /** With a sky, and no background. */
    public Scene withSky(Sky value) {
        return new Scene(name, description, tags, settings, Rgb.BLACK, value, ambient, cameras, lights, materials, objects, animations, recipe);
    }

    public Scene withAmbient(Rgb value) {
        return new Scene(name, description, tags, settings, background, sky, value, cameras, lights, materials, objects, animations, recipe);
    }

    /** The names of the files it needs besides its own: pictures and meshes, relative to its folder. */
    public SortedSet<String> files() {
        return Bodies.files(this);
    }

    /** The camera whose picture it is: the first. */
    public Camera camera() {
        return cameras.get(0);
    }

    /** With another camera in the place of the first. */
    public Scene withCamera(Camera value) {
        List<Camera> all = new ArrayList<>(cameras);
        all.set(0, value);
        return withCameras(all);
    }

    public Scene withCameras(List<Camera> value) {
        return new Scene(name, description, tags, settings, background, sky, ambient, value, lights, materials, objects, animations, recipe);
    }

    /** As one of its cameras sees it, counted from 0: that one comes first, the others as they were. */
    public Scene through(int camera) {
        List<Camera> all = new ArrayList<>(cameras);
        all.add(0, all.remove(camera));
        return changed(scene -> scene.withCameras(all), place -> Optional.of(place instanceof ScenePath.CameraAt at && at.index() <= camera
                ? ScenePath.camera(at.index() == camera ? 0 : at.index() + 1) : place));
    }

    /**
     * Changes of what there is and of what it is called: animations, which go by names and numbers, follow what they are of; those of what is not there any more are dropped.
     *
     * @param place where in the changed scene something is that was at a place before
     * @throws IllegalArgumentException if the change makes a scene that cannot be
     */
    public Scene changed(UnaryOperator<Scene> change, Function<ScenePath, Optional<ScenePath>> place) {
        Objects.requireNonNull(change, "change");
        Objects.requireNonNull(place, "place");
        return Animations.following(this, change, place);
    }

    /**
     * As {@link #through(int)}.
     *
     * @param camera its name or, if there is none of that name, its number, counted from 1
     * @throws IllegalArgumentException if there is no such camera, with a list of those there are
     */
    public Scene through(String camera) {
        for (int i = 0; i < cameras.size(); i++) {
            if (!camera.isEmpty() && cameras.get(i).name().equals(camera)) {
                return through(i);
            }
        }
        List<String> names = cameras.stream().map(Camera::name).filter(name -> !name.isEmpty()).toList();
        Require.that(camera.matches("[1-9][0-9]{0,8}") && Integer.parseInt(camera) <= cameras.size(),
                "there is no camera \"" + camera + "\"" + Similar.suggestion(camera, names) + "; the scene has "
                        + (cameras.size() == 1 ? "1 camera" : cameras.size() + " cameras") + (names.isEmpty() ? ", by number only" : ": " + String.join(", ", names)));
        return through(Integer.parseInt(camera) - 1);
    }

    public Scene withLights(List<Light> value) {
        return new Scene(name, description, tags, settings, background, sky, ambient, cameras, value, materials, objects, animations, recipe);
    }

    /**
     * What one of its lights, counted from 0, adds to the picture: the others are dark but stand where they stood, nothing is ambient, and the
     * background is black. With a grid of samples, these pictures of all lights and one without any add up to that of the scene.
     */
    public Scene litBy(int light) {
        List<Light> dark = new ArrayList<>(lights);
        dark.replaceAll(LightRules::unlit);
        dark.set(light, lights.get(light));
        return new Scene(name, description, tags, settings, Rgb.BLACK, Sky.NONE, Rgb.BLACK, cameras, dark, materials, objects, animations, recipe);
    }

    public Scene withMaterials(Map<String, Material> value) {
        Checked.Materials fresh = value instanceof Checked.Materials known ? known : new Checked.Materials(value);
        List<SceneObject> known = SceneRules.allow(materials, fresh) ? pieces().checkedWith(fresh) : objects;
        return new Scene(name, description, tags, settings, background, sky, ambient, cameras, lights, fresh, known, animations, recipe);
    }

    /** Only those are checked that are not the very same as before in their places. */
    public Scene withObjects(List<SceneObject> value) {
        return withPieces(pieces().like(value));
    }

    /** With other objects at some indexes. */
    Scene withObjects(Map<Integer, SceneObject> changes) {
        return withPieces(pieces().with(changes));
    }

    private Scene withPieces(Pieces<SceneObject> fresh) {
        if (!fresh.isCheckedWith(materials)) {
            SceneRules.checkChanged(objects, fresh, Difference.of(pieces(), fresh), materials, SceneRules.REFUSE);
        }
        return new Scene(name, description, tags, settings, background, sky, ambient, cameras, lights, materials, fresh.checkedWith(materials), animations, recipe);
    }

    private Pieces<SceneObject> pieces() {
        return (Pieces<SceneObject>) objects;
    }

    /**
     * The indexes of the objects that are not the very same as at that index of another scene, rising. Where one scene was made from the other by
     * changing a few of very many, that takes hardly any time.
     */
    public int[] objectsOtherThanIn(Scene other) {
        return pieces().otherThanIn(other.pieces());
    }

    /**
     * With a change of what stands at some places; this very scene if nothing is different afterwards. Of two that are within each other,
     * the inner is changed first. What does not change stays the very same object; places that lead nowhere are passed over.
     *
     * @throws IllegalArgumentException if the change makes a scene that cannot be
     */
    public Scene with(Collection<ScenePath.BodyAt> places, BiFunction<ScenePath.BodyAt, Body, Body> change) {
        Objects.requireNonNull(change, "change");
        return Bodies.of(this, places, change);
    }

    /** As {@link #with(Collection, BiFunction)}, at one place. */
    public Scene with(ScenePath.BodyAt place, UnaryOperator<Body> change) {
        Objects.requireNonNull(change, "change");
        return with(List.of(place), (at, body) -> change.apply(body));
    }

    /** Without the bodies and operands that are hidden; this very scene if none is. Places in it may be others. */
    public Scene shown() {
        return Bodies.shown(this);
    }

    /** With one more light. */
    public Scene plus(Light light) {
        Objects.requireNonNull(light, "light");
        List<Light> all = new ArrayList<>(lights);
        all.add(light);
        return withLights(all);
    }

    /** With these objects added; for many, pass them in one call. */
    public Scene plus(SceneObject... more) {
        return withPieces(pieces().plus(List.of(more)));
    }

    /** With a named material added, or replaced. */
    public Scene plus(String materialName, Material material) {
        Objects.requireNonNull(materialName, "materialName");
        Objects.requireNonNull(material, "material");
        Map<String, Material> all = new LinkedHashMap<>(materials);
        all.put(materialName, material);
        return withMaterials(all);
    }

    /** What a ray sees that hits nothing, by its direction; whoever has none has a background. */
    @Element("What a ray sees that hits nothing, by its direction, in place of a background: three colours, or a picture.")
    public sealed interface Sky permits Sky.None, Sky.Gradient, Sky.Picture {
        /** No sky: the background is seen. */
        Sky NONE = new None();

        /** No sky: the background is seen. */
        record None() implements Sky {}

        /** From the horizon to the zenith, and down to the ground, mixed in linear light by the height y of the direction, of length 1. */
        record Gradient(
                @Attribute(value = Kind.COLOR, means = "Colour straight above", otherwise = "64 112 190") Rgb zenith,
                @Attribute(value = Kind.COLOR, means = "Colour all around", otherwise = "206 220 236") Rgb horizon,
                @Attribute(value = Kind.COLOR, means = "Colour straight below", otherwise = "112 104 96") Rgb ground) implements Sky {
            public static final Gradient DEFAULT = new Gradient(new Rgb(64, 112, 190), new Rgb(206, 220, 236), new Rgb(112, 104, 96));

            public Gradient {
                Objects.requireNonNull(zenith, "zenith");
                Objects.requireNonNull(horizon, "horizon");
                Objects.requireNonNull(ground, "ground");
            }
        }

        /**
         * A picture of everything around, 360° × 180°, in which the direction (x, y, z) is at u = atan2(z, x)/2π, v = ½ + asin(y)/π.
         *
         * @param file its name, relative to the scene's folder
         * @param rotation degrees about y, counter-clockwise seen from above
         * @param intensity what its light is multiplied by
         */
        record Picture(
                @Attribute(value = Kind.FILE, means = "A picture of everything around, 360 x 180 degrees, beside the scene's file") String file,
                @Attribute(value = Kind.NUMBER, means = "Degrees that it is turned about y", otherwise = "0") double rotation,
                @Attribute(value = Kind.INTENSITY, means = "What its light is multiplied by", otherwise = "1") double intensity) implements Sky {
            public Picture {
                Require.that(!file.isBlank(), "sky file must not be blank");
                Require.finite("sky rotation", rotation);
                Require.within("sky intensity", intensity, 0, 1e12);
            }
        }
    }

    /**
     * How a scene is made, where its file does not only say what there is: parameters, formulas, what is repeated, defined and included. All else in the scene is
     * what came of that. It is kept when the scene is changed; what has been changed by hand wins over it when the scene is written.
     *
     * @param text the scene as a file has it, with its formulas; empty if it has none
     * @param included the texts of the files that it includes, by their names
     * @param parameters all there are, its own first
     */
    public record Recipe(String text, Map<String, String> included, List<Parameter> parameters) {
        /** Of a scene that is as it is written. */
        public static final Recipe NONE = new Recipe("", Map.of(), List.of());

        public Recipe {
            Objects.requireNonNull(text, "text");
            included = Map.copyOf(included);
            parameters = List.copyOf(parameters);
        }

        /** Whether the scene is as it is written, without formulas. */
        public boolean isNone() {
            return text.isEmpty();
        }

        /**
         * A number, or a text such as the name of a colour, that formulas may refer to.
         *
         * @param name of letters, digits and _
         * @param formula what its value is made of, as written
         * @param value what that comes to
         * @param least the least that it may be; none for a text, or any
         * @param most the most that it may be
         * @param step by how much one changes it by hand
         */
        public record Parameter(String name, String formula, String value, OptionalDouble least, OptionalDouble most, OptionalDouble step) {
            public Parameter {
                Objects.requireNonNull(name, "name");
                Objects.requireNonNull(formula, "formula");
                Objects.requireNonNull(value, "value");
                Objects.requireNonNull(least, "least");
                Objects.requireNonNull(most, "most");
                Objects.requireNonNull(step, "step");
            }

            /** The value as a number; empty if it is a text. */
            public OptionalDouble number() {
                return Numbers.parsed(value);
            }
        }
    }
}
