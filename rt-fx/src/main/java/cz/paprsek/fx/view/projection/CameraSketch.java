package cz.paprsek.fx.view.projection;

import cz.paprsek.drawing.CameraView;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

/**
 * What a camera sees, drawn by the rays of its picture.
 *
 * @param eye where it stands
 * @param aim the point it looks at, or one straight ahead
 * @param lines of the rays through the picture's corners or rim, and around what is seen at the distance of the aim, or all around
 * @param lens around its lens and around what is sharp; empty for a pinhole
 */
record CameraSketch(Vec3 eye, Vec3 aim, List<List<Vec3>> lines, List<List<Vec3>> lens) {
    /** Pieces of a circle. */
    private static final int PIECES = 48;
    /** Just within a circle's rim, where rounding does not matter. */
    private static final double INSIDE = 1 - 1e-9;

    /** Draws one of a scene's cameras, counted from 0. */
    static CameraSketch of(Scene scene, int index) {
        Camera camera = scene.cameras().get(index);
        double width = scene.settings().width();
        double height = scene.settings().height();
        double distance = camera.aim() instanceof Camera.Target target ? target.point().minus(camera.position()).length() : distance(scene, camera);
        Vec3 aim = camera.aim() instanceof Camera.Target target ? target.point() : camera.position().plus(camera.forward().times(distance));
        CameraView view = new CameraView(camera, width, height);
        List<List<Vec3>> lines = new ArrayList<>();
        if (camera.lens() instanceof Lens.Fisheye) {
            List<List<Vec3>> rim = rays(view, distance, i -> width / 2 + Math.cos(turn(i)) * height / 2 * INSIDE, i -> height / 2 + Math.sin(turn(i)) * height / 2 * INSIDE, PIECES);
            lines.add(closed(rim, 1));
            for (int i = 0; i < rim.size(); i += PIECES / 8) {
                lines.add(rim.get(i));
            }
        } else if (camera.lens() instanceof Lens.Spherical) {
            lines.add(closed(rays(view, distance, i -> width * i / PIECES, i -> height / 2, PIECES), 1));
            lines.add(closed(rays(view, distance, i -> i < PIECES / 2 ? width / 2 : 0, i -> i < PIECES / 2 ? 2 * height * i / PIECES : 2 * height - 2 * height * i / PIECES, PIECES), 1));
            lines.add(List.of(camera.position(), aim));
        } else {
            List<List<Vec3>> corners = rays(view, distance, i -> i == 1 || i == 2 ? width : 0, i -> i < 2 ? height : 0, 4);
            lines.addAll(corners);
            lines.add(closed(corners, 1));
            lines.add(closed(corners, 0));
        }
        return new CameraSketch(camera.position(), aim, lines, lens(camera, view, width, height));
    }

    private static double turn(int piece) {
        return 2 * Math.PI * piece / PIECES;
    }

    private static List<List<Vec3>> rays(CameraView view, double distance, IntToDoubleFunction x, IntToDoubleFunction y, int count) {
        return IntStream.range(0, count).mapToObj(i -> view.ray(x.applyAsDouble(i), y.applyAsDouble(i), distance)).filter(ray -> !ray.isEmpty()).toList();
    }

    /** Around the starts of rays, or around their ends. */
    private static List<Vec3> closed(List<List<Vec3>> rays, int which) {
        return IntStream.rangeClosed(0, rays.size()).mapToObj(i -> rays.get(i % rays.size()).get(which)).toList();
    }

    private static List<List<Vec3>> lens(Camera camera, CameraView view, double width, double height) {
        if (!(camera.lens() instanceof Lens.Perspective thin) || thin.aperture() == 0) {
            return List.of();
        }
        List<Vec3> rim = IntStream.rangeClosed(0, PIECES).mapToObj(i -> camera.position().plus(camera.right().times(thin.aperture() * Math.cos(turn(i))))
                .plus(camera.trueUp().times(thin.aperture() * Math.sin(turn(i))))).toList();
        return List.of(rim, closed(rays(view, camera.focus(), i -> i == 1 || i == 2 ? width : 0, i -> i < 2 ? height : 0, 4), 1));
    }

    /** About as far as the nearest things that have an end; 5 without any. */
    private static double distance(Scene scene, Camera camera) {
        double nearest = Double.POSITIVE_INFINITY;
        for (SceneObject object : scene.objects()) {
            Bounds box = object.shape().bounds().transformed(object.placement().toParent());
            if (box.isFinite() && !box.isEmpty()) {
                Vec3 middle = new Vec3((box.minX() + box.maxX()) / 2, (box.minY() + box.maxY()) / 2, (box.minZ() + box.maxZ()) / 2);
                double ahead = middle.minus(camera.position()).dot(camera.forward());
                nearest = ahead > 1e-6 ? Math.min(nearest, ahead) : nearest;
            }
        }
        return Double.isFinite(nearest) ? nearest : 5;
    }
}
