package cz.paprsek.fx.view.projection;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import javafx.geometry.BoundingBox;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import org.junit.jupiter.api.Test;

/** Where a name of 50 × 12 pixels stands in a pane of 400 × 300. */
class NamePlacesTest {
    private static final Viewport VIEW = new Viewport(0, 0, 1, 400, 300);
    private static final Bounds NAME = new BoundingBox(0, -10, 50, 12);
    private static final Bounds THING = new BoundingBox(150, 100, 100, 60);

    private static Optional<Point2D> place(Bounds thing, Bounds... taken) {
        return Plate.beside(VIEW, NAME, thing, 14, 36, List.of(taken));
    }

    private static Bounds on(Point2D at) {
        return Plate.ground(NAME, at);
    }

    @Test
    void isRightBelowAboveLeftBesideTheMiddleOrWithin() {
        Point2D right = new Point2D(264, 164);
        Point2D below = new Point2D(175, 184);
        Point2D above = new Point2D(175, 62);
        Point2D left = new Point2D(86, 164);
        assertThat(place(THING)).contains(right);
        assertThat(place(THING, on(right))).contains(below);
        assertThat(place(THING, on(right), on(below))).contains(above);
        assertThat(place(THING, on(right), on(below), on(above))).contains(left);
        Bounds all = new BoundingBox(0, 0, 400, 300);
        assertThat(place(THING, on(right), on(below), on(above), on(left))).contains(new Point2D(264, 134));
        assertThat(place(THING, on(right), on(below), on(above), new BoundingBox(0, 0, 148, 300), on(new Point2D(264, 134)))).as("below its upper side").contains(new Point2D(175, 117));
        assertThat(place(THING, all)).isEmpty();
    }

    @Test
    void staysInThePaneAndOffTheHandlesOfWhatIsAsWideAsThat() {
        Bounds wide = new BoundingBox(8, 100, 384, 60);
        assertThat(place(wide)).as("as far to the right as there is room").contains(new Point2D(348, 164));
        assertThat(place(wide, new BoundingBox(394, 162, 10, 10))).as("below, for a handle is there").contains(new Point2D(175, 184));
        assertThat(place(new BoundingBox(-100, -100, 700, 700))).as("in the middle of all").contains(new Point2D(348, 278));
    }
}
