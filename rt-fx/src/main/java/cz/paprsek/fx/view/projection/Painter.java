package cz.paprsek.fx.view.projection;

import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.Arranging;
import cz.paprsek.fx.model.edit.Arranging.Role;
import cz.paprsek.fx.model.edit.LightMoves;
import cz.paprsek.fx.view.look.Palette;
import cz.paprsek.fx.view.look.Strokes;
import cz.paprsek.fx.view.projection.Grips.Grip;
import cz.paprsek.fx.view.texts.PathNames;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.ScenePath;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.geometry.BoundingBox;
import javafx.geometry.Bounds;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import javafx.scene.text.Font;

/** Draws figures, lights and cameras. */
final class Painter {
    private static final Font NAME_FONT = Font.font("System", 11);
    /** How far names of cameras are apart at least, pixels. */
    private static final double PLATE = 16;
    /** Of the sign of a camera, pixels. */
    private static final double CAMERA_HALF_WIDTH = 7;
    private static final double CAMERA_HALF_HEIGHT = 5;
    /** Smaller things are drawn as a dot, pixels. */
    private static final double DOT = 2.5;
    /** More than a line is wide, pixels. */
    private static final double LINE = 2;

    private final GraphicsContext g;
    private final Viewport view;
    private final Axes axes;
    private final Palette palette;
    private final List<Bounds> taken = new ArrayList<>();
    /** What is drawn of the pane, pixels. */
    private final Bounds part;

    Painter(GraphicsContext g, Viewport view, Axes axes, Palette palette) {
        this(g, view, axes, palette, new BoundingBox(0, 0, view.width(), view.height()));
    }

    /** @param part what is drawn of the pane, pixels */
    Painter(GraphicsContext g, Viewport view, Axes axes, Palette palette, Bounds part) {
        this.part = part;
        this.g = g;
        this.view = view;
        this.axes = axes;
        this.palette = palette;
    }

    /** On another canvas of the pane, where names keep off the same. */
    Painter on(GraphicsContext other) {
        Painter painter = new Painter(other, view, axes, palette);
        painter.taken.addAll(taken);
        return painter;
    }

    /** What names keep off. */
    List<Bounds> taken() {
        return List.copyOf(taken);
    }

    /** All objects and lights that are neither hidden nor drawn apart. */
    void rest(Set<ScenePath> hidden, Set<ScenePath> apart, Figures figures) {
        Set<ScenePath> without = new HashSet<>(hidden);
        without.addAll(apart);
        List<Figure> ghosts = new ArrayList<>();
        Strokes strokes = Strokes.on(g, part, 1.2, palette.outline(), figures.areMany());
        for (int i = 0; i < figures.count(); i++) {
            Figure figure = figures.of(i);
            if (isInSight(figure)) {
                trace(without, figure, ScenePath.body(i), strokes, ghosts);
                strokes.next();
            }
        }
        strokes.end();
        ghosts(ghosts, palette.ghost());
        Scene scene = figures.scene();
        for (int i = 0; i < scene.lights().size(); i++) {
            if (!without.contains(ScenePath.light(i))) {
                light(scene.lights().get(i), palette.light());
            }
        }
    }

    /** The objects that are selected. */
    void selected(EditorState state, Figures figures) {
        List<Figure> ghosts = new ArrayList<>();
        Strokes strokes = Strokes.on(g, part, 1.8, palette.selected(), state.selection().size() > Strokes.MANY);
        for (ScenePath item : state.selection()) {
            if (item instanceof ScenePath.BodyAt body && !state.isHidden(item) && figures.of(body).operands().isEmpty() && isInSight(figures.of(body))) {
                whole(figures.of(body), strokes, ghosts);
                strokes.next();
            }
        }
        strokes.end();
        ghosts(ghosts, palette.selected());
        operands(state, figures);
    }

    void selectedLights(EditorState state) {
        for (ScenePath item : state.selection()) {
            if (item instanceof ScenePath.LightAt light && !state.isHidden(item)) {
                light(state.scene().lights().get(light.index()), palette.selected());
            }
        }
    }

    /** Of operations, and beside operands, the operands by what they do, each once: as the tree colours them. */
    private void operands(EditorState state, Figures figures) {
        Map<ScenePath.BodyAt, Double> widths = new LinkedHashMap<>();
        for (ScenePath item : state.selection()) {
            if (item instanceof ScenePath.BodyAt body && !state.isHidden(item)) {
                boolean isOperation = !figures.of(body).operands().isEmpty();
                widths.merge(isOperation ? body : body.parent(), isOperation ? 1.8 : 1.2, Math::max);
            }
        }
        boolean areMany = widths.keySet().stream().filter(at -> !figures.of(at).operands().isEmpty()).mapToInt(at -> figures.of(at).count()).sum() > Strokes.MANY;
        Map<Pen, Strokes> many = new LinkedHashMap<>();
        widths.forEach((operation, width) -> {
            for (int i = 0; i < figures.of(operation).operands().size(); i++) {
                ScenePath.BodyAt operand = operation.child(i);
                if (!state.isHidden(operand) && !state.selection().contains(operand)) {
                    List<Figure> ghosts = new ArrayList<>();
                    Color color = color(Arranging.role(state.scene(), operand).orElse(Role.BASE));
                    Strokes strokes = areMany ? many.computeIfAbsent(new Pen(color, width), key -> Strokes.on(g, part, width, color, true))
                            : Strokes.on(g, part, width, color, false);
                    whole(figures.of(operand), strokes, ghosts);
                    strokes.next();
                    ghosts(ghosts, color);
                }
            }
        });
        many.values().forEach(Strokes::end);
    }

    /** What is drawn together. */
    private record Pen(Color color, double width) {}

    private Color color(Role role) {
        return switch (role) {
            case BASE -> palette.y();
            case CUTTER -> palette.x();
            case COMMON -> palette.z();
        };
    }

    /** What something that is dragged would be dropped on. */
    void highlighted(Figure figure) {
        List<Figure> ghosts = new ArrayList<>();
        Strokes strokes = Strokes.on(g, part, 3.5, palette.selected(), false);
        whole(figure, strokes, ghosts);
        strokes.next();
        ghosts(ghosts, palette.selected());
    }

    void handles(Box box, boolean canTurn) {
        if (box.isEmpty()) {
            return;
        }
        g.setLineWidth(1);
        g.setStroke(palette.selected());
        g.setFill(palette.background());
        if (canTurn) {
            g.strokeLine(Handle.TOP.x(view, box), Handle.TOP.y(view, box), Handle.TURN.x(view, box), Handle.TURN.y(view, box));
        }
        for (Handle handle : Handle.values()) {
            double x = Math.floor(handle.x(view, box)) + 0.5;
            double y = Math.floor(handle.y(view, box)) + 0.5;
            if (handle == Handle.TURN && canTurn) {
                g.fillOval(x - 4.5, y - 4.5, 9, 9);
                g.strokeOval(x - 4.5, y - 4.5, 9, 9);
            } else if (handle != Handle.TURN) {
                g.fillRect(x - 3, y - 3, 6, 6);
                g.strokeRect(x - 3, y - 3, 6, 6);
            }
        }
    }

    /** Keeps names off the letters of the axes, which come first and keep off signs, what is grabbed, and the signs of lights and cameras. */
    void avoid(EditorState state, Box handles, List<Grip> grips) {
        Scene scene = state.scene();
        List<Bounds> signs = Stream.concat(
                IntStream.range(0, scene.lights().size()).filter(i -> !state.isHidden(ScenePath.light(i))).mapToObj(i -> LightMoves.place(scene.lights().get(i)))
                        .map(place -> about(x(place), y(place), 9, 9)),
                IntStream.range(0, scene.cameras().size()).filter(i -> !state.isHidden(ScenePath.camera(i))).mapToObj(i -> scene.cameras().get(i).position())
                        .map(place -> about(x(place), y(place), CAMERA_HALF_WIDTH, CAMERA_HALF_HEIGHT))).toList();
        taken.addAll(Grid.letters(view, axes, signs));
        Stream.of(Handle.values()).filter(handle -> !handles.isEmpty()).forEach(handle -> taken.add(about(handle.x(view, handles), handle.y(view, handles), 4, 4)));
        grips.forEach(grip -> taken.add(about(x(grip.place()), y(grip.place()), 8, 8)));
        taken.addAll(signs);
    }

    private static Bounds about(double x, double y, double halfWidth, double halfHeight) {
        return new BoundingBox(x - halfWidth, y - halfHeight, 2 * halfWidth, 2 * halfHeight);
    }

    /** Keeps a place for a name beside a box, where there is one; run, it draws the name there. */
    Runnable name(String text, Box box) {
        Bounds thing = new BoundingBox(view.x(box.minU()), view.y(box.maxV()), view.x(box.maxU()) - view.x(box.minU()), view.y(box.minV()) - view.y(box.maxV()));
        return name(text, thing, 14, 36, palette.selected());
    }

    private Runnable name(String text, Bounds thing, double gap, double gapAbove, Color color) {
        Bounds size = Plate.size(NAME_FONT, text);
        return Plate.beside(view, size, thing, gap, gapAbove, taken).<Runnable>map(at -> {
            taken.add(Plate.ground(size, at));
            return () -> Plate.draw(g, view, NAME_FONT, text, at, color, palette.background());
        }).orElse(() -> {});
    }

    /** Where something that moves is at another time. */
    void moment(Figure figure, boolean isSelected) {
        g.setGlobalAlpha(0.7);
        g.setLineDashes(2, 3);
        Strokes strokes = Strokes.on(g, part, 1, isSelected ? palette.selected() : palette.outline(), false);
        whole(figure, strokes, new ArrayList<>());
        strokes.next();
        g.setLineDashes();
        g.setGlobalAlpha(1);
    }

    private boolean isInSight(Figure figure) {
        Box box = figure.box();
        return box.isEmpty() || (view.x(box.maxU()) >= part.getMinX() - LINE && view.x(box.minU()) <= part.getMaxX() + LINE
                && view.y(box.minV()) >= part.getMinY() - LINE && view.y(box.maxV()) <= part.getMaxY() + LINE);
    }

    /** Adds a figure to the path, without parts that are hidden or drawn apart. */
    private void trace(Set<ScenePath> without, Figure figure, ScenePath.BodyAt item, Strokes strokes, List<Figure> ghosts) {
        if (without.contains(item)) {
            return;
        }
        if (figure.operands().isEmpty()) {
            leaf(figure, strokes, ghosts);
        }
        for (int i = 0; i < figure.operands().size(); i++) {
            trace(without, figure.operands().get(i), item.child(i), strokes, ghosts);
        }
    }

    private void whole(Figure figure, Strokes strokes, List<Figure> ghosts) {
        if (figure.operands().isEmpty()) {
            leaf(figure, strokes, ghosts);
        }
        figure.operands().forEach(operand -> whole(operand, strokes, ghosts));
    }

    private void leaf(Figure figure, Strokes strokes, List<Figure> ghosts) {
        if (figure.ghost()) {
            ghosts.add(figure);
        } else if (!figure.box().isEmpty() && Math.max(figure.box().width(), figure.box().height()) * view.scale() < DOT) {
            double x = view.x(figure.box().centreU());
            double y = view.y(figure.box().centreV());
            strokes.moveTo(x - 0.7, y);
            strokes.lineTo(x + 0.7, y);
        } else if (figure.box().isEmpty() || !strokes.hides(view.x(figure.box().minU()) - LINE, view.y(figure.box().maxV()) - LINE,
                view.x(figure.box().maxU()) + LINE, view.y(figure.box().minV()) + LINE)) {
            lines(figure, strokes);
        }
    }

    /** Adds the lines of a figure to the path; of a small one, only as many points as can be told apart. */
    private void lines(Figure figure, Strokes strokes) {
        double size = figure.box().isEmpty() ? Double.POSITIVE_INFINITY
                : Math.max(figure.box().width(), figure.box().height()) * view.scale();
        for (double[] line : figure.lines()) {
            int stride = 2 * Math.max(1, (int) (line.length / 2.0 / (4 + size)));
            strokes.moveTo(view.x(line[0] + figure.byU()), view.y(line[1] + figure.byV()));
            for (int i = stride; i < line.length - 2; i += stride) {
                strokes.lineTo(view.x(line[i] + figure.byU()), view.y(line[i + 1] + figure.byV()));
            }
            strokes.lineTo(view.x(line[line.length - 2] + figure.byU()), view.y(line[line.length - 1] + figure.byV()));
        }
    }

    private void ghosts(List<Figure> ghosts, Color color) {
        if (ghosts.isEmpty()) {
            return;
        }
        g.setLineDashes(4, 3);
        Strokes strokes = Strokes.on(g, part, 1, color, false);
        ghosts.forEach(ghost -> lines(ghost, strokes));
        strokes.next();
        g.setLineDashes();
    }

    private void light(Light light, Color color) {
        LightSketch sketch = LightSketch.of(light, axes);
        g.setStroke(color);
        g.setLineWidth(1.2);
        sketch.extent().forEach(this::polyline);
        g.setGlobalAlpha(0.55);
        g.setLineWidth(1);
        sketch.way().forEach(this::polyline);
        g.setGlobalAlpha(1);
        LightSketch.sign(g, light, x(sketch.place()), y(sketch.place()), color);
    }

    private void polyline(List<Vec3> points) {
        g.beginPath();
        g.moveTo(x(points.get(0)), y(points.get(0)));
        points.forEach(point -> g.lineTo(x(point), y(point)));
        g.stroke();
    }

    /** A cross for what something looks or shines at, dots for numbers to be pulled. */
    void grips(List<Grip> grips) {
        g.setStroke(palette.selected());
        g.setFill(palette.background());
        g.setLineWidth(1.5);
        for (Grip grip : grips) {
            if (grip instanceof Grip.Aim) {
                cross(grip.place());
            } else {
                g.fillOval(x(grip.place()) - 4, y(grip.place()) - 4, 8, 8);
                g.strokeOval(x(grip.place()) - 4, y(grip.place()) - 4, 8, 8);
            }
        }
    }

    private void cross(Vec3 place) {
        double x = x(place);
        double y = y(place);
        g.strokeOval(x - 5, y - 5, 10, 10);
        g.strokeLine(x - 8, y, x + 8, y);
        g.strokeLine(x, y - 8, x, y + 8);
    }

    /** All cameras; the one looked through is drawn last, above the others. */
    void cameras(EditorState state, List<CameraSketch> sketches, Texts texts) {
        int count = sketches.size();
        for (int i = 1; i <= count; i++) {
            int camera = (state.eye() + i) % count;
            if (!state.isHidden(ScenePath.camera(camera))) {
                camera(state, camera, sketches.get(camera), count > 1 && !isCovered(state, camera) ? PathNames.of(state.scene(), ScenePath.camera(camera), texts) : "");
            }
        }
    }

    /** Whether another camera stands so near that its name would lie on this one's: that of the one looked through, or selected, or first. */
    private boolean isCovered(EditorState state, int camera) {
        Vec3 own = state.scene().cameras().get(camera).position();
        return camera != state.eye() && IntStream.range(0, state.scene().cameras().size())
                .filter(i -> i == state.eye() || i < camera || state.selection().contains(ScenePath.camera(i)))
                .filter(i -> i != camera && !state.isHidden(ScenePath.camera(i))).mapToObj(i -> state.scene().cameras().get(i).position())
                .anyMatch(other -> Math.hypot(x(other) - x(own), y(other) - y(own)) < PLATE);
    }

    /**
     * A camera and what it sees. All but those selected or looked through are thin.
     *
     * @param name beside it; empty for none
     */
    private void camera(EditorState state, int index, CameraSketch sketch, String name) {
        boolean isSelected = state.selection().contains(ScenePath.camera(index));
        boolean isThin = !isSelected && index != state.eye();
        double x = x(sketch.eye());
        double y = y(sketch.eye());
        g.setStroke(isSelected ? palette.selected() : palette.camera());
        g.setLineWidth(isThin ? 0.7 : 1);
        g.setGlobalAlpha(isSelected ? 1 : isThin ? 0.3 : 0.55);
        sketch.lines().forEach(this::polyline);
        g.setLineDashes(5, 3);
        sketch.lens().forEach(this::polyline);
        g.setLineDashes();
        g.setGlobalAlpha(1);
        g.setLineWidth(isThin ? 1 : 1.5);
        g.setFill(palette.background());
        g.fillRect(x - CAMERA_HALF_WIDTH, y - CAMERA_HALF_HEIGHT, 2 * CAMERA_HALF_WIDTH, 2 * CAMERA_HALF_HEIGHT);
        g.strokeRect(x - CAMERA_HALF_WIDTH, y - CAMERA_HALF_HEIGHT, 2 * CAMERA_HALF_WIDTH, 2 * CAMERA_HALF_HEIGHT);
        g.strokeOval(x - 3, y - 3, 6, 6);
        if (!isSelected && !name.isEmpty() && x >= 0 && x <= view.width() && y >= 0 && y <= view.height()) {
            name(name, about(x, y, 0, 0), 14, 14, palette.camera()).run();
        }
    }

    private double x(Vec3 p) {
        return view.x(axes.u(p));
    }

    private double y(Vec3 p) {
        return view.y(axes.v(p));
    }
}
