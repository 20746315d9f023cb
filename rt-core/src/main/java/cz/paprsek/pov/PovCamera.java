package cz.paprsek.pov;

import static cz.paprsek.pov.PovText.vector;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.text.Numbers;

/** Cameras in the words of POV-Ray. */
final class PovCamera {
    private PovCamera() {}

    /** A camera; a lens that has a size as its middle. */
    static String of(Camera camera) {
        if (camera.lens() instanceof Lens.Perspective perspective) {
            double height = 2 * Angles.tan(perspective.fovy() / 2);
            return "perspective " + frame(camera.position(), camera.forward(), camera.right().times(height), camera.trueUp().times(height));
        } else if (camera.lens() instanceof Lens.Orthographic orthographic) {
            double height = orthographic.height();
            return "orthographic " + frame(camera.position(), camera.forward(), camera.right().times(height), camera.trueUp().times(height));
        } else if (camera.lens() instanceof Lens.Fisheye fisheye) {
            return "fisheye " + frame(camera.position(), camera.forward(), camera.right(), camera.trueUp()) + " angle " + Numbers.text(fisheye.angle());
        }
        // It turns the direction about up and right, the other way round than in our hand.
        return "spherical location " + vector(camera.position()) + " direction " + vector(camera.forward())
                + " up " + vector(camera.trueUp().negated()) + " right " + vector(camera.right().negated()) + " angle 360 180";
    }

    /** The lengths of {@code up} and {@code right} are the size of the picture at distance 1; POV-Ray's {@code angle} would be horizontal. */
    private static String frame(Vec3 position, Vec3 direction, Vec3 right, Vec3 up) {
        return "location " + vector(position) + " direction " + vector(direction) + " up " + vector(up) + " right image_width/image_height*" + vector(right);
    }
}
