package cz.paprsek.fx.view.section;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.fx.model.edit.CutPlane;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.material.Material;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Placement;
import cz.paprsek.shape.Sphere;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.Point2D;
import javafx.scene.canvas.Canvas;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.Test;

/** The plane that solids are cut by, on a canvas of 100 by 100 pixels that shows 10 by 10 units about the origin, from the front. */
class SectionSkinTest {
    private final EditorModel model = new EditorModel(Scene.EMPTY.plus(SceneObject.of(new Sphere(2)).madeOf(Material.color(255, 0, 0))));
    private final SimpleObjectProperty<Optional<CutPlane>> plane = new SimpleObjectProperty<>(Optional.empty());
    private final SectionSkin skin = new SectionSkin(model, plane);

    private WritableImage drawn() {
        return Gui.on(() -> {
            Canvas canvas = new Canvas(100, 100);
            canvas.getGraphicsContext2D().setFill(Color.BLUE);
            canvas.getGraphicsContext2D().fillRect(0, 0, 100, 100);
            skin.draw(canvas.getGraphicsContext2D(), Theme.LIGHT.palette(), new Vec3(0, 0, -1), point -> new Point2D(50 + 10 * point.x(), 50 - 10 * point.y()));
            return canvas.snapshot(null, null);
        });
    }

    private static Color at(WritableImage image, int x, int y) {
        return image.getPixelReader().getColor(x, y);
    }

    @Test
    void alongTheAxisTheFaceIsSeenAndFromTheSideWhatIsTakenAway() {
        assertThat(at(drawn(), 50, 50)).as("whole").isEqualTo(Color.BLUE);
        plane.set(Optional.of(new CutPlane(Axis.Z, 0.5)));
        WritableImage face = drawn();
        assertThat(at(face, 50, 50).getRed()).isGreaterThan(at(face, 50, 50).getBlue());
        assertThat(at(face, 90, 50).getBlue()).as("beside it, paler").isGreaterThan(0.9);
        assertThat(at(face, 90, 50).getRed()).isBetween(0.4, 0.6);
        Gui.on(() -> {
            model.editState(Label.of(Label.Edit.HIDE), state -> state.withHidden(Set.of(ScenePath.body(0))));
            return true;
        });
        assertThat(at(drawn(), 50, 50)).as("what is hidden has no face").isEqualTo(Color.BLUE);
        Gui.on(() -> {
            model.undo();
            return true;
        });
        plane.set(Optional.of(new CutPlane(Axis.X, 0.5)));
        WritableImage side = drawn();
        assertThat(at(side, 30, 50)).as("stays").isEqualTo(Color.BLUE);
        assertThat(at(side, 70, 50).getRed()).as("is taken away").isGreaterThan(0.5);
        Gui.on(() -> {
            model.edit(Label.of(Label.Edit.MOVE), scene -> scene.with(ScenePath.body(0), body -> body.placed(Placement.at(3, 0, 0))));
            return true;
        });
        assertThat(at(drawn(), 70, 50)).as("the plane goes with what it cuts").isEqualTo(Color.BLUE);
    }

    @Test
    void aFaceHasTheColourThatItsNamedMaterialHasNow() {
        Scene red = Scene.EMPTY.plus("paint", Material.color(255, 0, 0)).plus(SceneObject.of(new Sphere(2)).madeOf("paint"));
        Gui.on(() -> {
            model.edit(Label.of(Label.Edit.CHANGE), scene -> red);
            return true;
        });
        plane.set(Optional.of(new CutPlane(Axis.Z, 0.5)));
        assertThat(at(drawn(), 50, 50).getGreen()).isLessThan(0.5);
        Gui.on(() -> {
            model.edit(Label.of(Label.Edit.CHANGE), scene -> scene.withMaterials(Map.of("paint", Material.color(0, 255, 0))));
            return true;
        });
        assertThat(model.scene().objects().get(0)).isSameAs(red.objects().get(0));
        assertThat(at(drawn(), 50, 50).getGreen()).isGreaterThan(at(drawn(), 50, 50).getRed());
    }

    @Test
    void acrossAnotherAxisItIsNotHeldAnyMore() {
        plane.set(Optional.of(new CutPlane(Axis.X, 0.5)));
        skin.take();
        plane.set(Optional.of(new CutPlane(Axis.X, 0.7)));
        assertThat(skin.isHeld()).as("moved").isTrue();
        plane.set(Optional.of(new CutPlane(Axis.Y, 0.5)));
        assertThat(skin.isHeld()).isFalse();
        skin.putBack();
        assertThat(plane.get().map(CutPlane::axis)).contains(Axis.Y);
    }
}
