package cz.paprsek.fx.view.camera;

import cz.paprsek.drawing.CameraView;
import cz.paprsek.drawing.Segment;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.edit.Arranging;
import cz.paprsek.fx.model.edit.LightMoves;
import cz.paprsek.math.Bounds;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.ScenePath;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import javafx.geometry.Point2D;
import javafx.scene.Cursor;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.paint.Color;

/** Selects all that lies wholly within a rubber band in a picture: after B, or with Ctrl and Shift. */
final class BandHand {
    private static final Color COLOR = Color.web("#ff9b3d");

    private final LivePicture picture;
    private final EditorModel model;
    private final Viewpoint view;
    private final Supplier<EditorState> shown;
    private boolean isArmed;
    private Optional<Point2D> start = Optional.empty();
    private Point2D now = Point2D.ZERO;

    /** @param shown the state that is in the picture, which may be that of another time */
    BandHand(LivePicture picture, EditorModel model, Viewpoint view, Supplier<EditorState> shown) {
        this.picture = picture;
        this.model = model;
        this.view = view;
        this.shown = shown;
    }

    void arm() {
        isArmed = true;
        picture.setCursor(Cursor.CROSSHAIR);
    }

    /** Whether it was armed, or drawn. */
    boolean disarm() {
        boolean was = isAwaited();
        if (was) {
            picture.setCursor(Cursor.DEFAULT);
        }
        isArmed = false;
        start = Optional.empty();
        return was;
    }

    /** Whether it is armed, or drawn. */
    boolean isAwaited() {
        return isArmed || start.isPresent();
    }

    /** Whether a band begins here. */
    boolean pressed(MouseEvent event, Point2D at) {
        boolean begins = event.getButton() == MouseButton.PRIMARY && (isArmed || (event.isShiftDown() && event.isShortcutDown()));
        if (begins) {
            start = Optional.of(at);
            now = at;
        }
        return begins;
    }

    /** Whether there is a band. */
    boolean isDrawn() {
        return start.isPresent();
    }

    /** Whether there is a band. */
    boolean dragged(Point2D at) {
        if (isDrawn()) {
            now = at;
            picture.overlay().repaint();
        }
        return isDrawn();
    }

    /** Selects what is within; whether there was a band. */
    boolean release() {
        Optional<Point2D> ended = start;
        ended.ifPresent(from -> {
            disarm();
            model.select(within(Math.min(from.getX(), now.getX()), Math.min(from.getY(), now.getY()), Math.max(from.getX(), now.getX()), Math.max(from.getY(), now.getY())));
            picture.overlay().repaint();
        });
        return ended.isPresent();
    }

    private Set<ScenePath> within(double left, double top, double right, double bottom) {
        EditorState state = shown.get();
        CameraView seen = new CameraView(view.camera(state), picture.overlay().getWidth(), picture.overlay().getHeight());
        Set<ScenePath> found = new LinkedHashSet<>();
        for (int i = 0; i < state.scene().objects().size(); i++) {
            ScenePath.BodyAt at = ScenePath.body(i);
            if (Arranging.box(state.scene(), at).filter(box -> corners(box).stream().allMatch(p -> isWithin(seen, p, left, top, right, bottom))).isPresent()) {
                found.add(at);
            }
        }
        for (int i = 0; i < state.scene().lights().size(); i++) {
            if (isWithin(seen, LightMoves.place(state.scene().lights().get(i)), left, top, right, bottom)) {
                found.add(ScenePath.light(i));
            }
        }
        found.removeIf(item -> state.isHidden(item) || state.isLocked(item));
        return found;
    }

    private static boolean isWithin(CameraView view, Vec3 p, double left, double top, double right, double bottom) {
        List<Segment> at = view.line(p, p.plus(new Vec3(1e-6, 1e-6, 1e-6)));
        return !at.isEmpty() && at.get(0).x1() >= left && at.get(0).x1() <= right && at.get(0).y1() >= top && at.get(0).y1() <= bottom;
    }

    private static List<Vec3> corners(Bounds b) {
        return List.of(new Vec3(b.minX(), b.minY(), b.minZ()), new Vec3(b.maxX(), b.minY(), b.minZ()), new Vec3(b.minX(), b.maxY(), b.minZ()), new Vec3(b.maxX(), b.maxY(), b.minZ()),
                new Vec3(b.minX(), b.minY(), b.maxZ()), new Vec3(b.maxX(), b.minY(), b.maxZ()), new Vec3(b.minX(), b.maxY(), b.maxZ()), new Vec3(b.maxX(), b.maxY(), b.maxZ()));
    }

    void draw(GraphicsContext g) {
        start.ifPresent(from -> {
            double x = Math.min(from.getX(), now.getX());
            double y = Math.min(from.getY(), now.getY());
            double width = Math.abs(from.getX() - now.getX());
            double height = Math.abs(from.getY() - now.getY());
            g.setFill(COLOR.deriveColor(0, 1, 1, 0.15));
            g.fillRect(x, y, width, height);
            g.setStroke(COLOR);
            g.setLineWidth(1);
            g.strokeRect(x + 0.5, y + 0.5, width, height);
        });
    }
}
