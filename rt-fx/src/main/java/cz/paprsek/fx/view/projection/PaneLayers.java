package cz.paprsek.fx.view.projection;

import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.Places;
import cz.paprsek.fx.view.look.Layer;
import cz.paprsek.fx.view.look.Strokes;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.motion.OnionSkin;
import cz.paprsek.fx.view.projection.Grips.Grip;
import cz.paprsek.fx.view.rays.DrawnRays;
import cz.paprsek.fx.view.rays.RayPainter;
import cz.paprsek.fx.view.section.SectionSkin;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.geometry.BoundingBox;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.shape.Line;
import org.jspecify.annotations.Nullable;

/**
 * What a pane shows: what is selected, the signs of cameras, and handles are drawn on layers of their own above that of the rest, so that selecting and
 * dragging among ten thousand objects need not draw them all anew.
 */
final class PaneLayers {
    /** About a selection's box, so that it holds all handles, pixels. */
    private static final double AIR = 36;
    /** More than a line is wide, pixels. */
    private static final double LINE = 2;
    /** By how much a line may be elsewhere while it is dragged, pixels. */
    private static final double MISSED = 0.01;

    /** All on which the lowest layer depends, besides the objects. What a gesture changes is drawn above, and apart from the rest. */
    private record Look(Viewport view, Theme theme, Set<ScenePath> apart, Set<ScenePath> hidden) {}

    /**
     * Many bodies that a hand holds, as they have been drawn, all in sight: where they are only moved, all of the layer is.
     *
     * @param others what is selected besides
     * @param box around the bodies
     */
    private record Held(Scene scene, Set<ScenePath> selection, List<BodyAt> bodies, List<ScenePath> others, Viewport view, Box box) {}

    private final ProjectionPane pane;
    private final EditorModel model;
    private final Axes axes;
    private final Figures figures;
    private final Layer rest = Layer.named("rest");
    private final Layer selected = Layer.named("selected");
    private final Layer signs = Layer.named("signs");
    private final Layer grabbed = Layer.named("grabbed");
    /** Across the pane, one each way: on a layer they would have all of the pane painted anew, with all layers, whenever something is dragged along one of them. */
    private final List<Line> guides = List.of(guide(), guide());
    /** What is drawn besides the scene. */
    Optional<DrawnRays> rays = Optional.empty();
    Optional<BodyAt> highlighted = Optional.empty();
    Optional<OnionSkin> onion = Optional.empty();
    Optional<SectionSkin> section = Optional.empty();
    @Nullable Drag drag;
    Point2D mouse = Point2D.ZERO;
    private @Nullable Held held;
    /** The box of the handles, and of what state. */
    private Box handles = Box.EMPTY;
    private @Nullable EditorState handled;
    private @Nullable Look drawnLook;
    private Scene drawn = Scene.EMPTY;
    /** Whether that was while a hand moved something, so that more may be otherwise when it has ended. */
    private boolean isDrawnRoughly;

    /** @param figures of the pane, which show the scene whenever something is drawn */
    PaneLayers(ProjectionPane pane, Figures figures) {
        this.pane = pane;
        this.model = pane.model();
        this.axes = pane.axes();
        this.figures = figures;
    }

    private static Line guide() {
        Line line = new Line();
        line.getStyleClass().add("guide");
        line.getStrokeDashArray().setAll(4.0, 4.0);
        line.setStrokeWidth(1.5);
        line.setManaged(false);
        line.setMouseTransparent(true);
        line.setVisible(false);
        return line;
    }

    /** The lowest first. */
    List<Node> all() {
        return List.of(rest, selected, signs, guides.get(0), guides.get(1), grabbed);
    }

    void setSize(double width, double height) {
        List.of(rest, selected, signs, grabbed).forEach(layer -> layer.setSize(width, height));
    }

    /** The box of the handles; empty if there is nothing to resize. */
    @SuppressWarnings("ReferenceEquality")
    Box handleBox() {
        EditorState state = model.state();
        if (state != handled) {
            handled = state;
            handles = handleBox(pane.figures());
        }
        return handles;
    }

    private Box handleBox(Figures shown) {
        Set<ScenePath> items = pane.movable();
        boolean hasSize = items.stream().anyMatch(BodyAt.class::isInstance) || Places.lights(items).stream().filter(light -> light.isIn(model.scene()))
                .anyMatch(light -> !LightSketch.of(model.scene().lights().get(light.index()), axes).extent().isEmpty());
        return hasSize ? shown.box(items) : Box.EMPTY;
    }

    /** What has changed. */
    void draw() {
        EditorState state = model.state();
        Viewport view = pane.view();
        Set<ScenePath> apart = model.gesturingProperty().get() ? state.selection() : Set.of();
        Look look = new Look(view, pane.theme(), apart, state.hidden());
        if (!look.equals(drawnLook) || !figures.isLike(drawn, apart)) {
            Optional<Bounds> part = mendable(look);
            if (part.isPresent()) {
                rest.mend(part.get(), g -> rest(g, look, wider(part.get())));
            } else {
                rest.draw(new Object(), g -> rest(g, look, new BoundingBox(0, 0, view.width(), view.height())));
                isDrawnRoughly = model.gesturingProperty().get();
            }
            drawnLook = look;
            drawn = state.scene();
        }
        drawAbove(state, view);
    }

    /** As many lines are a picture whose edge is blurred where a pixel of the canvas is not one of the screen. */
    private static Bounds wider(Bounds part) {
        return new BoundingBox(part.getMinX() - LINE, part.getMinY() - LINE, part.getWidth() + 2 * LINE, part.getHeight() + 2 * LINE);
    }

    private void rest(GraphicsContext g, Look look, Bounds part) {
        Grid.draw(g, look.view, axes, look.theme.palette());
        new Painter(g, look.view, axes, look.theme.palette(), part).rest(look.hidden, look.apart, figures);
    }

    /** Where the lowest layer is otherwise if nothing has changed but a few things that are, or were, drawn apart; as when a drag begins or ends. Empty if it is to be drawn as a whole. */
    private Optional<Bounds> mendable(Look look) {
        Look before = drawnLook;
        OptionalInt size = Strokes.square(Strokes.pixels(rest));
        if (before == null || isDrawnRoughly || size.isEmpty() || !new Look(look.view, look.theme, before.apart, look.hidden).equals(before)) {
            return Optional.empty();
        }
        return figures.changed(drawn, before.apart, look.apart)
                .map(box -> box.isEmpty() ? new BoundingBox(0, 0, 0, 0) : Viewport.whole(look.view.around(List.of(look.view.of(box, LINE))), size.getAsInt()));
    }

    private void drawAbove(EditorState state, Viewport view) {
        Painter painter = new Painter(selected.getGraphicsContext2D(), view, axes, pane.theme().palette());
        boolean isAlone = section.filter(SectionSkin::isSeen).isEmpty() && onion.filter(OnionSkin::isSeen).isEmpty() && highlighted.isEmpty();
        boolean isInHand = isAlone && (drag != null || model.gesturingProperty().get());
        Held before = held;
        Optional<Vec3> moved = isInHand && before != null && view.equals(before.view) && state.selection().equals(before.selection)
                ? figures.movedSince(before.scene, before.bodies, MISSED / view.scale()) : Optional.empty();
        double byU = moved.map(axes::u).orElse(0.0);
        double byV = moved.map(axes::v).orElse(0.0);
        selected.setTranslateX(byU * view.scale());
        selected.setTranslateY(-byV * view.scale());
        Box box = before != null && moved.isPresent() ? before.box.moved(byU, byV).union(figures.box(before.others)) : figures.box(state.selection());
        if (moved.isPresent() && state.locked().isEmpty()) {
            handled = state;
            handles = box;
        }
        if (moved.isEmpty()) {
            held = isInHand ? held(state, view) : null;
            selected.draw(new Object(), g -> {
                section.ifPresent(skin -> skin.draw(g, pane.theme().palette(), axes.along(), pane::toPane));
                section.filter(skin -> skin.isHeld() && drag == null).flatMap(skin -> skin.line(axes.along())).ifPresent(line ->
                        Plate.beside(g, view, Drag.Cutting.figures(line, view, pane.texts().locale()), pane.toPane(Drag.Cutting.middle(line, axes, view)), pane.theme().palette()));
                onion.ifPresent(skin -> {
                    skin.passing((object, isSelected) -> painter.moment(figures.passing(object), isSelected));
                    skin.ways(g, pane.theme().palette(), pane::toPane);
                });
                highlighted.filter(body -> body.isIn(state.scene())).ifPresent(body -> painter.highlighted(figures.of(body)));
                if (!state.selection().isEmpty()) {
                    painter.selected(state, figures);
                }
            });
        }
        Box grabs = handleBox();
        List<Grip> grips = pane.grips();
        painter.avoid(state, grabs, grips);
        Painter above = painter.on(grabbed.getGraphicsContext2D());
        // Before the names of cameras, which may be many.
        Runnable name = !box.isEmpty() && view.shows(box) ? above.name(PathNames.of(state.scene(), state.selection(), pane.texts()), box) : () -> {};
        List<CameraSketch> cameras = IntStream.range(0, state.scene().cameras().size()).mapToObj(i -> CameraSketch.of(state.scene(), i)).toList();
        List<Bounds> letters = painter.taken().subList(0, 2);
        signs.draw(List.of(view, pane.theme(), letters, state.hidden(), state.eye(), cameras, Places.cameras(state.selection()), cameras.size() > 1 ? List.of(above.taken(), state.scene().cameras()) : 1), g -> {
            Grid.numbers(g, view, axes, pane.theme().palette(), pane.texts().locale(), letters);
            above.on(g).cameras(state, cameras, pane.texts());
        });
        grabbed.draw(new Object(), g -> {
            if (!state.selection().isEmpty()) {
                above.selectedLights(state);
                above.handles(grabs, true);
                name.run();
                above.grips(grips);
            }
            rays.ifPresent(RayPainter.on(g, pane.theme(), (from, to) -> List.of(segment(from, to, view)))::draw);
            if (drag != null) {
                drag.draw(g);
                Plate.beside(g, view, drag.figures(pane.texts().locale()), mouse, pane.theme().palette());
            }
        });
        drawGuides();
        List<Bounds> parts = new ArrayList<>(above.taken().subList(painter.taken().size(), above.taken().size()));
        Stream.concat(Stream.of(box, grabs), grips.stream().map(grip -> Box.EMPTY.with(axes.u(grip.place()), axes.v(grip.place()))))
                .filter(known -> !known.isEmpty()).forEach(known -> parts.add(view.of(known, AIR)));
        if (drag != null) {
            parts.add(Plate.besides(view, drag.figures(pane.texts().locale()), mouse));
        }
        Bounds part = held != null || figures.areWithinBoxes(state.selection()) ? view.around(parts) : pane.getLayoutBounds();
        selected.showOnly(held != null ? view.of(held.box, AIR) : isAlone ? part : pane.getLayoutBounds());
        grabbed.showOnly(rays.isPresent() || (drag != null && drag.isWide()) ? pane.getLayoutBounds() : part);
    }

    private void drawGuides() {
        List<Segment> lines = drag == null ? List.of() : drag.guides();
        for (int i = 0; i < guides.size(); i++) {
            Line guide = guides.get(i);
            guide.setVisible(i < lines.size());
            if (i < lines.size()) {
                Segment line = lines.get(i);
                guide.setStroke(pane.theme().palette().selected());
                guide.setStartX(line.x1());
                guide.setStartY(line.y1());
                guide.setEndX(line.x2());
                guide.setEndY(line.y2());
            }
        }
    }

    private @Nullable Held held(EditorState state, Viewport view) {
        List<BodyAt> bodies = Places.bodies(state.selection());
        Box box = figures.areMany(bodies) ? figures.box(bodies) : Box.EMPTY;
        return box.isEmpty() || !view.contains(box) ? null
                : new Held(state.scene(), state.selection(), bodies, state.selection().stream().filter(item -> !(item instanceof BodyAt)).toList(), view, box);
    }

    private Segment segment(Vec3 from, Vec3 to, Viewport view) {
        return new Segment(view.x(axes.u(from)), view.y(axes.v(from)), view.x(axes.u(to)), view.y(axes.v(to)));
    }
}
