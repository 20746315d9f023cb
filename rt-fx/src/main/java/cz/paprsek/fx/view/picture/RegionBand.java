package cz.paprsek.fx.view.picture;

import cz.paprsek.render.Tile;
import java.util.Optional;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.geometry.Point2D;
import javafx.scene.Group;
import javafx.scene.control.Label;
import javafx.scene.shape.Rectangle;

/** A rectangle of whole pixels that is dragged over a picture, with its numbers: column and row of its top left pixel, and its size. */
public final class RegionBand extends Group {
    private final int columns;
    private final int rows;
    private final Rectangle frame = new Rectangle();
    /** Behind the dashes, so that they are seen on any picture. */
    private final Rectangle ground = new Rectangle();
    private final Label numbers = new Label();
    private final ReadOnlyObjectWrapper<Optional<Tile>> region = new ReadOnlyObjectWrapper<>(Optional.empty());
    private Optional<Tile> before = Optional.empty();
    private Optional<Point2D> anchor = Optional.empty();
    /** Where the picture's first pixel lies in the whole picture. */
    private int left;
    private int top;

    /** Over a picture of so many pixels. */
    public RegionBand(int columns, int rows) {
        this.columns = columns;
        this.rows = rows;
        frame.getStyleClass().add("region-band");
        ground.getStyleClass().add("region-ground");
        ground.xProperty().bind(frame.xProperty());
        ground.yProperty().bind(frame.yProperty());
        ground.widthProperty().bind(frame.widthProperty());
        ground.heightProperty().bind(frame.heightProperty());
        numbers.getStyleClass().add("region-numbers");
        getChildren().addAll(ground, frame, numbers);
        setMouseTransparent(true);
        setVisible(false);
        setManaged(false);
    }

    /** How wide the picture is, in pixels. */
    public int columns() {
        return columns;
    }

    /** How high the picture is, in pixels. */
    public int rows() {
        return rows;
    }

    /** What has been dragged, in pixels of the whole picture; empty for nothing. */
    public ReadOnlyObjectProperty<Optional<Tile>> regionProperty() {
        return region.getReadOnlyProperty();
    }

    void setOrigin(int column, int row) {
        left = column;
        top = row;
    }

    /** Shows a part of the whole picture, or none. */
    public void show(Optional<Tile> wished) {
        region.set(wished);
        setVisible(wished.isPresent());
    }

    /** Begins at a point of this picture, in pixels. */
    public void begin(Point2D at) {
        before = region.get();
        anchor = Optional.of(at);
    }

    /** Goes on to a point, which may lie outside of it. */
    public void drag(Point2D to) {
        anchor.ifPresent(from -> {
            int x0 = within(Math.floor(Math.min(from.getX(), to.getX())), columns - 1);
            int y0 = within(Math.floor(Math.min(from.getY(), to.getY())), rows - 1);
            int x1 = Math.max(x0 + 1, within(Math.ceil(Math.max(from.getX(), to.getX())), columns));
            int y1 = Math.max(y0 + 1, within(Math.ceil(Math.max(from.getY(), to.getY())), rows));
            show(Optional.of(new Tile(left + x0, top + y0, x1 - x0, y1 - y0)));
        });
    }

    private static int within(double pixel, int most) {
        return (int) Math.max(0, Math.min(most, pixel));
    }

    /** Whether it has been begun and not ended. */
    public boolean isDragging() {
        return anchor.isPresent();
    }

    /** Leaves it as it is. */
    public void end() {
        anchor = Optional.empty();
    }

    /** Gives up what is being dragged. */
    public void giveUp() {
        end();
        show(before);
    }

    /** Moves what there is by so many pixels, or makes it wider and higher by as many; begins with the middle of the picture if there is nothing yet. */
    public void nudge(int x, int y, boolean isSize) {
        if (region.get().isEmpty()) {
            show(Optional.of(new Tile(left + columns / 4, top + rows / 4, Math.max(1, columns / 2), Math.max(1, rows / 2))));
            return;
        }
        Tile old = region.get().get();
        int width = isSize ? Math.max(1, Math.min(old.width() + x, left + columns - old.x())) : old.width();
        int height = isSize ? Math.max(1, Math.min(old.height() + y, top + rows - old.y())) : old.height();
        int column = isSize ? old.x() : left + within(old.x() + x - left, columns - width);
        int row = isSize ? old.y() : top + within(old.y() + y - top, rows - height);
        show(Optional.of(new Tile(column, row, width, height)));
    }

    /** Puts it where it belongs, if the picture begins at a point and has so many pixels of the screen to one of its own. */
    public void place(double x, double y, double zoom) {
        region.get().ifPresent(tile -> {
            frame.setX(x + (tile.x() - left) * zoom);
            frame.setY(y + (tile.y() - top) * zoom);
            frame.setWidth(tile.width() * zoom);
            frame.setHeight(tile.height() * zoom);
            numbers.setText(tile.x() + ", " + tile.y() + " · " + tile.width() + " × " + tile.height());
            numbers.autosize();
            // Above the rectangle, or in it if there is no room.
            double above = frame.getY() - numbers.getHeight() - 2;
            numbers.relocate(Math.max(0, frame.getX()), above >= 0 ? above : Math.max(0, frame.getY()) + 2);
        });
    }
}
