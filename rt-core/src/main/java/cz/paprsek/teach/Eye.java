package cz.paprsek.teach;

import static cz.paprsek.teach.mistake.Mistake.ASPECT_IGNORED;
import static cz.paprsek.teach.mistake.Mistake.FLIP_X;
import static cz.paprsek.teach.mistake.Mistake.FLIP_Y;
import static cz.paprsek.teach.mistake.Mistake.FOVY_HORIZONTAL;
import static cz.paprsek.teach.mistake.Mistake.FULL_FOVY;
import static cz.paprsek.teach.mistake.Mistake.HALF_PIXEL;
import static cz.paprsek.teach.mistake.Mistake.RIGHT_NOT_UNIT;
import static cz.paprsek.teach.mistake.Mistake.UP_AS_GIVEN;

import cz.paprsek.math.Angles;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.teach.mistake.Mistakes;

/** Makes the rays through points of the picture: d + (x/W − ½)·h·W/H·r + (½ − y/H)·h·u. */
final class Eye {
    private final Mistakes made;
    private final Notes notes;
    private final int width;
    private final int height;
    private final boolean isParallel;
    private final Vec position;
    private final Vec forward;
    private final Vec across;
    private final Vec upwards;

    Eye(Camera camera, int width, int height, Mistakes made, Notes notes) {
        this.made = made;
        this.notes = notes;
        this.width = width;
        this.height = height;
        this.isParallel = camera.lens() instanceof Lens.Orthographic;
        Vec3 d = camera.forward();
        Vec3 sideways = d.cross(camera.upwards().normalized());
        Vec3 r = made.has(RIGHT_NOT_UNIT) ? sideways : sideways.normalized();
        Vec3 u = made.has(UP_AS_GIVEN) ? camera.upwards().normalized() : sideways.normalized().cross(d);
        double h = camera.lens() instanceof Lens.Orthographic parallel ? parallel.height() : height(((Lens.Perspective) camera.lens()).fovy());
        double w = made.has(ASPECT_IGNORED) ? h : h * width / height;
        position = Vec.of(camera.position());
        forward = Vec.of(d);
        across = Vec.of(r).times(w);
        upwards = Vec.of(u).times(h);
        notes.put("d", forward).put("r", Vec.of(r)).put("u", Vec.of(u)).put("h", h).put("w", w);
    }

    /** How high the picture is at distance 1. */
    private double height(double fovy) {
        double h = 2 * Angles.tan(made.has(FULL_FOVY) ? fovy : fovy / 2);
        return made.has(FOVY_HORIZONTAL) ? h * height / width : h;
    }

    /** The ray through a point of the picture; the centre of the pixel in column j and row i is (j + ½, i + ½). */
    Ray ray(double column, double row) {
        double x = made.has(HALF_PIXEL) ? column - 0.5 : column;
        double y = made.has(HALF_PIXEL) ? row - 0.5 : row;
        x = made.has(FLIP_X) ? width - x : x;
        y = made.has(FLIP_Y) ? height - y : y;
        notes.put("x", x).put("y", y);
        Vec onPicture = across.times(x * (1.0 / width) - 0.5);
        Vec up = upwards.times(0.5 - y * (1.0 / height));
        Vec start = isParallel ? position.plus(onPicture).plus(up) : position;
        Vec direction = isParallel ? forward : forward.plus(onPicture).plus(up).unit();
        return Ray.fromEye(start, direction);
    }
}
