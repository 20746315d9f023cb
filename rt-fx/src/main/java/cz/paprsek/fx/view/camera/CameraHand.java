package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.model.edit.CameraMoves;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.RenderScene.Pick;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Camera.Target;
import javafx.animation.PauseTransition;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.util.Duration;
import org.jspecify.annotations.Nullable;

/**
 * Moves the camera by mouse and keys over its picture: dragging orbits, with Shift or the middle button it pans, with Ctrl or the right
 * button it dollies, as the wheel does. A drag, and a turn of the wheel without pause, is one step of the history; Escape cancels it.
 */
final class CameraHand {
    private static final double CLICK_SLACK = 4;
    private static final double DEGREES_PER_PIXEL = 0.4;
    private static final double NEARER_PER_PIXEL = 0.006;
    private static final double NEARER_PER_NOTCH = 0.12;
    /** What a key does, in pixels of a drag. */
    private static final double KEY_PIXELS = 12.5;
    /** A wheel at rest this long has ended its turn. */
    private static final Duration WHEEL_REST = Duration.millis(400);

    private final LivePicture picture;
    private final Viewpoint view;
    private final PauseTransition wheelRest = new PauseTransition(WHEEL_REST);
    private Runnable onLocked = () -> {};
    private @Nullable Drag drag;
    private Viewpoint.@Nullable Move wheel;
    private double wheelNotches;
    private Vec3 wheelPivot = Vec3.ZERO;

    private enum Kind { ORBIT, PAN, DOLLY }

    /** A button held down. */
    private static final class Drag {
        final Kind kind;
        final double x;
        final double y;
        final Vec3 pivot;
        /** Whether the mouse has gone far enough for more than a click, also with a camera that is locked. */
        boolean hasGone;
        Viewpoint.@Nullable Move move;

        Drag(Kind kind, double x, double y, Vec3 pivot) {
            this.kind = kind;
            this.x = x;
            this.y = y;
            this.pivot = pivot;
        }
    }

    CameraHand(LivePicture picture, Viewpoint view) {
        this.picture = picture;
        this.view = view;
        picture.setFocusTraversable(true);
        picture.setOnMousePressed(this::pressed);
        picture.setOnMouseDragged(this::dragged);
        picture.setOnScroll(this::scrolled);
        picture.setOnKeyPressed(this::key);
        wheelRest.setOnFinished(event -> endWheel());
    }

    /** Ends a drag; whether it was one, or began elsewhere, rather than a click. */
    boolean release(MouseEvent event) {
        // A quick hand on a busy machine may be told of only here.
        dragged(event);
        Drag ended = drag;
        drag = null;
        if (ended != null && ended.move != null) {
            ended.move.commit();
        }
        return ended == null || ended.hasGone;
    }

    /** Forgets a button held down: somebody else has made use of it. */
    void forget() {
        drag = null;
    }

    private void pressed(MouseEvent event) {
        picture.requestFocus();
        endWheel();
        if (drag == null) {
            drag = new Drag(kind(event), event.getX(), event.getY(), pivot());
        }
        event.consume();
    }

    private void dragged(MouseEvent event) {
        Drag now = drag;
        event.consume();
        if (now == null) {
            return;
        }
        double right = event.getX() - now.x;
        double down = event.getY() - now.y;
        Viewpoint.Move move = now.move;
        if (move == null) {
            now.hasGone = now.hasGone || Math.hypot(right, down) >= CLICK_SLACK;
            if (!now.hasGone || isLocked()) {
                return;
            }
            move = view.begin();
            now.move = move;
        }
        move.preview(camera -> moved(camera, now.kind, now.pivot, right, down));
    }

    private void scrolled(ScrollEvent event) {
        event.consume();
        if (event.getDeltaY() == 0 || drag != null || isLocked()) {
            return;
        }
        Viewpoint.Move move = wheel;
        if (move == null || !move.isOpen()) {
            move = view.begin();
            wheel = move;
            wheelNotches = 0;
            wheelPivot = pivot();
        }
        wheelNotches += event.getDeltaY() / 40;
        double factor = Math.exp(-NEARER_PER_NOTCH * wheelNotches);
        move.preview(camera -> CameraMoves.dollied(camera, wheelPivot, factor));
        wheelRest.playFromStart();
    }

    private void endWheel() {
        wheelRest.stop();
        if (wheel != null) {
            wheel.commit();
            wheel = null;
        }
    }

    private void key(KeyEvent event) {
        if (event.getCode() == KeyCode.ESCAPE && drag != null && drag.move != null) {
            drag.move.cancel();
            event.consume();
            return;
        }
        double right = switch (event.getCode()) {
            case LEFT -> -KEY_PIXELS;
            case RIGHT -> KEY_PIXELS;
            default -> 0;
        };
        double down = switch (event.getCode()) {
            case UP, PLUS, ADD, EQUALS -> -KEY_PIXELS;
            case DOWN, MINUS, SUBTRACT -> KEY_PIXELS;
            default -> 0;
        };
        boolean isMove = right != 0 || down != 0;
        if (!isMove || event.isShortcutDown() || event.isAltDown() || drag != null) {
            return;
        }
        event.consume();
        if (isLocked()) {
            return;
        }
        endWheel();
        Kind kind = !event.getCode().isArrowKey() ? Kind.DOLLY : event.isShiftDown() ? Kind.PAN : Kind.ORBIT;
        Vec3 pivot = pivot();
        view.change(camera -> moved(camera, kind, pivot, right, down));
    }

    /** Is told when the camera should move, but is locked. */
    void setOnLocked(Runnable listener) {
        onLocked = listener;
    }

    /** Tells that the camera is locked. */
    void tellLocked() {
        onLocked.run();
    }

    private boolean isLocked() {
        boolean locked = view.isLocked();
        if (locked) {
            tellLocked();
        }
        return locked;
    }

    /** The scene follows the mouse; the camera therefore goes the other way. */
    private Camera moved(Camera camera, Kind kind, Vec3 pivot, double right, double down) {
        return switch (kind) {
            case ORBIT -> CameraMoves.orbited(camera, pivot, -DEGREES_PER_PIXEL * right, DEGREES_PER_PIXEL * down);
            case PAN -> {
                double distance = pivot.minus(camera.position()).dot(camera.forward());
                double perPixel = CameraMoves.heightAt(camera, distance) / picture.frameHeight();
                yield CameraMoves.panned(camera, -perPixel * right, perPixel * down);
            }
            case DOLLY -> CameraMoves.dollied(camera, pivot, Math.exp(NEARER_PER_PIXEL * down));
        };
    }

    private static Kind kind(MouseEvent event) {
        if (event.getButton() == MouseButton.SECONDARY || event.isShortcutDown()) {
            return Kind.DOLLY;
        }
        return event.getButton() == MouseButton.MIDDLE || event.isShiftDown() ? Kind.PAN : Kind.ORBIT;
    }

    /** What the camera looks at: its target, or the surface in the middle of the picture, or else the point nearest to the world's origin. */
    private Vec3 pivot() {
        Camera camera = view.camera();
        if (camera.aim() instanceof Target target) {
            return target.point();
        }
        double distance = picture.middle().flatMap(PicturePoint::pick).map(Pick::distance)
                .orElseGet(() -> camera.position().negated().dot(camera.forward()));
        return camera.position().plus(camera.forward().times(distance > 0 ? distance : 1));
    }
}
