package cz.paprsek.fx.view.projection;

import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import java.util.List;

/**
 * The camera's view as a pyramid.
 *
 * @param eye where it stands
 * @param aim the point it looks at, or one straight ahead
 * @param corners of what it sees at the distance of the aim, in order around
 */
record CameraSketch(Vec3 eye, Vec3 aim, List<Vec3> corners) {

    static CameraSketch of(Scene scene) {
        Camera camera = scene.camera();
        RenderSettings settings = scene.settings();
        double distance = camera.aim() instanceof Camera.Target target ? target.point().minus(camera.position()).length() : distance(scene);
        Vec3 aim = camera.aim() instanceof Camera.Target target ? target.point() : camera.position().plus(camera.forward().times(distance));
        double half = camera.lens().heightAt(distance) / 2;
        Vec3 up = camera.trueUp().times(half);
        Vec3 right = camera.right().times(half * settings.width() / settings.height());
        return new CameraSketch(camera.position(), aim, List.of(
                aim.minus(right).minus(up), aim.plus(right).minus(up), aim.plus(right).plus(up), aim.minus(right).plus(up)));
    }

    /** About as far as the nearest things that have an end; 5 without any. */
    private static double distance(Scene scene) {
        double nearest = Double.POSITIVE_INFINITY;
        for (SceneObject object : scene.objects()) {
            Bounds box = object.shape().bounds().transformed(object.placement().toParent());
            if (box.isFinite() && !box.isEmpty()) {
                Vec3 middle = new Vec3((box.minX() + box.maxX()) / 2, (box.minY() + box.maxY()) / 2, (box.minZ() + box.maxZ()) / 2);
                double ahead = middle.minus(scene.camera().position()).dot(scene.camera().forward());
                nearest = ahead > 1e-6 ? Math.min(nearest, ahead) : nearest;
            }
        }
        return Double.isFinite(nearest) ? nearest : 5;
    }
}
