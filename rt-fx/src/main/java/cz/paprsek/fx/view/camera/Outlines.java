package cz.paprsek.fx.view.camera;

import cz.paprsek.drawing.CameraView;
import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.model.edit.Arranging;
import cz.paprsek.fx.model.edit.Arranging.Role;
import cz.paprsek.fx.model.edit.LightMoves;
import cz.paprsek.fx.view.look.Strokes;
import cz.paprsek.fx.view.rays.BodyOutline;
import cz.paprsek.fx.view.rays.BodyOutline.Look;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** Draws outlines of bodies above a picture: of what is selected, the operands of it in their roles, and of what is under the mouse. */
final class Outlines {
    private final GraphicsContext g;
    private final CameraView view;
    private final Camera camera;
    private final Extent extent;
    private final EditorState state;

    /** @param extent of what is drawn */
    Outlines(GraphicsContext g, EditorState state, Camera camera, Extent extent) {
        this.g = g;
        this.view = new CameraView(camera, g.getCanvas().getWidth(), g.getCanvas().getHeight());
        this.camera = camera;
        this.extent = extent;
        this.state = state;
    }

    /** What is selected, above all else: of an operation, and beside one of its operands, what is taken away is a ghost. */
    void selected() {
        Map<Look, List<BodyAt>> drawn = drawn(state);
        boolean areMany = drawn.values().stream().flatMap(List::stream).mapToInt(this::count).sum() > Strokes.MANY;
        drawn.forEach((look, bodies) -> {
            if (areMany) {
                together(bodies, look);
            } else {
                bodies.forEach(at -> draw(at, look));
            }
        });
        Places.lights(state.selection()).stream().filter(light -> !state.isHidden(light)).forEach(light -> light(LightMoves.place(state.scene().lights().get(light.index()))));
    }

    /** All bodies that are drawn for what is selected, each once: the lowest first. */
    static Map<Look, List<BodyAt>> drawn(EditorState state) {
        Map<Look, List<BodyAt>> drawn = new EnumMap<>(Look.class);
        Set<BodyAt> operations = new LinkedHashSet<>();
        for (BodyAt at : Places.bodies(state.selection())) {
            if (!state.isHidden(at) && at.in(state.scene()).operands().isEmpty()) {
                drawn.computeIfAbsent(Look.STRONG, key -> new ArrayList<>()).add(at);
                operations.add(at.parent());
            } else if (!state.isHidden(at)) {
                operations.add(at);
            }
        }
        for (BodyAt operation : operations) {
            IntStream.range(0, operation.in(state.scene()).operands().size()).mapToObj(operation::child)
                    .filter(child -> !state.selection().contains(child) && !state.isHidden(child))
                    .forEach(child -> drawn.computeIfAbsent(look(Arranging.role(state.scene(), child)), key -> new ArrayList<>()).add(child));
        }
        return drawn;
    }

    private int count(BodyAt at) {
        return at.find(state.scene()).map(Places::count).orElse(0);
    }

    private static Look look(Optional<Role> role) {
        return role.map(known -> known == Role.CUTTER ? Look.CUTTER : known == Role.COMMON ? Look.COMMON : Look.BASE).orElse(Look.BASE);
    }

    void draw(BodyAt at, Look look) {
        if (count(at) > Strokes.MANY) {
            together(List.of(at), look);
        } else {
            BodyOutline.draw(g, this::line, camera.position(), state.scene(), at, look);
        }
    }

    private void together(List<BodyAt> bodies, Look look) {
        BodyOutline.draw(g, this::line, camera, state.scene(), bodies, look);
    }

    private List<Segment> line(Vec3 from, Vec3 to) {
        return extent.with(view.line(from, to));
    }

    private void light(Vec3 place) {
        for (Segment at : line(place, place.plus(Vec3.Y.times(1e-6)))) {
            ring(Color.BLACK, at, 5);
            ring(Color.web("#ff9b3d"), at, 2.5);
        }
    }

    private void ring(Color color, Segment at, double width) {
        g.setStroke(color);
        g.setLineWidth(width);
        g.strokeOval(at.x1() - 8, at.y1() - 8, 16, 16);
    }

    /** A line of the world that something has come to. */
    void guide(Vec3 from, Vec3 to) {
        List<Segment> pieces = line(from, to);
        g.setLineDashes(6, 4);
        g.setLineWidth(1.5);
        g.setStroke(Color.web("#ffd33d"));
        pieces.forEach(piece -> g.strokeLine(piece.x1(), piece.y1(), piece.x2(), piece.y2()));
        g.setLineDashes();
    }
}
