package cz.paprsek.fx.view.camera;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Arranging;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.math.Vec3;
import cz.paprsek.render.Renderer;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.SphereLight;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import javafx.geometry.Bounds;
import javafx.scene.Node;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.input.ScrollEvent;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class CameraPaneTest {
    /** Seen from the front: a ball on the left, and a bitten one in the middle. */
    private static final Scene SCENE = Scene.EMPTY.withSettings(new RenderSettings(800, 400, 5, 2))
            .withCamera(Camera.lookingAt(new Vec3(0, 0, 6), Vec3.ZERO)).plus(Light.at(3, 5, 6))
            .plus(SceneObject.of(new Sphere(1)).named("left").at(-2.2, 0, 0))
            .plus(SceneObject.of(Csg.difference(Operand.of(new Sphere(1)), Operand.of(new Block(new Vec3(-0.3, -0.3, 0), new Vec3(0.3, 0.3, 2)))))
                    .named("bitten"));
    private static final double WIDTH = 400;
    private static final double HEIGHT = 300;

    private final AtomicReference<Throwable> fault = new AtomicReference<>();
    private final EditorModel model = new EditorModel(SCENE);
    private final CameraPane pane = Gui.on(() -> new CameraPane(model, fault::set));
    private final Gui gui = Gui.show(() -> pane, WIDTH, HEIGHT);
    private final Node picture = gui.node(".live-picture");

    @BeforeEach
    void waitForThePicture() {
        untilComplete();
    }

    @AfterEach
    void close() {
        pane.close();
        gui.close();
        assertThat(fault.get()).isNull();
    }

    @Test
    void showsWhatTheRendererRendersInAFrameOfItsShape() {
        Bounds frame = gui.node(".picture-frame").getBoundsInParent();
        assertThat(frame.getWidth() / frame.getHeight()).isBetween(1.98, 2.02);
        assertShown(model.scene());
    }

    @Test
    void followsTheSceneAlsoInTheMiddleOfAGesture() {
        Scene moved = SCENE.withCamera(SCENE.camera().withPosition(new Vec3(0, 3, 6)));
        gui.act(() -> model.begin(Label.of(Label.Edit.MOVE)).preview(scene -> moved));
        untilComplete();
        assertShown(moved);
    }

    @Test
    void whatIsHiddenIsNotInThePictureAndClicksReachWhatIsThere() {
        gui.act(() -> model.editState(Label.of(Label.Edit.HIDE), state -> state.withHidden(Set.of(ScenePath.body(0)))));
        untilComplete();
        assertShown(SCENE.withObjects(SCENE.objects().subList(1, 2)));
        gui.click(picture, WIDTH / 2, HEIGHT / 2);
        assertThat(model.selection()).containsExactly(ScenePath.body(1));
        gui.act(model::undo);
        untilComplete();
        assertShown(SCENE);
    }

    @Test
    void aCutterAloneIsSeenAsABody() {
        gui.act(() -> model.editState(Label.of(Label.Edit.HIDE), state -> Arranging.solo(state, Set.of(ScenePath.body(1, 1)))));
        untilComplete();
        assertShown(SCENE.withObjects(List.of(SCENE.objects().get(0),
                SceneObject.of(new Block(new Vec3(-0.3, -0.3, 0), new Vec3(0.3, 0.3, 2))))));
    }

    @Test
    void draggingOrbitsAsOneStep() {
        gui.drag(picture, 200, 150, 250, 150);
        assertThat(model.scene().camera().position().x()).isLessThan(-1);
        assertThat(model.scene().camera().position().length()).isBetween(5.99, 6.01);
        gui.act(model::undo);
        assertThat(model.scene()).isSameAs(SCENE);
    }

    @Test
    void draggingWithShiftPansSoThatTheScenesStaysUnderTheMouse() {
        gui.hold(KeyCode.SHIFT);
        gui.drag(picture, 200, 150, 250, 150);
        gui.letGo(KeyCode.SHIFT);
        Camera camera = model.scene().camera();
        assertThat(camera.position().x()).isCloseTo(-50 * 2 * 6 * Math.tan(Math.PI / 8) / 200, Offset.offset(1e-3));
        assertThat(camera.forward()).isEqualTo(new Vec3(0, 0, -1));
    }

    @Test
    void theWheelDolliesAndATurnIsOneStep() {
        double[] turned = new double[1];
        gui.act(() -> picture.addEventFilter(ScrollEvent.SCROLL, event -> turned[0] += event.getDeltaY()));
        gui.moveTo(picture, 200, 150);
        gui.wheel(1);
        gui.wheel(1);
        double distance = model.scene().camera().position().z();
        assertThat(distance).isCloseTo(6 * Math.exp(-0.12 / 40 * turned[0]), Offset.offset(1e-3)).isNotEqualTo(6);
        gui.until("the turn has ended", () -> !model.gesturingProperty().get());
        gui.act(model::undo);
        assertThat(model.scene()).isSameAs(SCENE);
    }

    @Test
    void escapeCancelsADrag() {
        gui.moveTo(picture, 200, 150);
        gui.press(MouseButton.PRIMARY);
        gui.moveTo(picture, 260, 170);
        assertThat(model.scene()).isNotSameAs(SCENE);
        gui.keys(KeyCode.ESCAPE);
        assertThat(model.scene()).isSameAs(SCENE);
        gui.moveTo(picture, 270, 170);
        gui.release(MouseButton.PRIMARY);
        assertThat(model.scene()).isSameAs(SCENE);
        assertThat(model.undoableProperty().get()).isEmpty();
    }

    @Test
    void keysMoveTheCameraToo() {
        gui.act(picture::requestFocus);
        gui.keys(KeyCode.RIGHT);
        assertThat(model.scene().camera().position().x()).isNegative();
        gui.keys(KeyCode.PLUS);
        assertThat(model.scene().camera().position().length()).isLessThan(5.9);
    }

    @Test
    void aClickSelectsTheObjectASecondOneItsOperandAndOneBesideItNothing() {
        gui.click(picture, 200, 150);
        assertThat(model.selection()).isEqualTo(Set.of(ScenePath.body(1)));
        gui.click(picture, 200, 150);
        assertThat(model.selection()).as("the bottom of the hole").isEqualTo(Set.of(ScenePath.body(1, 1)));
        gui.click(picture, 88, 150);
        assertThat(model.selection()).isEqualTo(Set.of(ScenePath.body(0)));
        gui.click(picture, 390, 150);
        assertThat(model.selection()).isEmpty();
        assertThat(model.scene()).isSameAs(SCENE);
    }

    @Test
    void altAndAClickSelectTheOperandAtOnceAndShiftAddsToTheSelection() {
        gui.hold(KeyCode.ALT);
        gui.click(picture, 200, 150);
        gui.letGo(KeyCode.ALT);
        assertThat(model.selection()).isEqualTo(Set.of(ScenePath.body(1, 1)));
        gui.hold(KeyCode.SHIFT);
        gui.click(picture, 88, 150);
        gui.letGo(KeyCode.SHIFT);
        assertThat(model.selection()).isEqualTo(Set.of(ScenePath.body(1, 1), ScenePath.body(0)));
    }

    @Test
    void theMouseTellsTheExactPointOfThePicture() {
        gui.moveTo(picture, 200, 150);
        Optional<PicturePoint> point = pane.pointedProperty().get();
        assertThat(point.orElseThrow().column()).isEqualTo(200);
        assertThat(point.orElseThrow().row()).isEqualTo(100);
        assertThat(point.orElseThrow().place()).contains(ScenePath.body(1, 1));
        AtomicReference<PicturePoint> clicked = new AtomicReference<>();
        gui.act(() -> pane.setClickedFirst(at -> {
            clicked.set(at);
            return true;
        }));
        gui.click(picture, 200, 150);
        assertThat(clicked.get()).isEqualTo(point.orElseThrow());
        assertThat(model.selection()).isEmpty();
    }

    @Test
    void aClickSelectsALightThatIsSeenBeforeAnythingElse() {
        gui.act(() -> model.begin(Label.of(Label.Edit.MOVE)).preview(scene -> scene.plus(SphereLight.of(new Vec3(0, 0, 2), 0.3))));
        untilComplete();
        gui.click(picture, 200, 150);
        assertThat(model.selection()).isEqualTo(Set.of(ScenePath.light(1)));
        gui.click(picture, 88, 150);
        assertThat(model.selection()).isEqualTo(Set.of(ScenePath.body(0)));
    }

    private void untilComplete() {
        gui.until("the picture is complete", () -> pane.isComplete());
    }

    /** What is on the screen, pixel for pixel. */
    private void assertShown(Scene scene) {
        cz.paprsek.image.Image expected = Renderer.render(scene.withSettings(scene.settings().withSize(400, 200)));
        Image shown = Gui.on(() -> ((ImageView) picture.lookup("ImageView")).getImage());
        for (int y = 0; y < 200; y++) {
            for (int x = 0; x < 400; x++) {
                assertThat(shown.getPixelReader().getArgb(x, y)).isEqualTo(expected.argb(x, y));
            }
        }
    }
}
