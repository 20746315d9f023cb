package cz.paprsek.fx.view.camera;

import cz.paprsek.fx.view.picture.Framing;
import cz.paprsek.fx.view.picture.RegionBand;
import cz.paprsek.render.Tile;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.ObservableValue;
import javafx.beans.value.WeakChangeListener;
import javafx.geometry.Point2D;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;

/**
 * Shows which part of the camera's picture is to be rendered alone, in pixels of the picture that it will be. Once asked for, a drag draws it and arrow keys move it, with
 * Shift by ten pixels, with Alt its far corner; Enter leaves it. Escape gives up what is drawn, then the rectangle.
 */
final class RegionHand {
    private static final double SLACK = 3;
    private static final int LEAP = 10;

    private final LivePicture picture;
    private final Consumer<Optional<Tile>> onRegion;
    /** Held here, because the framing, which may outlive the view, holds it weakly. */
    private final ChangeListener<Framing> onFraming = (property, old, now) -> show(now);
    private RegionBand band = new RegionBand(1, 1);
    private boolean isArmed;
    private boolean isDrawn;
    /** Whether Enter has ended a drag whose button is still held down. */
    private boolean isOver;
    private Point2D pressed = Point2D.ZERO;

    /**
     * @param pane the view around the picture, whose events it has first
     * @param onRegion is told of a part that has been drawn or moved, and of none when that is given up
     */
    RegionHand(Node pane, LivePicture picture, ObservableValue<Framing> framing, Consumer<Optional<Tile>> onRegion) {
        this.picture = picture;
        this.onRegion = onRegion;
        pane.addEventFilter(MouseEvent.MOUSE_PRESSED, this::pressed);
        pane.addEventFilter(MouseEvent.MOUSE_DRAGGED, this::dragged);
        pane.addEventFilter(MouseEvent.MOUSE_RELEASED, this::released);
        pane.addEventFilter(KeyEvent.KEY_PRESSED, this::key);
        pane.addEventHandler(KeyEvent.KEY_PRESSED, event -> {
            // By who has no other use for it.
            if (event.getCode() == KeyCode.ESCAPE && framing.getValue().part().isPresent()) {
                onRegion.accept(Optional.empty());
                event.consume();
            }
        });
        framing.addListener(new WeakChangeListener<>(onFraming));
        show(framing.getValue());
    }

    /** Has the next drag draw it. */
    void arm() {
        isArmed = true;
        picture.setCursor(Cursor.CROSSHAIR);
        picture.requestFocus();
    }

    /** Has drags do again what they did; what is being drawn is given up. */
    void disarm() {
        if (band.isDragging()) {
            band.giveUp();
        }
        isArmed = false;
        isDrawn = false;
        picture.setCursor(Cursor.DEFAULT);
    }

    /** Gives up what is drawn, or else the rectangle, if it was asked for; whether it was. */
    boolean giveUp() {
        boolean was = isArmed;
        if (was && band.isDragging()) {
            band.giveUp();
        } else if (was) {
            disarm();
            onRegion.accept(Optional.empty());
        }
        return was;
    }

    private void show(Framing now) {
        if (band.columns() != now.columns() || band.rows() != now.rows()) {
            RegionBand fresh = new RegionBand(now.columns(), now.rows());
            fresh.regionProperty().addListener((property, old, part) -> picture.requestLayout());
            picture.setBand(fresh);
            band = fresh;
        }
        band.show(now.part());
    }

    private Point2D pixel(MouseEvent event) {
        Point2D at = picture.sceneToLocal(event.getSceneX(), event.getSceneY());
        return picture.inFrame(at.getX(), at.getY()).multiply(1 / picture.zoom(band.columns()));
    }

    private void pressed(MouseEvent event) {
        isOver = isOver && event.getButton() != MouseButton.PRIMARY;
        if (isArmed && event.getButton() == MouseButton.PRIMARY) {
            picture.requestFocus();
            pressed = new Point2D(event.getSceneX(), event.getSceneY());
            isDrawn = false;
            band.begin(pixel(event));
            event.consume();
        }
    }

    private void dragged(MouseEvent event) {
        if (isOver) {
            event.consume();
        }
        if (isArmed && band.isDragging()) {
            isDrawn = isDrawn || pressed.distance(event.getSceneX(), event.getSceneY()) > SLACK;
            if (isDrawn) {
                band.drag(pixel(event));
            }
            event.consume();
        }
    }

    private void released(MouseEvent event) {
        if (isOver && event.getButton() == MouseButton.PRIMARY) {
            isOver = false;
            event.consume();
        } else if (isArmed && event.getButton() == MouseButton.PRIMARY) {
            // A quick hand on a busy machine may be told of only here.
            dragged(event);
            take();
            event.consume();
        }
    }

    /** Ends what is being drawn; if it is something, it counts from now on. */
    private void take() {
        boolean isTaken = isDrawn && band.isDragging();
        band.end();
        if (isTaken) {
            disarm();
            onRegion.accept(band.regionProperty().get());
        }
    }

    private void key(KeyEvent event) {
        if (!isArmed) {
            return;
        }
        switch (event.getCode()) {
            case LEFT -> nudge(event, -1, 0);
            case RIGHT -> nudge(event, 1, 0);
            case UP -> nudge(event, 0, -1);
            case DOWN -> nudge(event, 0, 1);
            case ENTER -> {
                isOver = band.isDragging();
                take();
                disarm();
            }
            default -> {
                return;
            }
        }
        event.consume();
    }

    private void nudge(KeyEvent event, int x, int y) {
        int far = event.isShiftDown() ? LEAP : 1;
        band.nudge(far * x, far * y, event.isAltDown());
        onRegion.accept(band.regionProperty().get());
    }
}
