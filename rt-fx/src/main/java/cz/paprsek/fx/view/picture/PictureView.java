package cz.paprsek.fx.view.picture;

import cz.paprsek.render.Tile;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.application.Platform;
import javafx.beans.InvalidationListener;
import javafx.beans.WeakInvalidationListener;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.beans.property.ReadOnlyDoubleWrapper;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.Point2D;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.image.ImageView;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
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
    /** From this zoom on pixels are shown as squares, also if the picture is fitted to the window. */
    private static final double SQUARES = 3;
    private static final double CLICK_SLACK = 3;
    private static final double NUDGE = 40;
    private static final int SQUARE = 8;
    private static final int LEAP = 10;
    private static final double GAP = 6;

    private final PictureBuffer buffer;
    private final Rectangle checks = new Rectangle();
    private final ImageView picture;
    private final ImageView other = new ImageView();
    private final Squares squares = new Squares();
    private final Squares otherSquares = new Squares();
    private final Rectangle otherSquaresPart = new Rectangle();
    private final Rectangle otherPart = new Rectangle();
    private final Region wipe = new Region();
    private final Label leftName = new Label();
    private final Label rightName = new Label();
    private final RegionBand band;
    private final ReadOnlyDoubleWrapper zoom = new ReadOnlyDoubleWrapper(1);
    private final ReadOnlyObjectWrapper<Optional<Point2D>> pointed = new ReadOnlyObjectWrapper<>(Optional.empty());
    private final ObjectProperty<Consumer<Point2D>> onClicked = new SimpleObjectProperty<>(point -> {});
    private final BooleanProperty selecting = new SimpleBooleanProperty();
    private Consumer<Tile> onRegion = tile -> {};
    private double left;
    private double top;
    private boolean fits = true;
    private double wipeShare = 0.5;
    private Optional<PictureBuffer> second = Optional.empty();
    /** Held here, because pictures outlive their views, and hold it weakly. */
    private final InvalidationListener onPainted = painted -> Platform.runLater(this::drawSquares);
    private final WeakInvalidationListener painted = new WeakInvalidationListener(onPainted);
    private Point2D pressed = Point2D.ZERO;
    private Point2D dragged = Point2D.ZERO;
    private boolean pans;

    public PictureView(PictureBuffer buffer) {
        this.buffer = buffer;
        this.picture = new ImageView(buffer.image());
        this.band = new RegionBand(buffer.width(), buffer.height());
        band.regionProperty().addListener((property, old, now) -> requestLayout());
        for (Label name : List.of(leftName, rightName)) {
            name.getStyleClass().add("side-name");
            name.setMouseTransparent(true);
            name.setVisible(false);
        }
        getStyleClass().add("picture-view");
        wipe.getStyleClass().add("wipe");
        wipe.setCursor(Cursor.H_RESIZE);
        wipe.setVisible(false);
        other.setClip(otherPart);
        otherSquares.setClip(otherSquaresPart);
        buffer.shownPaintsProperty().addListener(painted);
        other.setVisible(false);
        other.setMouseTransparent(true);
        Rectangle clip = new Rectangle();
        clip.widthProperty().bind(widthProperty());
        clip.heightProperty().bind(heightProperty());
        setClip(clip);
        checks.setFill(checkered());
        checks.setVisible(false);
        checks.setMouseTransparent(true);
        getChildren().addAll(checks, picture, squares, other, otherSquares, leftName, rightName, wipe, band);
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

    /**
     * Lays another picture over the right part of this one, stretched to its size.
     *
     * @param left what this one is called beside it
     * @param right what the other is called
     */
    public void compare(Optional<PictureBuffer> wished, String left, String right) {
        second.ifPresent(old -> old.shownPaintsProperty().removeListener(painted));
        buffer.shownPaintsProperty().removeListener(painted);
        second = wished;
        buffer.shownPaintsProperty().addListener(painted);
        second.filter(now -> now != buffer).ifPresent(now -> now.shownPaintsProperty().addListener(painted));
        other.setImage(second.map(PictureBuffer::image).orElse(null));
        leftName.setText(left);
        rightName.setText(right);
        for (Node node : List.of(other, wipe, leftName, rightName)) {
            node.setVisible(second.isPresent());
        }
        requestLayout();
    }

    /** Says where this picture lies in a larger one, of which it is a part: the column and row of its first pixel. */
    public void setOrigin(int column, int row) {
        band.setOrigin(column, row);
    }

    /** Whether dragging draws a rectangle, and arrow keys move it, in place of moving the picture; Shift draws one at any time. */
    public BooleanProperty selectingProperty() {
        return selecting;
    }

    /** Is told of a rectangle, in pixels of the whole picture, when it has been drawn or moved: not of one that is given up, nor on the way. */
    public void setOnRegion(Consumer<Tile> listener) {
        onRegion = listener;
    }

    /** The rectangle that is shown, in pixels of the whole picture; empty if there is none. */
    public ReadOnlyObjectProperty<Optional<Tile>> regionProperty() {
        return band.regionProperty();
    }

    /** Shows a rectangle, in pixels of the whole picture, or none. */
    public void showRegion(Optional<Tile> region) {
        band.show(region);
    }

    /** Gives up the rectangle that is being drawn; false if none is. */
    public boolean giveUpRegion() {
        boolean isDrawn = band.isDragging();
        if (isDrawn) {
            band.giveUp();
        }
        return isDrawn;
    }

    /** Shows the whole picture as large as it can be, also when the window's size changes. */
    public void fit() {
        fits = true;
        requestLayout();
    }

    /** Shows one pixel of the picture as one of the screen, the middle in the middle. */
    public void actualSize() {
        double scale = pixelScale();
        fits = false;
        zoom.set(1 / scale);
        left = Math.rint((getWidth() - shownWidth()) / 2 * scale) / scale;
        top = Math.rint((getHeight() - shownHeight()) / 2 * scale) / scale;
        requestLayout();
    }

    /** How many pixels of the screen, side by side, are one of this view: 2 where all is shown twice as large. */
    private double pixelScale() {
        return getScene() == null || getScene().getWindow() == null ? 1 : getScene().getWindow().getOutputScaleX();
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
        drawSquares();
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
        placeNames(left + x);
        band.place(left, top, zoom.get());
    }

    /** At the top of each side, as far as that can be seen. */
    private void placeNames(double line) {
        double y = Math.max(0, top) + GAP;
        double from = Math.max(0, left) + GAP;
        double middle = Math.max(from, Math.min(getWidth(), line));
        double to = Math.min(getWidth(), left + shownWidth()) - GAP;
        place(leftName, from, y, middle - GAP - from);
        place(rightName, middle + GAP, y, to - middle - GAP);
    }

    private static void place(Label name, double x, double y, double room) {
        double width = Math.max(0, Math.min(room, name.prefWidth(-1)));
        name.resizeRelocate(x, y, width, name.prefHeight(-1));
    }

    private void place(ImageView view) {
        view.setFitWidth(shownWidth());
        view.setFitHeight(shownHeight());
        view.relocate(left, top);
    }

    /** What is enlarged is drawn once more, over what is blurred. */
    private void drawSquares() {
        boolean areSeen = zoom.get() * pixelScale() > (fits ? SQUARES : 1);
        squares.setVisible(areSeen);
        picture.setOpacity(areSeen ? 0 : 1);
        otherSquares.setVisible(areSeen && second.isPresent());
        other.setOpacity(areSeen ? 0 : 1);
        if (areSeen) {
            squares.draw(buffer.image(), left, top, zoom.get(), getWidth(), getHeight());
            second.ifPresent(over -> otherSquares.draw(over.image(), left, top, zoom.get() * buffer.width() / over.width(), getWidth(), getHeight()));
            double x = left + wipeShare * shownWidth();
            otherSquaresPart.setX(x);
            otherSquaresPart.setWidth(Math.max(0, getWidth() - x));
            otherSquaresPart.setHeight(getHeight());
        }
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
        if (event.getButton() == MouseButton.PRIMARY && (selecting.get() || event.isShiftDown())) {
            band.begin(pixel(event));
        }
        pans = !band.isDragging();
        event.consume();
    }

    private void dragged(MouseEvent event) {
        Point2D now = new Point2D(event.getX(), event.getY());
        if (now.distance(pressed) > CLICK_SLACK || !dragged.equals(pressed)) {
            if (band.isDragging()) {
                band.drag(pixel(event));
            } else if (pans) {
                pan(now.getX() - dragged.getX(), now.getY() - dragged.getY());
            }
            dragged = now;
        }
        event.consume();
    }

    private Point2D pixel(MouseEvent event) {
        return new Point2D((event.getX() - left) / zoom.get(), (event.getY() - top) / zoom.get());
    }

    private void released(MouseEvent event) {
        if (band.isDragging() && !dragged.equals(pressed)) {
            band.drag(pixel(event));
            regionProperty().get().ifPresent(onRegion);
        }
        band.end();
        if (dragged.equals(pressed) && event.getButton() == MouseButton.PRIMARY) {
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

    /** Moves the rectangle, with Shift ten pixels, or its far corner with Alt; else looks that way. */
    private void arrow(KeyEvent event, int x, int y) {
        if (selecting.get()) {
            int far = event.isShiftDown() ? LEAP : 1;
            band.nudge(far * x, far * y, event.isAltDown());
            regionProperty().get().ifPresent(onRegion);
        } else {
            pan(-NUDGE * x, -NUDGE * y);
        }
    }

    private void key(KeyEvent event) {
        switch (event.getCode()) {
            case PLUS, ADD, EQUALS -> zoomBy(STEP, getWidth() / 2, getHeight() / 2);
            case MINUS, SUBTRACT -> zoomBy(1 / STEP, getWidth() / 2, getHeight() / 2);
            case DIGIT0, NUMPAD0 -> fit();
            case DIGIT1, NUMPAD1 -> actualSize();
            case LEFT -> arrow(event, -1, 0);
            case RIGHT -> arrow(event, 1, 0);
            case UP -> arrow(event, 0, -1);
            case DOWN -> arrow(event, 0, 1);
            default -> {
                return;
            }
        }
        event.consume();
    }
}
