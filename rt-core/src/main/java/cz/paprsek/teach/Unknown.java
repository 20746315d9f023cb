package cz.paprsek.teach;

import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.material.MaterialSource.Inherited;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.RenderSettings.PixelFilter;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.Scene.Sky;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Cylinder;
import cz.paprsek.shape.Disc;
import cz.paprsek.shape.Ellipsoid;
import cz.paprsek.shape.Plane;
import cz.paprsek.shape.Rectangle;
import cz.paprsek.shape.Shape;
import cz.paprsek.shape.Sphere;
import cz.paprsek.teach.mistake.Mistakes;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Says what of a scene the plain tracer does not know. */
final class Unknown {
    /** Every ray asks every body. */
    private static final int MOST_BODIES = 1000;
    private static final Set<Class<?>> SHAPES = Set.of(Sphere.class, Ellipsoid.class, Block.class, Cylinder.class, Plane.class, Rectangle.class, Disc.class);
    private static final Set<Class<?>> PATTERNS = Set.of(Pattern.Plain.class, Pattern.Checkerboard.class, Pattern.Checker.class);

    private final Scene scene;
    private final Set<String> found = new LinkedHashSet<>();
    private int bodies;

    private Unknown(Scene scene) {
        this.scene = scene;
    }

    /** In the words of scene files; empty if it knows all. */
    static List<String> in(Scene scene, RenderSettings settings) {
        Unknown unknown = new Unknown(scene);
        unknown.lookAtCamera(scene.camera().lens());
        unknown.note(settings.isPath(), "integrator path");
        unknown.note(settings.filter() != PixelFilter.BOX, "filter " + settings.filter());
        unknown.note(settings.exposure() != 0 || settings.tone() != Tone.NONE, "exposure and tone");
        unknown.note(!scene.sky().equals(Sky.NONE), "sky");
        scene.lights().forEach(unknown::lookAt);
        scene.objects().forEach(object -> unknown.lookAt(object.shape(), object.material()));
        unknown.note(unknown.bodies > MOST_BODIES, "more than " + MOST_BODIES + " bodies");
        if (unknown.found.isEmpty()) {
            unknown.note(unknown.isCameraInGlass(), "a camera inside of glass");
        }
        return new ArrayList<>(unknown.found);
    }

    /** What is said of a scene with these. */
    static String sentence(List<String> unknown) {
        return "mistakes are made by a plain tracer, to be read aloud, which does not know " + String.join(", ", unknown);
    }

    private void note(boolean isThere, String what) {
        if (isThere) {
            found.add(what);
        }
    }

    private void lookAtCamera(Lens lens) {
        note(!(lens instanceof Lens.Perspective || lens instanceof Lens.Orthographic), "projection " + lens.projection());
        note(lens instanceof Lens.Perspective thin && thin.aperture() > 0, "aperture");
    }

    private void lookAt(Light light) {
        boolean isKnown = light instanceof PointLight || light instanceof SpotLight || light instanceof SunLight;
        note(!isKnown, light.kind());
        note(light instanceof SunLight sun && sun.angle() > 0, "a sun-light's angle");
    }

    private void lookAt(Shape shape, MaterialSource source) {
        if (source instanceof MaterialName name) {
            lookAt(name.in(scene.materials()));
        } else if (source != Inherited.INHERITED) {
            lookAt((Material) source);
        }
        if (shape instanceof Csg csg) {
            csg.operands().forEach(operand -> lookAt(operand.solid(), operand.material()));
        } else {
            bodies++;
            note(!SHAPES.contains(shape.getClass()), shape.kind());
        }
    }

    private void lookAt(Material material) {
        note(!PATTERNS.contains(material.pattern().getClass()), material.pattern().kind());
        note(material.fresnel() != Material.Fresnel.FALSE, "fresnel");
        note(material.roughness() > 0, "roughness");
        note(material.thin(), "thin");
        note(material.absorbs(), "attenuation-color");
        note(material.shines(), "emission");
        note(!material.shares().isEven(), "shares by patterns");
        note(!(material.relief() instanceof Material.Flat), "bump and normal-map");
    }

    /** Whoever is inside of a solid crosses its surface once more forwards than he is outside of it again. */
    private boolean isCameraInGlass() {
        Vec eye = Vec.of(scene.camera().position());
        Ray ray = Ray.fromEye(eye, new Vec(1, 0, 0));
        return Placing.bodies(scene, Mistakes.NONE).stream().filter(body -> body.isGlass)
                .anyMatch(body -> body.thing.crossings(ray).stream().filter(crossing -> crossing.t() <= 0).count() % 2 != 0);
    }
}
