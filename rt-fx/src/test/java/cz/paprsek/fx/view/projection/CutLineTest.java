package cz.paprsek.fx.view.projection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.fx.model.edit.CutPlane;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.section.SectionSkin;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Sphere;
import java.util.Locale;
import java.util.Optional;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.Point2D;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The line of the plane that solids are cut by, moved by a robot: a ball of radius 2 about the origin, seen from the front. */
class CutLineTest {
    private final EditorModel model = new EditorModel(Scene.EMPTY.plus(SceneObject.of(new Sphere(2))));
    private final SimpleObjectProperty<Optional<CutPlane>> plane = new SimpleObjectProperty<>(Optional.of(new CutPlane(Axis.X, 0.5)));
    private final SectionSkin skin = new SectionSkin(model, plane);
    private final SimpleBooleanProperty snapping = new SimpleBooleanProperty(true);
    private final ProjectionPane pane = Gui.on(() -> {
        ProjectionPane fresh = new ProjectionPane(new Edits(model, Texts.in(Locale.ENGLISH)), Axes.FRONT, new SimpleObjectProperty<>(Theme.LIGHT), snapping, new SimpleBooleanProperty(true));
        fresh.cutBy(skin);
        return fresh;
    });
    private final Gui gui = Gui.show(() -> pane, 400, 300);

    @BeforeEach
    void showAll() {
        gui.act(pane::fitAll);
        gui.pulse();
    }

    @AfterEach
    void close() {
        gui.close();
    }

    private double place() {
        return plane.get().orElseThrow().place(model.scene()).orElseThrow();
    }

    private Point2D at(double x, double y) {
        return Gui.on(() -> pane.toPane(new Vec3(x, y, 0)));
    }

    private void drag(Point2D from, Point2D to) {
        gui.drag(pane, from.getX(), from.getY(), to.getX(), to.getY());
    }

    @Test
    void isDraggedToTheGridAndNothingIsAStep() {
        drag(at(0, 0.3), at(0.98, 0.9));
        assertThat(place()).isCloseTo(1, within(1e-9));
        snapping.set(false);
        drag(at(1, 0.3), at(-0.77, 0.3));
        assertThat(place()).isCloseTo(-0.77, within(0.02));
        drag(at(-0.77, -1), at(2.5, 0));
        assertThat(place()).as("no farther than there is anything").isCloseTo(2, within(1e-9));
        gui.act(() -> plane.set(Optional.of(new CutPlane(Axis.Y, 0.5))));
        drag(at(0.4, 0), at(0.4, -1));
        assertThat(place()).as("across y").isCloseTo(-1, within(0.02));
        assertThat(model.undoableProperty().get()).isEmpty();
        assertThat(model.scene().objects().get(0).placement().position()).isEqualTo(Vec3.ZERO);
        assertThat(skin.isHeld()).isFalse();
    }

    @Test
    void escapePutsItBack() {
        gui.moveTo(pane, at(0, 1).getX(), at(0, 1).getY());
        gui.press(MouseButton.PRIMARY);
        gui.moveTo(pane, at(0.5, 1).getX(), at(0.5, 1).getY());
        gui.moveTo(pane, at(1, 1).getX(), at(1, 1).getY());
        gui.until("it follows", () -> place() > 0.9);
        gui.keys(KeyCode.ESCAPE);
        gui.until("it is back", () -> Math.abs(place()) < 1e-9 && !skin.isHeld());
        gui.release(MouseButton.PRIMARY);
        assertThat(place()).isZero();
    }

    @Test
    void arrowsMoveItWhenItIsHeldOrNothingIsSelected() {
        gui.click(pane, at(0, -1).getX(), at(0, -1).getY());
        assertThat(skin.isHeld()).isTrue();
        assertThat(model.selection()).isEmpty();
        gui.keys(KeyCode.RIGHT);
        double step = place();
        assertThat(step).isPositive();
        gui.keys(KeyCode.UP);
        gui.keys(KeyCode.LEFT);
        gui.keys(KeyCode.LEFT);
        assertThat(place()).isCloseTo(-step, within(1e-9));
        gui.keys(KeyCode.ESCAPE);
        assertThat(place()).isZero();
        assertThat(skin.isHeld()).isFalse();
        gui.keys(KeyCode.RIGHT);
        gui.keys(KeyCode.ENTER);
        assertThat(place()).as("by the keyboard alone").isCloseTo(step, within(1e-9));
        gui.act(() -> model.select(ScenePath.body(0)));
        gui.keys(KeyCode.RIGHT);
        assertThat(model.scene().objects().get(0).placement().position().x()).as("what is selected is moved").isPositive();
    }
}
