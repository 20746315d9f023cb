package cz.paprsek.fx.view.projection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Placement;
import java.util.Locale;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.Point2D;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** D in the middle of a drag of a handle: a crate of side 3 about the origin, seen from the front. */
class CopyingDragTest {
    private static final Vec3 CORNER = new Vec3(1.5, 1.5, 0);
    private final Scene scene = Scene.EMPTY.plus(SceneObject.of(new Block(new Vec3(-1.5, -1.5, -1.5), new Vec3(1.5, 1.5, 1.5))));
    private final EditorModel model = new EditorModel(scene);
    private final ProjectionPane pane = Gui.on(() -> new ProjectionPane(new Edits(model, Texts.in(Locale.ENGLISH)), Axes.FRONT,
            new SimpleObjectProperty<>(Theme.LIGHT), new SimpleBooleanProperty(true), new SimpleBooleanProperty(true)));
    private final Gui gui = Gui.show(() -> pane, 400, 300);

    @AfterEach
    void close() {
        gui.close();
    }

    private Point2D at(Vec3 place) {
        return Gui.on(() -> pane.toPane(place));
    }

    private Placement placement(int body) {
        return model.scene().objects().get(body).placement();
    }

    private void drag(Point2D from, Point2D to, KeyCode... pressed) {
        gui.moveTo(pane, from.getX(), from.getY());
        gui.press(MouseButton.PRIMARY);
        gui.moveTo(pane, to.getX(), to.getY());
        for (KeyCode key : pressed) {
            gui.keys(key);
        }
        gui.release(MouseButton.PRIMARY);
    }

    @Test
    void copyIsTurnedAndResizedAndTheOriginalStays() {
        gui.act(() -> model.select(ScenePath.body(0)));
        Point2D middle = at(Vec3.ZERO);
        Point2D stalk = at(new Vec3(0, 1.5, 0)).add(0, -27);
        drag(stalk, new Point2D(middle.getX() - middle.getY() + stalk.getY(), middle.getY()), KeyCode.D);
        assertThat(placement(0)).isEqualTo(scene.objects().get(0).placement());
        assertThat(placement(1).rotation()).isEqualTo(new Vec3(0, 0, 90));
        assertThat(model.selection()).containsExactly(ScenePath.body(1));
        gui.act(() -> model.open(scene));
        gui.act(() -> model.select(ScenePath.body(0)));
        drag(at(CORNER).add(7, -7), at(CORNER.times(3)).add(7, -7), KeyCode.D);
        assertThat(placement(0)).isEqualTo(scene.objects().get(0).placement());
        assertThat(placement(1).scale().x()).isCloseTo(2, within(0.15));
        gui.act(() -> model.undo());
        gui.act(() -> model.select(ScenePath.body(0)));
        drag(at(CORNER).add(7, -7), at(CORNER.times(3)).add(7, -7), KeyCode.D, KeyCode.D);
        assertThat(model.scene().objects()).as("pressed twice").hasSize(1);
        assertThat(placement(0).scale().x()).isCloseTo(2, within(0.15));
    }
}
