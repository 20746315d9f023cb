package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;
import static cz.paprsek.text.Numbers.text;

import cz.paprsek.image.ImageFormat;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Pattern.Filter;
import cz.paprsek.material.Pattern.Lay;
import cz.paprsek.math.Require;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.shape.height.HeightField;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Pictures in POV-Ray's words. It looks for them beside its own file. */
final class PovPictures {
    private static final Map<ImageFormat, String> WORDS = Map.of(ImageFormat.PNG, "png", ImageFormat.JPG, "jpeg", ImageFormat.HDR, "hdr", ImageFormat.EXR, "exr",
            ImageFormat.TIF, "tiff", ImageFormat.BMP, "bmp", ImageFormat.PPM, "ppm", ImageFormat.PGM, "pgm");
    /** Its globes and labels are seen from within, and begin elsewhere. */
    private static final String TURNED = " scale <-1, 1, 1> rotate <0, -90, 0>";

    private PovPictures() {}

    /** What stands in a pigment. */
    static String pigment(Pattern.Picture picture, Shape shape, double transmit) {
        boolean isByShape = picture.mapping() == Pattern.Mapping.UV;
        int type = switch (picture.mapping()) {
            case UV -> shape instanceof Sphere ? 1 : 0;
            case PLANAR, BOX -> 0;
            case SPHERICAL -> 1;
            case CYLINDER -> 2;
        };
        String map = map(picture.file(), type, picture.filter() != Filter.NEAREST, transmit) + (type == 0 ? "" : TURNED);
        return (isByShape && hasMap(shape) ? "uv_mapping " : "") + map + PovPatterns.laid(picture.lay()) + (isByShape ? stretched(shape) : "");
    }

    /** Whether POV-Ray is told where in a picture each corner lies. */
    private static boolean hasMap(Shape shape) {
        return shape instanceof Mesh mesh && mesh.isRead() && mesh.triangles().hasMap();
    }

    /** From the square between 0 and 1 to where a flat shape has it. */
    private static String stretched(Shape shape) {
        if (shape instanceof Rectangle area) {
            return " scale " + vector(area.maxX() - area.minX(), area.maxY() - area.minY(), 1) + " translate " + vector(area.minX(), area.minY(), 0);
        } else if (shape instanceof Disc disc) {
            return " scale " + vector(2 * disc.radius(), 2 * disc.radius(), 1) + " translate " + vector(-disc.radius(), -disc.radius(), 0);
        }
        return shape instanceof Plane ? " rotate <-90, 0, 0>" : "";
    }

    /** What stands in a scene. */
    static String sky(Sky.Picture sky) {
        return "sky_sphere { pigment { " + map(sky.file(), 1, true, 0) + (sky.rotation() == 0 ? "" : " rotate " + vector(0, sky.rotation(), 0)) + " }"
                + (sky.intensity() == 1 ? "" : " emission rgb " + text(sky.intensity())) + " }";
    }

    private static String map(String file, int type, boolean isMixed, double transmit) {
        Optional<ImageFormat> format = ImageFormat.ofFile(file);
        boolean isLight = format.filter(some -> some == ImageFormat.HDR || some == ImageFormat.EXR).isPresent();
        return "image_map { " + named(file)
                + (isLight ? "" : " gamma srgb") + " map_type " + type + (isMixed ? " interpolate 2" : "") + (transmit > 0 ? " transmit all " + text(transmit) : "") + " }";
    }

    /** A file and its kind. */
    private static String named(String file) {
        return ImageFormat.ofFile(file).map(some -> WORDS.getOrDefault(some, "")).orElse("") + " \"" + PovFiles.nameOf(file).replace("\\", "\\\\").replace("\"", "\\\"") + "\"";
    }

    /**
     * A height field, which POV-Ray has no walls and no bottom for: those are of a box that it is intersected with, a little smaller, for it holds nothing
     * at its rim.
     */
    static String heights(HeightField field) {
        Require.that(!field.file().isEmpty(), "a scene for POV-Ray cannot hold heights that were made in code");
        double inner = 1 - 1e-6;
        return "intersection { height_field { " + named(field.file()) + (field.smooth() ? " smooth" : "") + " translate <-0.5, 0, -0.5> scale "
                + vector(field.extent().x(), field.extent().y(), -field.extent().z()) + " } box { "
                + vector(-field.extent().x() / 2 * inner, field.extent().y() * 1e-9, -field.extent().z() / 2 * inner) + ", "
                + vector(field.extent().x() / 2 * inner, field.extent().y() * 2, field.extent().z() / 2 * inner) + " }";
    }

    /** What POV-Ray will show otherwise of a height field, in words that follow the name of the object. */
    static List<String> lost(HeightField field) {
        List<String> lost = new ArrayList<>();
        if (ImageFormat.ofFile(field.file()).map(WORDS::get).isEmpty()) {
            lost.add("POV-Ray cannot be told what kind of picture " + field.file() + " is");
        }
        if (field.smooth()) {
            lost.add("POV-Ray rounds the light on heights in its own way");
        }
        return lost;
    }

    /** What POV-Ray will show otherwise, in words that follow the name of the object. */
    static List<String> lost(Pattern.Picture picture, Shape shape) {
        List<String> lost = new ArrayList<>();
        boolean isKnown = shape instanceof Rectangle || shape instanceof Disc || shape instanceof Plane || hasMap(shape);
        if (picture.filter() == Filter.SMOOTH) {
            lost.add("POV-Ray mixes the four nearest points of " + picture.file() + ", whatever a pixel covers");
        }
        if (picture.mapping() == Pattern.Mapping.BOX
                || (picture.mapping() == Pattern.Mapping.UV && !isKnown && !(shape instanceof Sphere && picture.lay().equals(Lay.NONE)))) {
            lost.add("POV-Ray does not know how " + picture.file() + " lies on it, and is told that it lies on a plane");
        }
        if (ImageFormat.ofFile(picture.file()).map(WORDS::get).isEmpty()) {
            lost.add("POV-Ray cannot be told what kind of picture " + picture.file() + " is");
        }
        return lost;
    }
}
