package cz.paprsek.fx.view.projection;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.command.SelectionCommands;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.material.Material;
import cz.paprsek.material.MaterialName;
import cz.paprsek.material.MaterialSource;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import java.util.Locale;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.Point2D;
import javafx.scene.Cursor;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The material of what is clicked, for what is selected. */
class PipetteTest {
    private static final Material RED = Material.color(200, 10, 10);
    private final EditorModel model = new EditorModel(Scene.EMPTY.plus("gold", Material.color(255, 196, 70))
            .plus(SceneObject.of(new Sphere(1)).at(-4, 0, 0).madeOf(new MaterialName("gold")))
            .plus(SceneObject.of(new Sphere(1)))
            .plus(SceneObject.of(Csg.union(Operand.of(new Sphere(1)), Operand.of(new Sphere(1)).at(0.5, 0, 0))).at(4, 0, 0).madeOf(RED)));
    private final Edits edits = new Edits(model, Texts.in(Locale.ENGLISH));
    private final SelectionCommands commands = new SelectionCommands(edits);
    private final ProjectionPane pane = Gui.on(() -> new ProjectionPane(edits, Axes.FRONT, new SimpleObjectProperty<>(Theme.LIGHT), new SimpleBooleanProperty(), new SimpleBooleanProperty()));
    private final Gui gui = Gui.show(() -> pane, 500, 400);

    @AfterEach
    void close() {
        gui.close();
    }

    private void click(double x) {
        Point2D at = Gui.on(() -> pane.toPane(new Vec3(x, 0, 0)));
        gui.click(pane, at.getX(), at.getY());
    }

    private MaterialSource source(BodyAt at) {
        return at.in(model.scene()).material();
    }

    @Test
    void aClickTakesWhatTheBodyIsMadeOfInOneStep() {
        Scene before = model.scene();
        assertThat(commands.pipette().disabled().get()).as("nothing is selected").isTrue();
        gui.act(() -> {
            model.select(ScenePath.body(1), ScenePath.body(2, 1));
            commands.pipette().action().run();
        });
        click(-4);
        assertThat(source(ScenePath.body(1))).isEqualTo(new MaterialName("gold"));
        assertThat(source(ScenePath.body(2, 1))).isEqualTo(new MaterialName("gold"));
        assertThat(model.selection()).containsExactly(ScenePath.body(1), ScenePath.body(2, 1));
        assertThat(edits.pipette().taken()).contains(ScenePath.body(0));
        gui.act(model::undo);
        assertThat(model.scene()).isSameAs(before);
        gui.act(() -> {
            model.select(ScenePath.body(1));
            commands.pipette().action().run();
        });
        click(4);
        assertThat(source(ScenePath.body(1))).as("its own, which the operation has").isEqualTo(RED);
    }

    @Test
    void besideItWaitsAndItCanBeGivenUp() {
        gui.act(() -> {
            model.select(ScenePath.body(1));
            commands.pipette().action().run();
        });
        click(2);
        assertThat(edits.pipette().isActive()).isTrue();
        gui.moveTo(pane, 20, 20);
        gui.until("as the mouse shows", () -> pane.getCursor() == Cursor.CROSSHAIR);
        gui.act(commands.pipette().action());
        assertThat(edits.pipette().isActive()).isFalse();
        click(-4);
        assertThat(model.selection()).as("an ordinary click again").containsExactly(ScenePath.body(0));
        assertThat(source(ScenePath.body(1))).isNotEqualTo(new MaterialName("gold"));
    }
}
