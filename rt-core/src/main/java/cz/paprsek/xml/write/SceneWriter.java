package cz.paprsek.xml.write;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.ElementTable;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.CustomPattern;
import cz.paprsek.material.Material;
import cz.paprsek.material.Material.Bump;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.material.Share.ByPattern;
import cz.paprsek.material.Share.Even;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.CustomLight;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SceneRules;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.CustomShape;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.height.HeightField;
import cz.paprsek.text.MadeInCode;
import cz.paprsek.xml.format.SceneFormat;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/** Writes scenes in a fixed order and form: one element a line, attributes equal to their default left out. */
public final class SceneWriter {
    private static final String HERE = "a scene file";

    private final XmlText xml = new XmlText();
    /** The last material without a name, in how many elements it was, and where its text begins and ends. */
    private Material last = Material.DEFAULT;
    private int lastLevel = -1;
    private int lastStart;
    private int lastEnd;
    private final IdentityHashMap<Described, Latest> latest = new IdentityHashMap<>();

    /** What is known of an attribute, and its value that was written last, or left out: most are as those of the neighbour, and numbers take long to become texts. */
    private static final class Latest {
        private final Kind kind;
        private final Kind.Form form;
        private final boolean isOptional;
        private final String otherwise;
        private @Nullable Object value;
        private String text = "";

        Latest(Described of) {
            kind = of.says().value();
            form = kind.form();
            isOptional = of.isOptional();
            otherwise = of.says().otherwise();
        }

        String text(Object now) {
            if (!now.equals(value)) {
                value = now;
                text = SceneWriter.text(form, now);
            }
            return text;
        }

        /** What is read if nothing is written. */
        String standard(Record record) {
            return record instanceof RenderSettings settings && kind == Kind.SAMPLES ? String.valueOf(settings.integrator().usualSamples()) : otherwise;
        }
    }

    /** Of a scene with a recipe, that recipe. */
    public String file(Scene scene) {
        if (!scene.recipe().isNone()) {
            return scene.recipe().text();
        }
        scene(scene, true);
        return xml.toString();
    }

    public String database(List<Scene> scenes) {
        SceneDatabase.of(scenes);
        xml.open("database").attribute("xmlns", SceneFormat.NAMESPACE);
        scenes.forEach(scene -> scene(scene, false));
        xml.close("database");
        return xml.toString();
    }

    /** A scene without lights, materials, objects and animations. */
    static String head(Scene scene, boolean isRoot) {
        SceneWriter writer = new SceneWriter();
        writer.scene(scene.withAnimations(List.of()).withLights(List.of()).withObjects(List.of()).withMaterials(Map.of()), isRoot);
        return writer.xml.toString();
    }

    static String text(Light light) {
        SceneWriter writer = new SceneWriter();
        writer.light(light);
        return writer.xml.toString();
    }

    static String text(String name, Material material) {
        SceneWriter writer = new SceneWriter();
        writer.material(name, material);
        return writer.xml.toString();
    }

    static String text(SceneObject object) {
        SceneWriter writer = new SceneWriter();
        writer.object(object);
        return writer.xml.toString();
    }

    static String text(Animation animation) {
        SceneWriter writer = new SceneWriter();
        writer.animation(animation);
        return writer.xml.toString();
    }

    private void scene(Scene scene, boolean isRoot) {
        if (!scene.recipe().isNone()) {
            xml.piece(scene.recipe().text());
            return;
        }
        // What the file could hold but would not be read.
        if (!scene.name().isEmpty()) {
            SceneRules.checkName("scene name", scene.name());
        }
        for (String tag : scene.tags()) {
            SceneRules.checkName("scene tag", tag);
            Require.that(tag.chars().noneMatch(Character::isWhitespace), "a scene's tag must be one word, but is \"" + tag + "\"");
        }
        Require.that(scene.description().length() <= SceneFormat.LONGEST_DESCRIPTION,
                "a scene's description must not be longer than " + SceneFormat.LONGEST_DESCRIPTION + " characters");
        xml.open("scene").attribute("xmlns", isRoot ? SceneFormat.NAMESPACE : "");
        attributes(scene);
        if (!scene.description().isEmpty()) {
            xml.element("description", scene.description());
        }
        if (!scene.settings().equals(RenderSettings.DEFAULT)) {
            leaf(scene.settings());
        }
        light("background", scene.background());
        if (!scene.sky().equals(Sky.NONE)) {
            xml.open("sky");
            attributes((Record) scene.sky()).close("sky");
        }
        light("ambient", scene.ambient());
        scene.cameras().forEach(this::leaf);
        scene.lights().forEach(this::light);
        scene.materials().forEach(this::material);
        scene.objects().forEach(this::object);
        scene.animations().forEach(this::animation);
        xml.close("scene");
    }

    private void animation(Animation animation) {
        String element = ElementTable.name(Animation.class);
        xml.open(element);
        attributes(animation);
        animation.keys().forEach(this::leaf);
        xml.close(element);
    }

    /** An element with the attributes of a record, those that are not as by default. */
    private void leaf(Record record) {
        String element = ElementTable.name(record.getClass());
        xml.open(element);
        attributes(record).close(element);
    }

    /** In the order of the components. */
    private XmlText attributes(Record record) {
        return attributes(record, one -> true);
    }

    private XmlText attributes(Record record, Predicate<Described> which) {
        for (Described one : Described.inline(record.getClass())) {
            if (one.isOf(record) && which.test(one)) {
                Latest last = latest.computeIfAbsent(one, Latest::new);
                String text = last.text(one.value(record));
                if (last.isOptional || !text.equals(last.standard(record))) {
                    xml.attribute(one.name(), text, last.form != Kind.Form.TEXT && last.form != Kind.Form.WORDS);
                }
            }
        }
        return xml;
    }

    /** Empty for what is not there. */
    static String text(Described one, Object value) {
        return text(one.says().value().form(), value);
    }

    private static String text(Kind.Form form, Object value) {
        return switch (form) {
            case NUMBER, WHOLE -> value instanceof OptionalDouble optional ? optional.isPresent() ? XmlText.text(optional.getAsDouble()) : ""
                    : XmlText.text(((Number) value).doubleValue());
            case VECTOR -> XmlText.text((Vec3) value);
            case SCALE -> value instanceof Vec3 scale && scale.x() == scale.y() && scale.x() == scale.z() ? XmlText.text(scale.x()) : XmlText.text((Vec3) value);
            case PAIR -> XmlText.text(((double[]) value)[0]) + " " + XmlText.text(((double[]) value)[1]);
            case FROM_TO -> fromTo((double[]) value);
            case COLOR -> text((Rgb) value);
            case TEXT, FLAG -> value.toString();
            case WORDS -> ((List<?>) value).stream().map(String::valueOf).collect(Collectors.joining(" "));
            case WORD -> Described.word(value);
        };
    }

    private static String fromTo(double[] numbers) {
        return XmlText.text(numbers[0]) + (numbers[1] == 0 ? "" : ".." + XmlText.text(numbers[1]));
    }

    private void light(Light light) {
        if (light instanceof CustomLight) {
            throw MadeInCode.refusedBy(HERE, light.kind(), "light");
        }
        leaf((Record) light);
    }

    private void light(String element, Rgb color) {
        if (!color.equals(Rgb.BLACK)) {
            xml.open(element).attribute("color", text(color)).close(element);
        }
    }

    private void material(String name, Material material) {
        String element = ElementTable.name(Material.class);
        xml.open(element).attribute("name", name);
        Set<String> byPattern = varied(material);
        attributes(material, one -> !byPattern.contains(one.name()));
        ElementTable.of(material.pattern().getClass()).forEach(pattern -> pattern(material.pattern()));
        if (material.pattern() instanceof CustomPattern) {
            pattern(material.pattern());
        }
        if (!material.shares().isEven()) {
            Described.values(material.shares()).forEach((share, value) -> around(share, value));
        }
        ElementTable.of(material.relief().getClass()).forEach(kind -> around(ElementTable.name(kind), material.relief()));
        xml.close(element);
    }

    /** The shares that a pattern says: no attributes. */
    private static Set<String> varied(Material material) {
        return material.shares().isEven() ? Set.of() : Described.values(material.shares()).entrySet().stream().filter(share -> share.getValue() instanceof ByPattern).map(Map.Entry::getKey).collect(Collectors.toSet());
    }

    /** An element with a pattern inside, if there is one. */
    private void around(String element, Object value) {
        if (value instanceof Even) {
            return;
        }
        xml.open(element);
        attributes((Record) value, one -> one.within().isEmpty() || !(one.within().get(0).getType() == Pattern.class));
        if (value instanceof ByPattern by) {
            pattern(by.pattern());
        } else if (value instanceof Bump bump) {
            pattern(bump.pattern());
        }
        xml.close(element);
    }

    private void pattern(Pattern pattern) {
        if (pattern instanceof CustomPattern) {
            throw MadeInCode.refusedBy(HERE, pattern.kind(), "pattern");
        }
        String element = ElementTable.name(pattern.getClass());
        xml.open(element);
        attributes((Record) pattern);
        if (pattern.colors() instanceof Pattern.Stops stops) {
            stops.stops().forEach(this::leaf);
        }
        xml.close(element);
    }

    private void object(SceneObject object) {
        body(Body.of(object));
    }

    private void operand(Operand operand) {
        body(Body.of(operand));
    }

    private void body(Body body) {
        Shape shape = body.shape();
        MaterialSource material = body.material();
        if (shape instanceof CustomShape || (shape instanceof Mesh mesh && mesh.file().isEmpty()) || (shape instanceof HeightField field && field.file().isEmpty())) {
            throw MadeInCode.refusedBy(HERE, shape.kind(), "shape");
        }
        String element = shape.kind();
        xml.open(element).attribute("name", body.name());
        attributes((Record) shape);
        attributes(body.placement());
        attributes((Record) body.pivot());
        if (body.hidden()) {
            xml.attribute("hidden", "true");
        }
        if (material instanceof MaterialName reference) {
            xml.attribute("material", reference.name());
        } else if (material instanceof Material own) {
            own(own);
        }
        if (shape instanceof Csg csg) {
            csg.operands().forEach(this::operand);
        }
        xml.close(element);
    }

    /** A material without a name. Of neighbours that have the same one, the text is. */
    private void own(Material material) {
        if (xml.level() == lastLevel && material.pattern().equals(last.pattern()) && material.equals(last)) {
            xml.again(lastStart, lastEnd);
            return;
        }
        int start = xml.end();
        material("", material);
        last = material;
        lastLevel = xml.level();
        lastStart = start;
        lastEnd = xml.end();
    }

    private static String text(Rgb color) {
        return XmlText.text(color.red()) + " " + XmlText.text(color.green()) + " " + XmlText.text(color.blue());
    }
}
