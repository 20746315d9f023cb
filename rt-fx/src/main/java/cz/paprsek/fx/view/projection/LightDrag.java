package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.Gesture;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.AreaLight;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.SpotLight;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Turns a light by what it shines at, or makes its cone wider by the rim. */
final class LightDrag implements Drag {
    /** Angles of a free hand are of this coarseness, so that they can be read. */
    private static final double DEGREES = 0.5;

    private final Gesture gesture;
    private final int light;
    private final Handle handle;
    private final Axes axes;
    private final Viewport view;
    private final boolean snaps;
    private final double startX;
    private final double startY;
    private double angle = Double.NaN;

    /** What is grabbed of a light. */
    enum Kind { AIM, RIM }

    /**
     * Something to be grabbed.
     *
     * @param place world space
     */
    record Handle(Kind kind, Vec3 place) {}

    LightDrag(Gesture gesture, int light, Handle handle, Axes axes, Viewport view, boolean snaps, double startX, double startY) {
        this.gesture = gesture;
        this.light = light;
        this.handle = handle;
        this.axes = axes;
        this.view = view;
        this.snaps = snaps;
        this.startX = startX;
        this.startY = startY;
    }

    /** What can be grabbed of a light. */
    static List<Handle> handles(Light light, Axes axes) {
        List<Handle> handles = new ArrayList<>();
        if (light instanceof SpotLight spot) {
            handles.add(new Handle(Kind.RIM, LightSketch.rimHandle(spot, axes)));
        }
        LightSketch.of(light, axes).aim().ifPresent(aim -> handles.add(new Handle(Kind.AIM, aim)));
        return handles;
    }

    @Override
    public void to(double x, double y, Keys keys) {
        double u = axes.u(handle.place()) + (x - startX) / view.scale();
        double v = axes.v(handle.place()) + (startY - y) / view.scale();
        boolean snap = snaps && !keys.free() && handle.kind() == Kind.AIM;
        double step = Grid.step(view.scale());
        Vec3 point = handle.place().plus(axes.vector((snap ? Snapping.toGrid(u, step) : u) - axes.u(handle.place()),
                (snap ? Snapping.toGrid(v, step) : v) - axes.v(handle.place())));
        Light old = gesture.start().scene().lights().get(light);
        Light fresh = handle.kind() == Kind.AIM ? aimed(old, point) : widened((SpotLight) old, point);
        gesture.preview(scene -> {
            List<Light> lights = new ArrayList<>(scene.lights());
            lights.set(light, fresh);
            return scene.withLights(lights);
        });
    }

    private static Light aimed(Light old, Vec3 point) {
        if (old instanceof SpotLight spot) {
            return spot.withAim(spot.aim() instanceof Camera.Target ? new Camera.Target(point) : new Camera.Direction(point.minus(spot.position())));
        }
        AreaLight area = ((AreaLight) old).shiningAt(point);
        Vec3 turned = area.rotation();
        return area.withRotation(new Vec3(rounded(turned.x()), rounded(turned.y()), 0));
    }

    /** With the inner angle in proportion. */
    private SpotLight widened(SpotLight old, Vec3 point) {
        Vec3 to = point.minus(old.position());
        double wide = Math.max(DEGREES, Math.min(90, rounded(Math.toDegrees(Math.atan2(to.cross(old.direction()).length(), to.dot(old.direction()))))));
        angle = wide;
        return old.withAngles(rounded(old.fullAngle() * wide / old.outerAngle()), wide);
    }

    private static double rounded(double degrees) {
        return Math.rint(degrees / DEGREES) * DEGREES + 0.0;
    }

    @Override
    public void end() {
        gesture.commit();
    }

    @Override
    public void cancel() {
        gesture.cancel();
    }

    @Override
    public String figures(Locale locale) {
        return Double.isNaN(angle) ? "" : String.format(locale, "%.1f°", angle);
    }
}
