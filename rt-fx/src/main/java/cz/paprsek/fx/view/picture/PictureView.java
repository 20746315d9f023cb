package cz.paprsek.fx.view.picture;

import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.beans.property.ReadOnlyDoubleWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.Point2D;
import javafx.scene.Cursor;
import javafx.scene.image.ImageView;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import javafx.scene.paint.ImagePattern;
import javafx.scene.shape.Rectangle;

/**
 * A picture to look at closely: the wheel zooms about the mouse, dragging pans, and a second picture of the same view can be laid over its
 * right part, up to a line that is dragged. Points are told in pixels of the picture, with fractions.
 */
public final class PictureView extends Region {
    private static final double LEAST_ZOOM = 1.0 / 32;
    private static final double MOST_ZOOM = 64;
    private static final double STEP = Math.sqrt(2);
    /** From this zoom on pixels are shown as squares. */
    private static final double SQUARES = 3;
    private static final double CLICK_SLACK = 3;
    private static final double NUDGE = 40;
    private static final int SQUARE = 8;

    private final PictureBuffer buffer;
    private final Rectangle checks = new Rectangle();
    private final ImageView picture;
    private final ImageView other = new ImageView();
    private final Rectangle otherPart = new Rectangle();
    private final Region wipe = new Region();
    private final ReadOnlyDoubleWrapper zoom = new ReadOnlyDoubleWrapper(1);
    private final ReadOnlyObjectWrapper<Optional<Point2D>> pointed = new ReadOnlyObjectWrapper<>(Optional.empty());
    private final ObjectProperty<Consumer<Point2D>> onClicked = new SimpleObjectProperty<>(point -> {});
    private double left;
    private double top;
    private boolean fits = true;
    private double wipeShare = 0.5;
    private Point2D pressed = Point2D.ZERO;
    private Point2D dragged = Point2D.ZERO;

    public PictureView(PictureBuffer buffer) {
        this.buffer = buffer;
        this.picture = new ImageView(buffer.image());
        getStyleClass().add("picture-view");
        wipe.getStyleClass().add("wipe");
        wipe.setCursor(Cursor.H_RESIZE);
        wipe.setVisible(false);
        other.setClip(otherPart);
        other.setVisible(false);
        other.setMouseTransparent(true);
        Rectangle clip = new Rectangle();
        clip.widthProperty().bind(widthProperty());
        clip.heightProperty().bind(heightProperty());
        setClip(clip);
        checks.setFill(checkered());
        checks.setVisible(false);
        checks.setMouseTransparent(true);
        getChildren().addAll(checks, picture, other, wipe);
        setFocusTraversable(true);
        setOnScroll(this::scrolled);
        setOnMousePressed(this::pressed);
        setOnMouseDragged(this::dragged);
        setOnMouseReleased(this::released);
        setOnMouseMoved(event -> pointed.set(toPicture(event.getX(), event.getY())));
        setOnMouseExited(event -> pointed.set(Optional.empty()));
        setOnKeyPressed(this::key);
        wipe.setOnMouseDragged(event -> {
            wipeShare = Math.max(0, Math.min(1, (sceneToLocal(event.getSceneX(), event.getSceneY()).getX() - left) / shownWidth()));
            requestLayout();
            event.consume();
        });
        wipe.setOnMousePressed(MouseEvent::consume);
        wipe.setOnMouseReleased(MouseEvent::consume);
    }

    /** Says whether parts of the picture are transparent, which show grey squares. */
    public void setTransparent(boolean transparent) {
        checks.setVisible(transparent);
    }

    private static ImagePattern checkered() {
        WritableImage squares = new WritableImage(2 * SQUARE, 2 * SQUARE);
        for (int y = 0; y < 2 * SQUARE; y++) {
            for (int x = 0; x < 2 * SQUARE; x++) {
                squares.getPixelWriter().setColor(x, y, x / SQUARE == y / SQUARE ? Color.grayRgb(150) : Color.grayRgb(190));
            }
        }
        return new ImagePattern(squares, 0, 0, 2 * SQUARE, 2 * SQUARE, false);
    }

    /** Screen pixels to one of the picture. */
    public ReadOnlyDoubleProperty zoomProperty() {
        return zoom.getReadOnlyProperty();
    }

    /** Where in the picture the mouse is; empty if it is beside it. */
    public ReadOnlyObjectProperty<Optional<Point2D>> pointedProperty() {
        return pointed.getReadOnlyProperty();
    }

    /** Is told of clicks on the picture. */
    public void setOnClicked(Consumer<Point2D> listener) {
        onClicked.set(listener);
    }

    /** Lays another picture over the right part of this one, stretched to its size. */
    public void compare(Optional<PictureBuffer> second) {
        other.setImage(second.map(PictureBuffer::image).orElse(null));
        other.setVisible(second.isPresent());
        wipe.setVisible(second.isPresent());
        requestLayout();
    }

    /** Shows the whole picture as large as it can be, also when the window's size changes. */
    public void fit() {
        fits = true;
        requestLayout();
    }

    /** Shows one pixel of the picture as one of the screen, the middle in the middle. */
    public void actualSize() {
        fits = false;
        zoom.set(1);
        left = Math.rint((getWidth() - buffer.width()) / 2);
        top = Math.rint((getHeight() - buffer.height()) / 2);
        requestLayout();
    }

    /** Zooms about a point of this view, which stays where it is. */
    void zoomBy(double factor, double x, double y) {
        double next = Math.max(LEAST_ZOOM, Math.min(MOST_ZOOM, zoom.get() * factor));
        double change = next / zoom.get();
        fits = false;
        zoom.set(next);
        left = x - (x - left) * change;
        top = y - (y - top) * change;
        requestLayout();
    }

    @Override
    protected void layoutChildren() {
        if (fits && getWidth() > 0 && getHeight() > 0) {
            zoom.set(Math.min(getWidth() / buffer.width(), getHeight() / buffer.height()));
            left = (getWidth() - shownWidth()) / 2;
            top = (getHeight() - shownHeight()) / 2;
        }
        place(picture);
        place(other);
        checks.setX(left);
        checks.setY(top);
        checks.setWidth(shownWidth());
        checks.setHeight(shownHeight());
        double x = wipeShare * shownWidth();
        otherPart.setX(x);
        otherPart.setWidth(shownWidth() - x);
        otherPart.setHeight(shownHeight());
        double width = snapSizeX(wipe.prefWidth(-1));
        wipe.resizeRelocate(left + x - width / 2, Math.max(0, top), width, Math.min(getHeight(), shownHeight()));
    }

    private void place(ImageView view) {
        view.setFitWidth(shownWidth());
        view.setFitHeight(shownHeight());
        view.setSmooth(zoom.get() < SQUARES);
        view.relocate(left, top);
    }

    private double shownWidth() {
        return buffer.width() * zoom.get();
    }

    private double shownHeight() {
        return buffer.height() * zoom.get();
    }

    private Optional<Point2D> toPicture(double x, double y) {
        double column = (x - left) / zoom.get();
        double row = (y - top) / zoom.get();
        boolean inside = column >= 0 && row >= 0 && column < buffer.width() && row < buffer.height();
        return inside ? Optional.of(new Point2D(column, row)) : Optional.empty();
    }

    private void scrolled(ScrollEvent event) {
        if (event.getDeltaY() != 0) {
            zoomBy(Math.pow(STEP, event.getDeltaY() / 40), event.getX(), event.getY());
        }
        event.consume();
    }

    private void pressed(MouseEvent event) {
        requestFocus();
        pressed = new Point2D(event.getX(), event.getY());
        dragged = pressed;
        event.consume();
    }

    private void dragged(MouseEvent event) {
        Point2D now = new Point2D(event.getX(), event.getY());
        if (now.distance(pressed) > CLICK_SLACK || !dragged.equals(pressed)) {
            pan(now.getX() - dragged.getX(), now.getY() - dragged.getY());
            dragged = now;
        }
        event.consume();
    }

    private void released(MouseEvent event) {
        if (dragged.equals(pressed)) {
            toPicture(event.getX(), event.getY()).ifPresent(onClicked.get());
        }
        event.consume();
    }

    private void pan(double x, double y) {
        fits = false;
        left += x;
        top += y;
        requestLayout();
    }

    private void key(KeyEvent event) {
        switch (event.getCode()) {
            case PLUS, ADD, EQUALS -> zoomBy(STEP, getWidth() / 2, getHeight() / 2);
            case MINUS, SUBTRACT -> zoomBy(1 / STEP, getWidth() / 2, getHeight() / 2);
            case DIGIT0, NUMPAD0 -> fit();
            case DIGIT1, NUMPAD1 -> actualSize();
            case LEFT -> pan(NUDGE, 0);
            case RIGHT -> pan(-NUDGE, 0);
            case UP -> pan(0, NUDGE);
            case DOWN -> pan(0, -NUDGE);
            default -> {
                return;
            }
        }
        event.consume();
    }
}
