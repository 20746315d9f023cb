package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.placed.Ray;
import cz.paprsek.shape.placed.Spans;
import cz.paprsek.shape.placed.Surface;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** Finds what is at a point of a projection. */
final class Picker {
    /** How near the mouse must come to a line, pixels. */
    private static final double LINE = 4;
    /** How near the mouse must come to a light or a camera, pixels. */
    private static final double MARK = 9;
    /** Where rays start that look for what has no end, scene units. */
    private static final double FAR = 1e6;

    /** Something under the mouse; the smaller the rank, the sooner it is picked. */
    private record Candidate(ScenePath item, double rank) {}

    private final Axes axes;
    private final Figures figures;

    Picker(Axes axes, Figures figures) {
        this.axes = axes;
        this.figures = figures;
    }

    /**
     * All that can be picked at a point, in the order in which clicks reach it: lights and cameras, objects whose lines are under the
     * mouse, objects whose inside is, from the viewer to the back, and last the operands within.
     */
    List<ScenePath> at(EditorState state, Viewport view, double x, double y) {
        double u = view.u(x);
        double v = view.v(y);
        List<ScenePath> found = new ArrayList<>(marks(state, view, x, y));
        List<Candidate> objects = new ArrayList<>();
        Scene scene = figures.scene();
        for (int i = 0; i < scene.objects().size(); i++) {
            collect(state, ScenePath.body(i), view, u, v, objects);
        }
        List<ScenePath> sorted = sorted(objects);
        found.addAll(sorted);
        sorted.forEach(item -> found.addAll(operands(state, (BodyAt) item, view, u, v)));
        return found;
    }

    /** All whose boxes lie wholly within a box, operands not. */
    Set<ScenePath> within(EditorState state, Box box) {
        Set<ScenePath> found = new LinkedHashSet<>();
        Scene scene = figures.scene();
        for (int i = 0; i < scene.objects().size(); i++) {
            Box own = figures.of(i).box();
            if (!own.isEmpty() && box.contains(own)) {
                found.add(ScenePath.body(i));
            }
        }
        for (int i = 0; i < scene.lights().size(); i++) {
            if (box.contains(figures.box(ScenePath.light(i)))) {
                found.add(ScenePath.light(i));
            }
        }
        found.removeIf(item -> !canPick(state, item));
        return found;
    }

    private List<ScenePath> marks(EditorState state, Viewport view, double x, double y) {
        List<ScenePath> marks = new ArrayList<>();
        for (int i = figures.scene().cameras().size() - 1; i >= 0; i--) {
            marks.add(ScenePath.camera(i));
        }
        for (int i = figures.scene().lights().size() - 1; i >= 0; i--) {
            marks.add(ScenePath.light(i));
        }
        marks.removeIf(item -> {
            Box box = figures.box(item);
            return !canPick(state, item) || Math.hypot(view.x(box.centreU()) - x, view.y(box.centreV()) - y) > MARK;
        });
        return marks;
    }

    private List<ScenePath> operands(EditorState state, BodyAt operation, Viewport view, double u, double v) {
        List<Candidate> found = new ArrayList<>();
        int count = operation.in(figures.scene()).operands().size();
        for (int i = 0; i < count; i++) {
            collect(state, operation.child(i), view, u, v, found);
        }
        List<ScenePath> sorted = sorted(found);
        List<ScenePath> all = new ArrayList<>(sorted);
        sorted.forEach(item -> all.addAll(operands(state, (BodyAt) item, view, u, v)));
        return all;
    }

    private void collect(EditorState state, BodyAt at, Viewport view, double u, double v, List<Candidate> found) {
        Figure figure = figures.of(at);
        double reach = LINE / view.scale();
        if (!canPick(state, at) || (!figure.box().isEmpty() && !figure.box().contains(u, v, reach))) {
            return;
        }
        double distance = figure.distance(u, v);
        if (distance <= reach) {
            // Before all that is merely covered, which is ranked by depth: an arctangent is bounded.
            found.add(new Candidate(at, -2 + distance / reach));
            return;
        }
        double depth = depth(at, u, v);
        if (!Double.isNaN(depth)) {
            found.add(new Candidate(at, Math.PI / 2 - Math.atan(depth)));
        }
    }

    /** How near to the viewer the body first appears at a point; NaN if it does not. */
    private double depth(BodyAt at, double u, double v) {
        Surface surface = at.placed(figures.scene());
        Bounds bounds = surface.bounds();
        double start = bounds.isFinite() ? 2 * bounds.magnitude() + 1 : FAR;
        Vec3 origin = axes.vector(u, v).minus(axes.along().times(start));
        Vec3 along = axes.along();
        Ray ray = new Ray(new Spans());
        ray.start(origin.x(), origin.y(), origin.z(), along.x(), along.y(), along.z());
        surface.nearest(ray);
        return ray.part < 0 ? Double.NaN : start - ray.max;
    }

    private static boolean canPick(EditorState state, ScenePath item) {
        return !state.isHidden(item) && !state.isLocked(item);
    }

    private static List<ScenePath> sorted(List<Candidate> candidates) {
        candidates.sort(Comparator.comparingDouble(Candidate::rank));
        return candidates.stream().map(Candidate::item).toList();
    }
}
