package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.item.Item;
import cz.paprsek.fx.model.item.Item.CameraAt;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Scene;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntUnaryOperator;
import java.util.stream.Collectors;

/** Changes of which cameras there are, which of them takes the picture, and of what it is focused on. */
public final class Cameras {
    /** Of the distance that is sharp: the radius of a lens that had none. */
    private static final double APERTURE = 0.02;

    private Cameras() {}

    /** Looks through another camera: it comes first. */
    public static EditorState through(EditorState state, int camera) {
        return selecting(state, state.scene().through(camera), i -> i == camera ? 0 : i < camera ? i + 1 : i);
    }

    /** Looks through the camera that has waited longest: the last. */
    public static EditorState next(EditorState state) {
        return through(state, state.scene().cameras().size() - 1);
    }

    /** Adds a camera that sees what the first sees, and looks through it. */
    public static EditorState add(EditorState state, String name) {
        Scene scene = state.scene();
        Set<String> taken = scene.cameras().stream().map(Camera::name).collect(Collectors.toSet());
        List<Camera> cameras = new ArrayList<>(scene.cameras());
        if (cameras.get(0).name().isEmpty()) {
            // Told apart by their names from now on.
            String first = Names.free(name, taken);
            cameras.set(0, cameras.get(0).named(first));
            taken.add(first);
        }
        cameras.add(0, scene.camera().named(Names.free(name, taken)));
        return selecting(state, scene.withCameras(cameras), i -> i + 1);
    }

    /** Takes the first camera away; the last stays. */
    public static EditorState remove(EditorState state) {
        List<Camera> cameras = state.scene().cameras();
        return cameras.size() == 1 ? state : selecting(state, state.scene().withCameras(cameras.subList(1, cameras.size())), i -> i - 1);
    }

    /** Makes a point sharp, by a thin lens. One that has no size gets a small one; other projections become perspective. */
    public static Scene focused(Scene scene, Vec3 point) {
        Camera camera = scene.camera();
        double distance = round(point.minus(camera.position()).dot(camera.forward()));
        if (!(distance > 0)) {
            return scene;
        }
        Lens.Perspective lens = camera.lens() instanceof Lens.Perspective perspective ? perspective : Lens.Perspective.DEFAULT;
        Lens.Perspective open = lens.aperture() > 0 ? lens : lens.withAperture(round(APERTURE * distance));
        return scene.withCamera(camera.withLens(open.withFocus(distance)));
    }

    private static double round(double value) {
        return new BigDecimal(value).round(new MathContext(4)).doubleValue();
    }

    private static EditorState selecting(EditorState state, Scene scene, IntUnaryOperator place) {
        return state.moved(scene, item -> item instanceof CameraAt camera
                ? Optional.of(place.applyAsInt(camera.index())).filter(i -> i >= 0).map(Item::camera) : Optional.of(item)).withSelection(Set.of(Item.CAMERA));
    }
}
