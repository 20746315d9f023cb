package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;
import static cz.paprsek.text.Numbers.text;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.light.FixedPoints;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.CustomLight;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.PointLight;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.scene.SpotLight;
import cz.paprsek.scene.SunLight;
import cz.paprsek.text.MadeInCode;
import java.util.ArrayList;
import java.util.List;

/**
 * Lights in POV-Ray's words. One with a size is as many small ones as it has samples, where the fixed sampler looks for it: POV-Ray's own kind
 * of area light shades from its middle.
 */
final class PovLights {
    /** By this share of the reference distance POV-Ray's light is bounded: it falls as 2/(1 + (d/ε)²), ε the product. */
    private static final double NEAR = 1e-5;
    /** What POV-Ray takes for no distance is a hundredth of this. */
    private static final double NEAREST = 1e-8;
    /** How far what is seen of a light lies behind where it shines from, so as not to stand in its own way, scene units. */
    private static final double BEHIND = 1e-4;
    /** How far away the disc of a sun is, scene units. */
    private static final double FAR = 1e6;

    private final Scene scene;
    private final Light light;
    private final List<String> lines = new ArrayList<>();

    private PovLights(Scene scene, Light light) {
        this.scene = scene;
        this.light = light;
    }

    /** What shines as this light, and what is seen of it. */
    static List<String> of(Scene scene, Light light, int number) {
        if (light instanceof CustomLight) {
            throw MadeInCode.refusedBy("a scene for POV-Ray", light.kind(), "light");
        }
        PovLights all = new PovLights(scene, light);
        all.write(FixedPoints.of(light, number));
        return all.lines;
    }

    private void write(List<Vec3> points) {
        if (light instanceof PointLight point) {
            source(point.position(), 1, point.referenceDistance(), "");
        } else if (light instanceof SpotLight spot) {
            source(spot.position(), 1, spot.referenceDistance(), " spotlight point_at " + vector(spot.position().plus(spot.direction()))
                    + " radius " + text(spot.fullAngle()) + " falloff " + text(spot.outerAngle()) + " tightness 0");
        } else if (light instanceof AreaLight area) {
            List<Vec3> places = points.isEmpty() ? List.of(area.position()) : points;
            places.forEach(place -> source(place, 1.0 / places.size(), area.referenceDistance(),
                    " spotlight point_at " + vector(place.plus(area.direction())) + " radius 90 falloff 90 tightness 1"));
            body(area);
        } else if (light instanceof SphereLight ball) {
            source(ball.position(), 1, ball.referenceDistance(), "");
            body(ball);
        } else if (light instanceof SunLight sun) {
            sun(sun, points);
        }
    }

    private void sun(SunLight sun, List<Vec3> towards) {
        List<Vec3> directions = towards.isEmpty() ? List.of(sun.direction().normalized()) : towards.stream().map(Vec3::negated).toList();
        // As the disc's radiance times its solid angle by π.
        double all = 2 / (1 + Angles.cos(sun.angle() / 2));
        for (Vec3 direction : directions) {
            Vec3 place = away(direction);
            source(place, all / directions.size(), 0, " parallel point_at " + vector(place.plus(direction)));
        }
        if (sun.visible() && sun.angle() > 0) {
            double sine = Angles.sin(sun.angle() / 2);
            lines.add("sphere { " + vector(sun.direction().normalized().times(-FAR)) + ", " + text(FAR * sine) + " " + glowing(1 / (sine * sine)) + " no_shadow }");
        }
    }

    /**
     * Adds one source.
     *
     * @param factor on its intensity
     * @param reference distance at which that arrives; 0 for light that does not fall
     * @param how the words for what it is other than a point
     */
    private void source(Vec3 place, double factor, double reference, String how) {
        double near = Math.max(NEAREST, NEAR * reference);
        double bright = reference == 0 ? 1 : reference * reference / (2 * near * near);
        lines.add("light_source { " + vector(place) + ", " + PovMaterials.rgb(light.color(), light.intensity() * factor * bright) + how
                + (reference == 0 ? "" : " fade_distance " + text(near) + " fade_power 2") + " }");
    }

    /** A point that light of this direction comes from before it meets anything: POV-Ray's parallel light begins in a plane. */
    private Vec3 away(Vec3 direction) {
        Bounds all = Bounds.of(scene.camera().position(), scene.camera().position());
        for (SceneObject object : scene.objects()) {
            Bounds bounds = object.shape().bounds().transformed(object.placement().toParent());
            all = bounds.isFinite() ? all.union(bounds) : all;
        }
        Vec3 middle = new Vec3((all.minX() + all.maxX()) / 2, (all.minY() + all.maxY()) / 2, (all.minZ() + all.maxZ()) / 2);
        double size = (all.maxX() - all.minX()) + (all.maxY() - all.minY()) + (all.maxZ() - all.minZ());
        return middle.minus(direction.times(10 * size + 1));
    }

    /** Its shining side, and behind that its black one. */
    private void body(AreaLight area) {
        if (!area.visible()) {
            return;
        }
        String shape;
        if (area.form() instanceof AreaLight.Size size) {
            double x = size.width() / 2;
            double y = size.height() / 2;
            shape = "polygon { 5, " + vector(-x, -y, 0) + ", " + vector(x, -y, 0) + ", " + vector(x, y, 0) + ", " + vector(-x, y, 0) + ", " + vector(-x, -y, 0);
        } else {
            shape = "disc { 0, z, " + text(((AreaLight.Radius) area.form()).radius());
        }
        double square = area.referenceDistance() * area.referenceDistance();
        String turned = area.rotation().equals(Vec3.ZERO) ? "" : " rotate " + vector(area.rotation());
        for (int side = 1; side <= 2; side++) {
            lines.add(shape + " " + glowing(side == 1 ? Math.PI * square / area.form().area() : 0) + turned
                    + " translate " + vector(area.position().minus(area.direction().times(side * BEHIND))) + " }");
        }
    }

    private void body(SphereLight ball) {
        if (ball.visible()) {
            double by = ball.referenceDistance() / ball.radius();
            lines.add("sphere { " + vector(ball.position()) + ", " + text(ball.radius()) + " " + glowing(by * by) + " no_shadow }");
        }
    }

    private String glowing(double radiance) {
        return "texture { pigment { " + PovMaterials.rgb(light.color(), light.intensity() * radiance) + " } finish { ambient 0 diffuse 0 emission 1 } }";
    }
}
