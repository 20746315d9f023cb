package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Mesh;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.text.Numbers;
import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Writes one scene from top to bottom. Colours are linear; named materials become declarations. */
final class PovWriter {
    private final Scene scene;
    private final PovText text;
    /** The identifiers of the named materials. */
    private final Map<String, String> identifiers = new HashMap<>();

    PovWriter(Scene scene, Appendable out) {
        this.scene = scene;
        this.text = new PovText(out);
    }

    void write() throws IOException {
        head();
        camera();
        for (int i = 0; i < scene.lights().size(); i++) {
            Light light = scene.lights().get(i);
            text.comment(light.name());
            for (String line : PovLights.of(scene, light, i)) {
                text.line(line);
            }
        }
        if (PovWarnings.materials(scene).stream().anyMatch(material -> material.patterns().anyMatch(PovPatterns::isNoise))) {
            for (String line : PovPatterns.NOISE) {
                text.line(line);
            }
        }
        for (Map.Entry<String, Material> named : scene.materials().entrySet()) {
            declare(named.getKey(), named.getValue());
        }
        for (SceneObject object : scene.objects()) {
            text.comment(object.name());
            MaterialSource material = object.material() == Inherited.INHERITED ? Material.DEFAULT : object.material();
            solid(object.shape(), object.material(), List.of(texture(material, object.shape()), PovMaterials.interior(scene, object), placement(object.placement())));
        }
    }

    private void head() throws IOException {
        RenderSettings settings = scene.settings();
        text.comment(scene.name());
        text.comment("povray +Iscene.pov +W" + settings.width() + " +H" + settings.height() + " -A +FN16 File_Gamma=1.0 +Oscene.png"
                + " writes 16-bit linear light, one ray a pixel.");
        text.line("#version 3.7;");
        text.line("global_settings { assumed_gamma 1 max_trace_level " + settings.maxDepth() + " adc_bailout 0 ambient_light "
                + PovMaterials.rgb(scene.ambient(), 1) + " }");
        if (scene.sky() instanceof Sky.Gradient sky) {
            text.line("sky_sphere { pigment { function { 0.5 + 0.5*y } color_map { [0 " + PovMaterials.rgb(sky.ground(), 1) + "] [0.5 "
                    + PovMaterials.rgb(sky.horizon(), 1) + "] [1 " + PovMaterials.rgb(sky.zenith(), 1) + "] } } }");
        } else if (scene.sky() instanceof Sky.Picture sky) {
            text.line(PovPictures.sky(sky));
        } else {
            text.line("background { " + PovMaterials.rgb(scene.background(), 1) + " }");
        }
    }

    private void camera() throws IOException {
        text.line("camera { " + PovCamera.of(scene.camera()) + " }");
    }

    private void declare(String name, Material material) throws IOException {
        if (PovMaterials.isMapped(material)) {
            // How large they are depends on the figure they lie on.
            return;
        }
        String identifier = "Material_" + (identifiers.size() + 1) + name.codePoints()
                .filter(c -> c < 128 && Character.isLetterOrDigit(c)).limit(40)
                .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append).insert(0, '_');
        identifiers.put(name, identifier);
        text.line("#declare " + identifier + " = " + PovMaterials.texture(material, new Sphere(1)));
    }

    /** @return an empty text for a material taken from above */
    private String texture(MaterialSource source, Shape shape) {
        if (source == Inherited.INHERITED) {
            return "";
        }
        if (source instanceof MaterialName reference) {
            String identifier = identifiers.get(reference.name());
            return identifier == null
                    ? PovMaterials.texture(reference.in(scene.materials()), shape)
                    : "texture { " + identifier + " }";
        }
        return PovMaterials.texture((Material) source, shape);
    }

    /** Writes a shape and what modifies it, first things first: a texture is carried along by the placements after it. What parts of meshes are made of counts where nothing is given. */
    private void solid(Shape shape, MaterialSource given, List<String> modifiers) throws IOException {
        if (given == Inherited.INHERITED && shape instanceof Mesh mesh && (!mesh.materials().isEmpty() || mesh.triangles().hasColors())) {
            text.line(PovMesh.ofFile(mesh, material -> PovMaterials.texture(material, mesh)) + " " + PovText.joined(modifiers.subList(1, modifiers.size())) + " }");
            return;
        }
        if (!(shape instanceof Csg csg)) {
            text.line(PovShapes.primitive(shape, PovText.joined(modifiers)));
            return;
        }
        text.open(PovShapes.keyword(csg));
        for (Operand operand : csg.operands()) {
            text.comment(operand.name());
            solid(operand.solid(), operand.material() == Inherited.INHERITED ? given : operand.material(),
                    List.of(texture(operand.material(), operand.solid()), placement(operand.placement())));
        }
        // A texture here would be laid over one that a single operand brings along.
        text.close(PovText.joined(bringsTexture(csg) ? modifiers.subList(1, modifiers.size()) : modifiers));
    }

    private static boolean bringsTexture(Shape shape) {
        return shape instanceof Csg csg && csg.operands().size() == 1
                && (csg.operands().get(0).material() != Inherited.INHERITED || bringsTexture(csg.operands().get(0).solid()));
    }

    /** POV-Ray's turns are counter-clockwise for us: its hand and its z axis are both the other way round. */
    private static String placement(Placement placement) {
        Vec3 scale = placement.scale();
        return PovText.joined(List.of(
                scale.equals(Vec3.ONE) ? "" : "scale " + (scale.x() == scale.y() && scale.x() == scale.z() ? Numbers.text(scale.x()) : vector(scale)),
                placement.rotation().equals(Vec3.ZERO) ? "" : "rotate " + vector(placement.rotation()),
                placement.position().equals(Vec3.ZERO) ? "" : "translate " + vector(placement.position())));
    }
}
