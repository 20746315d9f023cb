package cz.paprsek.xml;

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
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Cone;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Ellipsoid;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.Torus;
import java.util.List;
import java.util.Map;

/** Writes scenes in a fixed order and form: one element a line, attributes equal to their default left out. */
final class SceneWriter {
    /** As in the schema. */
    static final int LONGEST_DESCRIPTION = 100_000;

    private final XmlText xml = new XmlText();

    String file(Scene scene) {
        scene(scene, true);
        return xml.toString();
    }

    String database(List<Scene> scenes) {
        SceneDatabase.of(scenes);
        xml.open("database").attribute("xmlns", SceneFiles.NAMESPACE);
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
        Require.that(scene.description().length() <= LONGEST_DESCRIPTION,
                "a scene's description must not be longer than " + LONGEST_DESCRIPTION + " characters");
        xml.open("scene").attribute("xmlns", isRoot ? SceneFiles.NAMESPACE : "").attribute("name", scene.name())
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
            RenderSettings standard = RenderSettings.DEFAULT;
            xml.open("render")
                    .number("width", settings.width(), standard.width())
                    .number("height", settings.height(), standard.height())
                    .number("max-depth", settings.maxDepth(), standard.maxDepth())
                    .number("samples", settings.samples(), standard.samples())
                    .close("render");
        }
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
        xml.open("point-light").attribute("name", light.name()).attribute("position", XmlText.text(light.position()));
        if (!light.color().equals(Rgb.WHITE)) {
            xml.attribute("color", text(light.color()));
        }
        xml.number("intensity", light.intensity(), 1).close("point-light");
    }

    private void material(String name, Material material) {
        Material standard = Material.DEFAULT;
        xml.open("material").attribute("name", name);
        if (material.pattern() instanceof Pattern.Plain plain && !plain.equals(standard.pattern())) {
            xml.attribute("color", text(plain.color()));
        }
        xml.number("diffusion", material.diffusion(), standard.diffusion())
                .number("specular", material.specular(), standard.specular())
                .number("shininess", material.shininess(), standard.shininess())
                .number("reflection", material.reflection(), standard.reflection())
                .number("transparency", material.transparency(), standard.transparency())
                .number("refractive-index", material.refractiveIndex(), standard.refractiveIndex());
        if (material.pattern() instanceof Pattern.Checkerboard board) {
            xml.open("checkerboard").number("columns", board.columns()).number("rows", board.rows());
            colors(board.even(), board.odd()).close("checkerboard");
        } else if (material.pattern() instanceof Pattern.Checker checker) {
            xml.open("checker").number("size", checker.size()).vector("origin", checker.origin(), Vec3.ZERO);
            colors(checker.even(), checker.odd()).close("checker");
        }
        xml.close("material");
    }

    private XmlText colors(Rgb even, Rgb odd) {
        if (!even.equals(Rgb.WHITE)) {
            xml.attribute("even", text(even));
        }
        return odd.equals(Rgb.BLACK) ? xml : xml.attribute("odd", text(odd));
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
        xml.vector("position", placement.position(), Vec3.ZERO).vector("rotation", placement.rotation(), Vec3.ZERO);
        Vec3 scale = placement.scale();
        if (!scale.equals(Vec3.ONE)) {
            boolean uniform = scale.x() == scale.y() && scale.x() == scale.z();
            xml.attribute("scale", uniform ? XmlText.text(scale.x()) : XmlText.text(scale));
        }
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
        if (shape instanceof Sphere sphere) {
            xml.number("radius", sphere.radius());
        } else if (shape instanceof Block block) {
            xml.attribute("min", XmlText.text(block.min())).attribute("max", XmlText.text(block.max()));
        } else if (shape instanceof Ellipsoid ellipsoid) {
            xml.attribute("semi-axes", XmlText.text(ellipsoid.semiAxes()));
        } else if (shape instanceof Rectangle rectangle) {
            xml.attribute("min", XmlText.text(rectangle.minX()) + " " + XmlText.text(rectangle.minY()))
                    .attribute("max", XmlText.text(rectangle.maxX()) + " " + XmlText.text(rectangle.maxY()));
        } else if (shape instanceof Disc disc) {
            xml.number("radius", disc.radius());
        } else if (shape instanceof Cylinder cylinder) {
            xml.number("radius", cylinder.radius()).number("height", cylinder.height());
        } else if (shape instanceof Cone cone) {
            xml.number("radius", cone.radius()).number("top-radius", cone.topRadius(), 0).number("height", cone.height());
        } else if (shape instanceof Torus torus) {
            xml.number("major-radius", torus.majorRadius()).number("minor-radius", torus.minorRadius());
        } else if (!(shape instanceof Plane || shape instanceof Csg)) {
            throw new IllegalStateException("a shape that cannot be written: " + shape);
        }
    }

    private static String text(Rgb color) {
        return XmlText.text(color.red()) + " " + XmlText.text(color.green()) + " " + XmlText.text(color.blue());
    }
}
