package cz.paprsek.fx.view.section;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.fx.model.edit.CutPlane;
import cz.paprsek.fx.model.edit.Visible;
import cz.paprsek.fx.model.section.CutFace;
import cz.paprsek.fx.view.look.Palette;
import cz.paprsek.material.Material;
import cz.paprsek.material.Pattern;
import cz.paprsek.material.Rgb;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Solid;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Function;
import javafx.beans.InvalidationListener;
import javafx.beans.WeakInvalidationListener;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.Point2D;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.paint.Color;
import javafx.scene.shape.FillRule;

/**
 * The plane that solids are cut open by, in projections: where one looks along its axis, what of the solids lies in it; from the side, the plane as a line, and paler what is taken away beyond it. One for all that draw it.
 */
public final class SectionSkin {
    /** How many squares are asked in all, so that a hand is followed; of each solid at least and at most so many along its longer side. */
    private static final double ALL = 24_000;
    private static final int LEAST = 8;
    private static final int MOST = 44;

    private final EditorModel model;
    private final ObjectProperty<Optional<CutPlane>> plane;
    /** Where the plane was when a hand took hold of it; empty if none has. */
    private final ObjectProperty<Optional<CutPlane>> start = new SimpleObjectProperty<>(Optional.empty());
    private final IdentityHashMap<SceneObject, Face> faces = new IdentityHashMap<>();
    private Scene known = Scene.EMPTY;
    private Set<ScenePath> hidden = Set.of();
    private Optional<CutPlane> knownPlane = Optional.empty();
    private OptionalDouble place = OptionalDouble.empty();
    private List<Seen> drawn = List.of();

    /** The face of one object where the plane was when that was looked for. */
    private record Face(double place, Axis axis, int squares, CutFace face) {}

    /** A face, of the colour that its object has now: a named material may become another while the object stays the same. */
    private record Seen(CutFace face, Color color) {}

    /**
     * What is seen of the plane from the side.
     *
     * @param axis across which the plane is
     * @param place of the plane along it
     */
    public record Line(Axis axis, double place) {}

    public SectionSkin(EditorModel model, ObjectProperty<Optional<CutPlane>> plane) {
        this.model = model;
        this.plane = plane;
        // What is held is a plane across one axis: across another it is another plane.
        plane.addListener((property, old, now) -> start.set(start.get().filter(held -> now.filter(cut -> cut.axis() == held.axis()).isPresent())));
    }

    /** Is told when the plane is another one, or held; to be held by whoever listens. */
    public void follow(InvalidationListener listener) {
        plane.addListener(new WeakInvalidationListener(listener));
        start.addListener(new WeakInvalidationListener(listener));
    }

    /** The line in which the plane is seen; empty if there is none, or it is not seen from the side. */
    public Optional<Line> line(Vec3 along) {
        look();
        return place.isEmpty() ? Optional.empty()
                : knownPlane.map(CutPlane::axis).filter(axis -> axis.of(along) == 0).map(axis -> new Line(axis, place.getAsDouble()));
    }

    /** Whether there is a plane. */
    public boolean isSeen() {
        return plane.get().isPresent();
    }

    /** Whether a hand holds the plane. */
    public boolean isHeld() {
        return start.get().isPresent();
    }

    /** Takes hold of the plane. */
    public void take() {
        start.set(plane.get());
    }

    /** Leaves the plane where it is. */
    public void letGo() {
        start.set(Optional.empty());
    }

    /** Puts the plane back where it was when it was taken hold of. */
    public void putBack() {
        start.get().ifPresent(before -> plane.set(Optional.of(before)));
        letGo();
    }

    /** Moves the plane along its axis. */
    public void moveTo(double where) {
        plane.set(plane.get().map(cut -> cut.at(Visible.of(model.state()).scene(), where)));
    }

    /**
     * Draws it.
     *
     * @param along where the viewer looks: along an axis of the world
     * @param to where on the canvas a point of the world is
     */
    public void draw(GraphicsContext g, Palette palette, Vec3 along, Function<Vec3, Point2D> to) {
        look();
        Optional<CutPlane> cut = knownPlane;
        if (cut.isEmpty() || place.isEmpty()) {
            return;
        }
        Axis axis = cut.get().axis();
        if (axis.of(along) == 0) {
            line(g, palette, axis, to);
        } else {
            g.setFill(palette.background());
            g.setGlobalAlpha(0.5);
            g.fillRect(0, 0, g.getCanvas().getWidth(), g.getCanvas().getHeight());
            g.setGlobalAlpha(1);
            drawn.forEach(face -> face(g, palette, face, to));
        }
    }

    /** What has not changed keeps its face. */
    @SuppressWarnings("ReferenceEquality")
    private void look() {
        Optional<CutPlane> now = plane.getValue();
        EditorState state = model.state();
        if (now.equals(knownPlane) && (now.isEmpty() || (state.scene() == known && state.hidden().equals(hidden)))) {
            return;
        }
        knownPlane = now;
        known = state.scene();
        hidden = state.hidden();
        Scene scene = now.isEmpty() ? known : Visible.of(state).scene();
        place = now.map(cut -> cut.place(scene)).orElse(OptionalDouble.empty());
        drawn = place.isEmpty() ? List.of() : faces(scene, now.orElseThrow().axis(), place.getAsDouble());
    }

    private List<Seen> faces(Scene scene, Axis axis, double at) {
        int squares = (int) Math.max(LEAST, Math.min(MOST, Math.sqrt(ALL / Math.max(1, scene.objects().size()))));
        List<Seen> found = new ArrayList<>();
        IdentityHashMap<SceneObject, Face> before = new IdentityHashMap<>(faces);
        faces.clear();
        for (int i = 0; i < scene.objects().size(); i++) {
            SceneObject object = scene.objects().get(i);
            if (object.shape() instanceof Solid && !object.hidden()) {
                Face old = before.get(object);
                Face face = old != null && old.place == at && old.axis == axis && old.squares == squares ? old
                        : new Face(at, axis, squares, CutFace.of(ScenePath.body(i).placed(scene), axis, at, squares));
                faces.put(object, face);
                found.add(new Seen(face.face(), color(ScenePath.body(i).material(scene))));
            }
        }
        return found;
    }

    /** Its own, if it is one; grey for patterns. */
    private static Color color(Material material) {
        Rgb color = material.pattern() instanceof Pattern.Plain plain ? plain.color() : new Rgb(128, 128, 128);
        return Color.color(color.red() / 255, color.green() / 255, color.blue() / 255, 0.55);
    }

    private static void face(GraphicsContext g, Palette palette, Seen face, Function<Vec3, Point2D> to) {
        if (face.face().outlines().isEmpty()) {
            return;
        }
        g.beginPath();
        for (List<Vec3> outline : face.face().outlines()) {
            Point2D first = to.apply(outline.get(0));
            g.moveTo(first.getX(), first.getY());
            outline.stream().skip(1).map(to).forEach(point -> g.lineTo(point.getX(), point.getY()));
            g.closePath();
        }
        g.setFillRule(FillRule.EVEN_ODD);
        g.setFill(face.color());
        g.fill();
        g.setStroke(palette.outline());
        g.setLineWidth(2);
        g.stroke();
    }

    /** The line in which the plane is seen, and a veil over what lies farther along its axis. */
    private void line(GraphicsContext g, Palette palette, Axis axis, Function<Vec3, Point2D> to) {
        double width = g.getCanvas().getWidth();
        double height = g.getCanvas().getHeight();
        Vec3 on = axis.times(place.getAsDouble());
        Point2D a = to.apply(on);
        Point2D farther = to.apply(on.plus(axis.times(1)));
        boolean isUpright = Math.abs(farther.getX() - a.getX()) > Math.abs(farther.getY() - a.getY());
        double x = Math.max(0, Math.min(width, a.getX()));
        double y = Math.max(0, Math.min(height, a.getY()));
        g.setFill(palette.background());
        g.setGlobalAlpha(0.65);
        if (isUpright) {
            g.fillRect(farther.getX() > a.getX() ? x : 0, 0, farther.getX() > a.getX() ? width - x : x, height);
        } else {
            g.fillRect(0, farther.getY() > a.getY() ? y : 0, width, farther.getY() > a.getY() ? height - y : y);
        }
        g.setGlobalAlpha(1);
        g.setStroke(palette.camera());
        g.setLineWidth(isHeld() ? 2.5 : 1.5);
        g.setLineDashes(8, isHeld() ? 0 : 4);
        if (isUpright) {
            g.strokeLine(a.getX(), 0, a.getX(), height);
        } else {
            g.strokeLine(0, a.getY(), width, a.getY());
        }
        g.setLineDashes();
    }
}
