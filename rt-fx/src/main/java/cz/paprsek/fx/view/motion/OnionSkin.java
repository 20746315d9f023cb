package cz.paprsek.fx.view.motion;

import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.model.motion.Ways;
import cz.paprsek.fx.model.motion.Ways.Way;
import cz.paprsek.fx.view.look.Palette;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Function;
import javafx.geometry.Point2D;
import javafx.scene.canvas.GraphicsContext;

/**
 * What is animated, at other times: its way as a line with dots at the keys; and, while a time is looked at, where it is then. One for all that draw it; while the hand is moving, ways stay as
 * they were.
 */
public final class OnionSkin {
    /** Of so many objects at most that move, outlines are drawn. */
    private static final int MOST = 200;

    private final EditorModel model;
    private final Clock clock;
    private Scene known = Scene.EMPTY;
    private List<Way> ways = List.of();

    public OnionSkin(EditorModel model, Clock clock) {
        this.model = model;
        this.clock = clock;
    }

    /** Whether there may be anything to draw. */
    public boolean isSeen() {
        return clock.openProperty().get();
    }

    /** Gives out the objects that are otherwise at the time that is looked at, as they are then, and whether each, or something in it, is selected. */
    public void passing(BiConsumer<SceneObject, Boolean> painter) {
        EditorState state = model.state();
        Scene moment = clock.shown().scene();
        if (clock.openProperty().get() && clock.secondsProperty().get().isPresent() && moment.objects().size() == state.scene().objects().size()) {
            Arrays.stream(moment.objectsOtherThanIn(state.scene())).limit(MOST).filter(i -> !state.isHidden(ScenePath.body(i))).forEach(i ->
                    painter.accept(moment.objects().get(i), state.selection().stream().anyMatch(item -> item instanceof BodyAt at && at.numbers().get(0) == i)));
        }
    }

    /**
     * Draws the ways.
     *
     * @param place where on the canvas a point of the world is
     */
    @SuppressWarnings("ReferenceEquality")
    public void ways(GraphicsContext g, Palette palette, Function<Vec3, Point2D> place) {
        if (!clock.openProperty().get()) {
            return;
        }
        EditorState state = model.state();
        if (known != state.scene() && !model.gesturingProperty().get()) {
            known = state.scene();
            ways = Ways.of(known);
        }
        Scene moment = clock.shown().scene();
        for (Way way : ways) {
            if (!state.isHidden(way.place())) {
                g.setStroke(state.selection().contains(way.place()) ? palette.selected() : palette.camera());
                g.setFill(palette.background());
                draw(g, way, place);
                g.setFill(palette.selected());
                Ways.at(moment, way.place()).filter(point -> clock.secondsProperty().get().isPresent()).map(place).ifPresent(at -> g.fillOval(at.getX() - 4, at.getY() - 4, 8, 8));
            }
        }
    }

    private static void draw(GraphicsContext g, Way way, Function<Vec3, Point2D> place) {
        g.setLineWidth(1.2);
        g.beginPath();
        for (int i = 0; i < way.line().size(); i++) {
            Point2D at = place.apply(way.line().get(i));
            if (i == 0) {
                g.moveTo(at.getX(), at.getY());
            } else {
                g.lineTo(at.getX(), at.getY());
            }
        }
        g.stroke();
        way.keys().stream().map(place).forEach(at -> {
            g.fillOval(at.getX() - 3, at.getY() - 3, 6, 6);
            g.strokeOval(at.getX() - 3, at.getY() - 3, 6, 6);
        });
    }
}
