package cz.paprsek.fx.model.edit;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Lens;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.CameraAt;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Changes of which cameras there are, in which order, and of what they are focused on. */
public final class Cameras {
    /** Of the distance that is sharp: the radius of a lens that had none. */
    private static final double APERTURE = 0.02;

    /** Fewer rays a pixel make a blur grainy. */
    private static final int RAYS_FOR_BLUR = 16;

    private Cameras() {}

    /** Changes one of a scene's cameras, counted from 0. */
    public static Scene changed(Scene scene, int camera, UnaryOperator<Camera> change) {
        List<Camera> cameras = new ArrayList<>(scene.cameras());
        cameras.set(camera, change.apply(cameras.get(camera)));
        return scene.withCameras(cameras);
    }

    /** A camera that looks at a point, by a target or a direction as before. */
    public static Camera lookingAt(Camera camera, Vec3 point) {
        return camera.withAim(camera.aim() instanceof Camera.Target ? new Camera.Target(point) : new Camera.Direction(point.minus(camera.position())));
    }

    /** Makes a camera the first, whose picture is rendered where none is named. */
    public static EditorState first(EditorState state, int camera) {
        return moved(state, scene -> scene.through(camera),
                place -> Optional.of(place instanceof CameraAt at ? ScenePath.camera(at.index() == camera ? 0 : at.index() < camera ? at.index() + 1 : at.index()) : place));
    }

    /** Adds a camera that sees what the one looked through sees, selects it and looks through it. */
    public static EditorState add(EditorState state, String name) {
        Set<String> taken = names(state);
        List<Camera> cameras = new ArrayList<>(state.scene().cameras());
        if (state.camera().name().isEmpty()) {
            // Told apart by their names from now on.
            String seeing = Names.free(name, taken);
            cameras.set(state.eye(), state.camera().named(seeing));
            taken.add(seeing);
        }
        cameras.add(state.camera().named(Names.free(name, taken)));
        return moved(state, scene -> scene.withCameras(cameras), Optional::of).withSelection(Set.of(ScenePath.camera(cameras.size() - 1))).through(cameras.size() - 1);
    }

    /** Adds copies of cameras, with free names, and selects them too. */
    static EditorState withCopies(EditorState state, Collection<CameraAt> originals) {
        return withOthers(state, originals.stream().map(at -> state.scene().cameras().get(at.index())).toList());
    }

    /** Adds cameras, with free names, and selects them too. */
    static EditorState withOthers(EditorState state, List<Camera> others) {
        Set<String> taken = names(state);
        Set<ScenePath> selection = new LinkedHashSet<>(state.selection());
        List<Camera> cameras = new ArrayList<>(state.scene().cameras());
        for (Camera other : others) {
            Camera added = other.named(Names.free(other.name(), taken));
            taken.add(added.name());
            selection.add(ScenePath.camera(cameras.size()));
            cameras.add(added);
        }
        return others.isEmpty() ? state : moved(state, scene -> scene.withCameras(cameras), Optional::of).withSelection(selection);
    }

    /** A camera with a name: its own, or what it is. */
    static Camera named(Camera camera) {
        return camera.name().isEmpty() ? camera.named("camera") : camera;
    }

    /** Takes cameras away. Of all of them, the one that is looked through stays: a picture needs one. */
    public static EditorState remove(EditorState state, Collection<CameraAt> removed) {
        List<Integer> kept = IntStream.range(0, state.scene().cameras().size()).boxed().filter(i -> !removed.contains(ScenePath.camera(i))).toList();
        List<Integer> staying = kept.isEmpty() ? List.of(state.eye()) : kept;
        return removed.isEmpty() ? state : moved(state, scene -> scene.withCameras(staying.stream().map(scene.cameras()::get).toList()),
                place -> Optional.of(place).filter(item -> !(item instanceof CameraAt at) || staying.contains(at.index()))
                        .map(item -> item instanceof CameraAt at ? ScenePath.camera(staying.indexOf(at.index())) : item));
    }

    private static EditorState moved(EditorState state, UnaryOperator<Scene> change, Function<ScenePath, Optional<ScenePath>> place) {
        return state.moved(state.scene().changed(change, place), place);
    }

    /** Makes a point sharp for one of a scene's cameras; a picture of too few rays for a blur gets the rays that new scenes have. */
    public static Scene focused(Scene scene, int camera, Vec3 point) {
        Scene sharp = changed(scene, camera, now -> focused(now, point));
        boolean isGrainy = !sharp.equals(scene) && sharp.settings().mostRays() < RAYS_FOR_BLUR;
        return isGrainy ? sharp.withSettings(sharp.settings().withSamples(2, 6)) : sharp;
    }

    /** Makes a point sharp for a camera, by a thin lens. One that has no size gets a small one; other projections become perspective. */
    static Camera focused(Camera camera, Vec3 point) {
        double distance = round(point.minus(camera.position()).dot(camera.forward()));
        if (!(distance > 0)) {
            return camera;
        }
        Lens.Perspective lens = camera.lens() instanceof Lens.Perspective perspective ? perspective : Lens.Perspective.DEFAULT;
        Lens.Perspective open = lens.aperture() > 0 ? lens : lens.withAperture(round(APERTURE * distance));
        return camera.withLens(open.withFocus(distance));
    }

    private static Set<String> names(EditorState state) {
        return state.scene().cameras().stream().map(Camera::name).collect(Collectors.toSet());
    }

    private static double round(double value) {
        return new BigDecimal(value).round(new MathContext(4)).doubleValue();
    }
}
