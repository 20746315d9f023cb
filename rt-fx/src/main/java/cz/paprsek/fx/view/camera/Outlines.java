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
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.scene.ScenePath.LightAt;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;

/** Draws outlines of bodies above a picture: of what is selected, the operands of it in their roles, and of what is under the mouse. */
final class Outlines {
    private final GraphicsContext g;
    private final CameraView view;
    private final Camera camera;
    private final EditorState state;
    /** What is drawn together, if it is very much. */
    private final Map<Look, List<BodyAt>> many = new EnumMap<>(Look.class);
    private boolean areMany;

    Outlines(GraphicsContext g, EditorState state, Camera camera) {
        this.g = g;
        this.view = new CameraView(camera, g.getCanvas().getWidth(), g.getCanvas().getHeight());
        this.camera = camera;
        this.state = state;
    }

    /** What is selected: of an operation, or of one of its operands, what is taken away is a ghost. */
    void selected() {
        areMany = state.selection().size() > Strokes.MANY
                || Places.bodies(state.selection()).stream().mapToInt(at -> count(at.parent())).sum() > Strokes.MANY;
        for (ScenePath item : state.selection()) {
            if (item instanceof LightAt light && !state.isHidden(item)) {
                light(LightMoves.place(state.scene().lights().get(light.index())));
            } else if (item instanceof BodyAt at && !state.isHidden(item)) {
                if (at.in(state.scene()).operands().isEmpty()) {
                    siblings(at);
                    draw(at, Look.STRONG);
                } else {
                    operands(at, Optional.empty());
                }
            }
        }
        areMany = false;
        many.forEach((look, bodies) -> BodyOutline.draw(g, view::line, camera, state.scene(), bodies, look));
    }

    private int count(BodyAt at) {
        return at.find(state.scene()).map(Places::count).orElse(0);
    }

    private void siblings(BodyAt at) {
        if (at.depth() > 0) {
            operands(at.parent(), Optional.of(at));
        }
    }

    private void operands(BodyAt operation, Optional<BodyAt> without) {
        Scene scene = state.scene();
        IntStream.range(0, operation.in(scene).operands().size()).mapToObj(operation::child).filter(child -> !without.equals(Optional.of(child)) && !state.isHidden(child))
                .forEach(child -> draw(child, look(Arranging.role(scene, child))));
    }

    private static Look look(Optional<Role> role) {
        return role.map(known -> known == Role.CUTTER ? Look.CUTTER : known == Role.COMMON ? Look.COMMON : Look.BASE).orElse(Look.BASE);
    }

    void draw(BodyAt at, Look look) {
        if (!areMany && count(at) > Strokes.MANY) {
            BodyOutline.draw(g, view::line, camera, state.scene(), List.of(at), look);
        } else if (areMany) {
            many.computeIfAbsent(look, key -> new ArrayList<>()).add(at);
        } else {
            BodyOutline.draw(g, view::line, camera.position(), state.scene(), at, look);
        }
    }

    private void light(Vec3 place) {
        for (Segment at : view.line(place, place.plus(Vec3.Y.times(1e-6)))) {
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
        List<Segment> pieces = view.line(from, to);
        g.setLineDashes(6, 4);
        g.setLineWidth(1.5);
        g.setStroke(Color.web("#ffd33d"));
        pieces.forEach(piece -> g.strokeLine(piece.x1(), piece.y1(), piece.x2(), piece.y2()));
        g.setLineDashes();
    }
}
