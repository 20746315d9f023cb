package cz.paprsek.xml.write;

import cz.paprsek.attribute.Described;
import cz.paprsek.attribute.Kind;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Require;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneDatabase;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SceneRules;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.xml.format.SceneFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Writes scenes in a fixed order and form: one element a line, attributes equal to their default left out. */
public final class SceneWriter {
    private final XmlText xml = new XmlText();

    public String file(Scene scene) {
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

    /** A scene without lights, materials and objects. */
    static String head(Scene scene, boolean isRoot) {
        SceneWriter writer = new SceneWriter();
        writer.scene(scene.withLights(List.of()).withObjects(List.of()).withMaterials(Map.of()), isRoot);
        return writer.xml.toString();
    }

    static String text(Light light) {
        SceneWriter writer = new SceneWriter();
        writer.lamp(light);
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

    private void scene(Scene scene, boolean isRoot) {
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
        xml.open("scene").attribute("xmlns", isRoot ? SceneFormat.NAMESPACE : "").attribute("name", scene.name())
                .attribute("tags", String.join(" ", scene.tags()));
        if (!scene.description().isEmpty()) {
            xml.element("description", scene.description());
        }
        settings(scene.settings());
        light("background", scene.background());
        light("ambient", scene.ambient());
        camera(scene.camera());
        scene.lights().forEach(this::lamp);
        scene.materials().forEach(this::material);
        scene.objects().forEach(this::object);
        xml.close("scene");
    }

    private void settings(RenderSettings settings) {
        if (!settings.equals(RenderSettings.DEFAULT)) {
            xml.open("render");
            attributes(settings).close("render");
        }
    }

    /** What a record has other than by default, in the order of its components. */
    private XmlText attributes(Record record) {
        for (Described one : Described.of(record.getClass())) {
            String text = text(one, one.value(record));
            if (one.isRequired() || !text.equals(one.says().otherwise())) {
                xml.attribute(one.name(), text);
            }
        }
        return xml;
    }

    private static String text(Described one, Object value) {
        if (one.says().value() == Kind.SCALE && value instanceof Vec3 scale && scale.x() == scale.y() && scale.x() == scale.z()) {
            return XmlText.text(scale.x());
        }
        return value instanceof Number number ? XmlText.text(number.doubleValue()) : value instanceof Rgb color ? text(color) : XmlText.text((Vec3) value);
    }

    private void light(String element, Rgb color) {
        if (!color.equals(Rgb.BLACK)) {
            xml.open(element).attribute("color", text(color)).close(element);
        }
    }

    private void camera(Camera camera) {
        xml.open("camera").attribute("position", XmlText.text(camera.position()));
        if (camera.aim() instanceof Camera.Target target) {
            xml.attribute("target", XmlText.text(target.point()));
        } else {
            xml.attribute("direction", XmlText.text(((Camera.Direction) camera.aim()).vector()));
        }
        xml.vector("up", camera.up(), Vec3.Y).number("fovy", camera.fovy(), Camera.DEFAULT.fovy()).close("camera");
    }

    private void lamp(Light light) {
        xml.open("point-light").attribute("name", light.name());
        attributes(light).close("point-light");
    }

    private void material(String name, Material material) {
        xml.open("material").attribute("name", name);
        if (material.pattern() instanceof Pattern.Plain plain && !plain.equals(Material.DEFAULT.pattern())) {
            xml.attribute("color", text(plain.color()));
        }
        attributes(material);
        if (!(material.pattern() instanceof Pattern.Plain)) {
            String element = material.pattern().getClass().getSimpleName().toLowerCase(Locale.ROOT);
            xml.open(element);
            attributes((Record) material.pattern()).close(element);
        }
        xml.close("material");
    }

    private void object(SceneObject object) {
        body(object.name(), object.shape(), object.placement(), object.material());
    }

    private void operand(Operand operand) {
        body(operand.name(), operand.solid(), operand.placement(), operand.material());
    }

    private void body(String name, Shape shape, Placement placement, MaterialSource material) {
        String element = shape.kind();
        xml.open(element).attribute("name", name);
        measures(shape);
        attributes(placement);
        if (material instanceof MaterialName reference) {
            xml.attribute("material", reference.name());
        } else if (material instanceof Material own) {
            material("", own);
        }
        if (shape instanceof Csg csg) {
            csg.operands().forEach(this::operand);
        }
        xml.close(element);
    }

    private void measures(Shape shape) {
        if (shape instanceof Rectangle rectangle) {
            xml.attribute("min", XmlText.text(rectangle.minX()) + " " + XmlText.text(rectangle.minY()))
                    .attribute("max", XmlText.text(rectangle.maxX()) + " " + XmlText.text(rectangle.maxY()));
        } else {
            attributes((Record) shape);
        }
    }

    private static String text(Rgb color) {
        return XmlText.text(color.red()) + " " + XmlText.text(color.green()) + " " + XmlText.text(color.blue());
    }
}
