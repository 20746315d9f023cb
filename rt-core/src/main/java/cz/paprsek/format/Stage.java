package cz.paprsek.format;

import cz.paprsek.material.Material;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Angles;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Plane;
import java.util.ArrayList;
import java.util.List;

/**
 * What a file of bodies does not have, and a picture needs: a camera that sees all of them from the front, somewhat from the right and from above; a soft light from the left
 * and some from everywhere; a floor beneath; and as many rays as each pixel needs. Cameras and lights of the file's own come first.
 */
final class Stage {
    private static final Vec3 VIEW = new Vec3(0.55, 0.45, 1);
    private static final Vec3 LIGHT = new Vec3(-0.9, 1.6, 1.3);
    private static final double FOVY = 30;
    /** How much of the picture's width and height is for what is shown. */
    private static final double FILLED = 0.84;
    private static final double RATIO = RenderSettings.DEFAULT.width() / (double) RenderSettings.DEFAULT.height();
    /** Of a file with neither size nor place. */
    private static final Bounds SOMETHING = new Bounds(-1, -1, -1, 1, 1, 1);
    private static final Material FLOOR = Material.color(Rgb.grey(196)).withDiffusion(0.75);

    private Stage() {}

    /** @param objects where y is up */
    static Scene of(String name, List<SceneObject> objects, List<Camera> cameras, List<Light> lights) {
        Bounds bounds = objects.stream().map(object -> object.shape().bounds().transformed(object.placement().toParent())).reduce(Bounds.EMPTY, Bounds::union);
        if (bounds.isEmpty() || !bounds.isFinite()) {
            bounds = SOMETHING;
        }
        bounds = seen(bounds);
        Vec3 centre = new Vec3((bounds.minX() + bounds.maxX()) / 2, (bounds.minY() + bounds.maxY()) / 2, (bounds.minZ() + bounds.maxZ()) / 2);
        double radius = Math.max(new Vec3(bounds.maxX() - bounds.minX(), bounds.maxY() - bounds.minY(), bounds.maxZ() - bounds.minZ()).length() / 2, 1e-30);
        List<Camera> all = new ArrayList<>(cameras);
        all.add(camera(bounds, centre));
        List<SceneObject> with = new ArrayList<>(objects);
        with.add(SceneObject.of(new Plane()).named(free("floor", objects)).at(0, bounds.minY(), 0).madeOf(FLOOR));
        return Scene.EMPTY.withName(name).withSettings(RenderSettings.DEFAULT.withSamples(2, 8)).withSky(new Scene.Sky.Gradient(new Rgb(150, 175, 205), new Rgb(232, 236, 240), Rgb.grey(150)))
                .withAmbient(Rgb.grey(lights.isEmpty() ? 118 : 60)).withCameras(all).withLights(lights.isEmpty() ? List.of(light(centre, radius)) : lights).withObjects(with);
    }

    /** With a size: what is all in one place, or nearly so for its distance from the origin, gets some room around it. */
    private static Bounds seen(Bounds b) {
        double far = Math.max(Math.max(Math.abs(b.minX() + b.maxX()), Math.abs(b.minY() + b.maxY())), Math.abs(b.minZ() + b.maxZ())) / 2;
        double size = Math.max(Math.max(b.maxX() - b.minX(), b.maxY() - b.minY()), b.maxZ() - b.minZ());
        double room = size > 1e-9 * far ? 0 : far > 0 ? 1e-3 * far : 1;
        return new Bounds(b.minX() - room, b.minY() - room, b.minZ() - room, b.maxX() + room, b.maxY() + room, b.maxZ() + room);
    }

    private static String free(String wanted, List<SceneObject> objects) {
        String name = wanted;
        for (int i = 2; isTaken(name, objects); i++) {
            name = wanted + " " + i;
        }
        return name;
    }

    private static boolean isTaken(String name, List<SceneObject> objects) {
        return objects.stream().anyMatch(object -> object.name().equals(name));
    }

    private static Vec3 rounded(Vec3 place, double size) {
        return new Vec3(rounded(place.x(), size), rounded(place.y(), size), rounded(place.z(), size));
    }

    /** To some thousandths of a size: numbers that people can read. */
    private static double rounded(double value, double size) {
        double power = 1;
        while (power * size < 1000 && power < 1e33) {
            power *= 10;
        }
        return Math.rint(value * power) / power;
    }

    private static Light light(Vec3 centre, double radius) {
        Vec3 way = LIGHT.normalized().times(5 * radius);
        return SphereLight.of(rounded(centre.plus(way), radius), rounded(0.6 * radius, radius)).withReferenceDistance(rounded(5 * radius, radius)).withIntensity(0.85).withVisible(false);
    }

    /** As near as it can be with all corners of the box within the picture. */
    private static Camera camera(Bounds bounds, Vec3 centre) {
        Vec3 back = VIEW.normalized();
        Vec3 right = Vec3.Y.cross(back).normalized();
        Vec3 up = back.cross(right);
        double tangent = Angles.tan(FOVY / 2) * FILLED;
        double distance = 0;
        for (int i = 0; i < 8; i++) {
            Vec3 corner = new Vec3((i & 1) == 0 ? bounds.minX() : bounds.maxX(), (i & 2) == 0 ? bounds.minY() : bounds.maxY(), (i & 4) == 0 ? bounds.minZ() : bounds.maxZ()).minus(centre);
            double nearer = corner.dot(back);
            distance = Math.max(distance, nearer + Math.max(Math.abs(corner.dot(up)) / tangent, Math.abs(corner.dot(right)) / (tangent * RATIO)));
        }
        double size = Math.max(distance, 1e-30);
        return Camera.lookingAt(rounded(centre.plus(back.times(size)), size), rounded(centre, size)).withLens(Lens.Perspective.DEFAULT.withFovy(FOVY));
    }
}
