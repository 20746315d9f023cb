package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;
import static cz.paprsek.text.Numbers.text;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import java.util.List;

/** Lights in POV-Ray's words. */
final class PovLights {
    /** By this share of the reference distance its fall-off differs from the square of the distance: 2/(1 + (d/ε)²), ε the product. */
    private static final double NEAR = 1e-5;
    /** What POV-Ray takes for no distance is a hundredth of this. */
    private static final double NEAREST = 1e-8;

    private PovLights() {}

    /** The sources of light that shine as this one. */
    static List<String> of(Scene scene, Light light) {
        if (light instanceof PointLight point) {
            return List.of(source(point.position(), light, 1, point.referenceDistance(), ""));
        } else if (light instanceof SpotLight spot) {
            return List.of(source(spot.position(), light, 1, spot.referenceDistance(), " spotlight point_at " + vector(spot.position().plus(spot.direction()))
                    + " radius " + text(spot.innerAngle()) + " falloff " + text(spot.outerAngle()) + " tightness 0"));
        } else if (light instanceof SunLight sun) {
            Vec3 direction = sun.direction().normalized();
            Vec3 place = away(scene, direction);
            return List.of(source(place, light, 1, 0, " parallel point_at " + vector(place.plus(direction))));
        }
        return List.of();
    }

    /**
     * One source.
     *
     * @param factor on its intensity
     * @param reference distance at which that arrives; 0 for light that does not fall
     * @param how the words for what it is other than a point
     */
    private static String source(Vec3 place, Light light, double factor, double reference, String how) {
        double near = Math.max(NEAREST, NEAR * reference);
        double bright = reference == 0 ? 1 : reference * reference / (2 * near * near);
        return "light_source { " + vector(place) + ", " + PovMaterials.rgb(light.color(), light.intensity() * factor * bright) + how
                + (reference == 0 ? "" : " fade_distance " + text(near) + " fade_power 2") + " }";
    }

    /** A point that light of this direction comes from before it meets anything: POV-Ray's parallel light begins in a plane. */
    private static Vec3 away(Scene scene, Vec3 direction) {
        Bounds all = Bounds.of(scene.camera().position(), scene.camera().position());
        for (SceneObject object : scene.objects()) {
            Bounds bounds = object.shape().bounds().transformed(object.placement().toParent());
            all = bounds.isFinite() ? all.union(bounds) : all;
        }
        Vec3 middle = new Vec3((all.minX() + all.maxX()) / 2, (all.minY() + all.maxY()) / 2, (all.minZ() + all.maxZ()) / 2);
        double size = (all.maxX() - all.minX()) + (all.maxY() - all.minY()) + (all.maxZ() - all.minZ());
        return middle.minus(direction.times(10 * size + 1));
    }
}
