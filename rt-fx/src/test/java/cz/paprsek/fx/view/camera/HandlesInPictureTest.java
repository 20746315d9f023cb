package cz.paprsek.fx.view.camera;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.drawing.CameraView;
import cz.paprsek.fx.Gui;
import cz.paprsek.fx.Screenshots;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Arranging.Axis;
import cz.paprsek.fx.model.edit.CutPlane;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.fx.model.motion.Clock;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Animation;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.RenderSettings;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.BoundingBox;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.SnapshotParameters;
import javafx.scene.control.ToggleButton;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.paint.Color;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What is selected is moved, turned and scaled in the camera's picture. */
class HandlesInPictureTest {
    private static final Scene SCENE = Scene.EMPTY.withSettings(new RenderSettings(400, 300, 1, 1))
            .withCamera(Camera.lookingAt(new Vec3(2, 3, 8), Vec3.ZERO)).plus(Light.at(3, 5, 6))
            .plus(SceneObject.of(new Sphere(0.5)).named("one")).plus(SceneObject.of(new Sphere(0.5)).named("two").at(1.9, 0, 0.3));
    private static final ScenePath ONE = ScenePath.body(0);
    private static final ScenePath TWO = ScenePath.body(1);

    private final EditorModel model = new EditorModel(SCENE);
    private final CameraPane pane = Gui.on(() -> new CameraPane(model, fault -> {}));
    private final Gui gui = Gui.show(() -> pane, 380, 330);
    private final Node picture = gui.node(".live-picture");

    @BeforeEach
    void select() {
        gui.act(() -> {
            pane.acceptEdits(new Edits(model, Texts.in(Locale.ENGLISH)), new SimpleBooleanProperty(true));
            model.select(ONE);
        });
        gui.until("the picture is complete", pane::isComplete);
    }

    @AfterEach
    void close() {
        pane.close();
        gui.close();
    }

    @Test
    void anAxisIsPulledAndComesInLineWithAnother() {
        Point2D from = place(new Vec3(0.4, 0, 0));
        Point2D to = place(new Vec3(2.28, 0, 0));
        gui.drag(picture, from.getX(), from.getY(), to.getX(), to.getY());
        assertThat(position(0)).as("in line with the middle of the other, and moved along x alone").isEqualTo(new Vec3(1.9, 0, 0));
        gui.act(model::undo);
        assertThat(model.scene()).isEqualTo(SCENE);
    }

    @Test
    void theMiddleMovesOnTheFloorAndAClickOnItSelectsAsBefore() {
        Point2D from = place(Vec3.ZERO);
        Point2D to = place(new Vec3(-1, 0, 1));
        gui.drag(picture, from.getX(), from.getY(), to.getX(), to.getY());
        Vec3 moved = position(0);
        assertThat(moved.y()).isZero();
        assertThat(moved.x()).isCloseTo(-1, Offset.offset(0.2));
        assertThat(moved.z()).isCloseTo(1, Offset.offset(0.2));
        Point2D other = place(new Vec3(1.9, 0, 0.3));
        gui.click(picture, other.getX(), other.getY());
        gui.click(picture, other.getX(), other.getY());
        assertThat(model.selection()).containsExactly(TWO);
        assertThat(model.scene().camera()).isEqualTo(SCENE.camera());
    }

    @Test
    void numbersAreTypedForEachOfTheThree() {
        gui.act(picture::requestFocus);
        gui.keys(KeyCode.G);
        gui.keys(KeyCode.X);
        type("2");
        assertThat(position(0)).as("at once").isEqualTo(new Vec3(2, 0, 0));
        gui.keys(KeyCode.ENTER);
        assertThat(position(0)).isEqualTo(new Vec3(2, 0, 0));
        gui.keys(KeyCode.R);
        gui.keys(KeyCode.Z);
        type("-30,5");
        gui.keys(KeyCode.ENTER);
        assertThat(model.scene().objects().get(0).placement().rotation()).isEqualTo(new Vec3(0, 0, -30.5));
        gui.keys(KeyCode.S);
        type("2");
        gui.keys(KeyCode.ESCAPE);
        assertThat(model.scene().objects().get(0).placement().scale()).isEqualTo(Vec3.ONE);
        gui.act(model::undo);
        gui.act(model::undo);
        assertThat(model.scene()).as("one step each").isEqualTo(SCENE);
    }

    @Test
    void aCopyIsMovedInTheMiddleOfADragAndSelected() {
        gui.act(picture::requestFocus);
        gui.keys(KeyCode.G);
        gui.keys(KeyCode.D);
        gui.keys(KeyCode.Z);
        type("3");
        gui.keys(KeyCode.ENTER);
        assertThat(model.scene().objects()).hasSize(3);
        assertThat(position(0)).isEqualTo(Vec3.ZERO);
        assertThat(position(1)).isEqualTo(new Vec3(0, 0, 3));
        assertThat(model.selection()).containsExactly(ScenePath.body(1));
        gui.act(model::undo);
        assertThat(model.scene()).isEqualTo(SCENE);
    }

    @Test
    void escapeAndEnterEndADragBeforeTheMouseIsLetGo() {
        pullAlongX(KeyCode.ESCAPE);
        assertThat(model.scene()).isEqualTo(SCENE);
        assertThat(model.undoableProperty().get()).isEmpty();
        pullAlongX(KeyCode.ENTER);
        assertThat(position(0)).as("where it was when Enter was pressed").isEqualTo(new Vec3(1.9, 0, 0));
        assertThat(model.selection()).containsExactly(ONE);
        gui.act(model::undo);
        assertThat(model.scene()).as("one step").isEqualTo(SCENE);
    }

    private void pullAlongX(KeyCode end) {
        Point2D from = place(new Vec3(0.4, 0, 0));
        Point2D to = place(new Vec3(2.28, 0, 0));
        Point2D beyond = place(new Vec3(2.9, 0, 0));
        gui.moveTo(picture, from.getX(), from.getY());
        gui.press(MouseButton.PRIMARY);
        gui.moveTo(picture, to.getX(), to.getY());
        assertThat(position(0)).isEqualTo(new Vec3(1.9, 0, 0));
        gui.keys(end);
        gui.moveTo(picture, beyond.getX(), beyond.getY());
        gui.release(MouseButton.PRIMARY);
    }

    @Test
    void aCopyThatIsCancelledLeavesTheSelectionAsItWas() {
        gui.act(picture::requestFocus);
        gui.keys(KeyCode.G);
        gui.keys(KeyCode.D);
        gui.keys(KeyCode.ESCAPE);
        assertThat(model.scene()).isEqualTo(SCENE);
        assertThat(model.selection()).containsExactly(ONE);
    }

    @Test
    void atAnotherTimeOnlyWhatIsSeenIsGrabbedAndSelected() {
        Clock clock = Gui.on(() -> new Clock(model));
        Animation left = new Animation("one", "position", Animation.Turning.ANGLES, List.of(new Animation.Key(0, "0 0 0", Animation.Ease.LINEAR), new Animation.Key(1, "-1.5 0 0", Animation.Ease.LINEAR)));
        gui.act(() -> {
            pane.follow(clock);
            model.edit(Label.of(Label.Edit.CHANGE), scene -> scene.withAnimations(List.of(left)));
            clock.look(1);
        });
        Point2D from = place(new Vec3(0.4, 0, 0));
        gui.drag(picture, from.getX(), from.getY(), from.getX() + 5, from.getY());
        assertThat(model.scene().objects()).as("it is elsewhere").isEqualTo(SCENE.objects());
        gui.act(model::undo);
        gui.act(() -> {
            model.select();
            clock.look(1);
        });
        gui.act(picture::requestFocus);
        gui.keys(KeyCode.B);
        Point2D one = place(new Vec3(-2.6, 1.2, 0));
        Point2D two = place(new Vec3(-0.4, -1.2, 0));
        gui.drag(picture, one.getX(), one.getY(), two.getX(), two.getY());
        assertThat(model.selection()).containsExactly(ONE);
        gui.keys(KeyCode.G);
        gui.keys(KeyCode.X);
        type("2");
        gui.keys(KeyCode.ENTER);
        assertThat(position(0)).as("numbers count from where it is written to be").isEqualTo(new Vec3(2, 0, 0));
    }

    @Test
    void aLockedCameraThatIsToLookAtSomethingIsTold() {
        AtomicInteger told = new AtomicInteger();
        gui.act(() -> {
            pane.setOnLocked(told::incrementAndGet);
            model.editState(Label.of(Label.Edit.LOCK), state -> state.withLocked(Set.of(ScenePath.camera(0))));
            picture.requestFocus();
        });
        gui.keys(KeyCode.F);
        assertThat(told).hasValue(1);
        assertThat(model.scene()).isEqualTo(SCENE);
    }

    @Test
    void aRubberBandSelectsWhatIsWhollyInIt() {
        gui.act(() -> model.select());
        gui.act(picture::requestFocus);
        gui.keys(KeyCode.B);
        Point2D one = place(new Vec3(-1, 1, 0));
        Point2D two = place(new Vec3(3, -1, 0.3));
        gui.drag(picture, one.getX(), one.getY(), two.getX(), two.getY());
        assertThat(model.selection()).containsExactlyInAnyOrder(ONE, TWO);
        assertThat(model.scene()).isSameAs(SCENE);
    }

    @Test
    void handlesThatTurnAndScaleAreChosenByTheirButtons() {
        gui.click("#handles-scale");
        Point2D middle = place(Vec3.ZERO);
        gui.moveTo(picture, middle.getX(), middle.getY());
        gui.press(MouseButton.PRIMARY);
        gui.moveTo(picture, middle.getX() + 62, middle.getY());
        assertThat(model.scene().objects().get(0).placement().scale()).isEqualTo(new Vec3(2, 2, 2));
        type("3");
        gui.release(MouseButton.PRIMARY);
        assertThat(model.scene().objects().get(0).placement().scale()).as("what is typed counts for more").isEqualTo(new Vec3(3, 3, 3));
        gui.click("#handles-turn");
        assertThat(Screenshots.save(gui, "handles-turn")).isNotEmptyFile();
    }

    @Test
    void solidsAreCutOpenInViewsAlone() {
        ObjectProperty<Optional<CutPlane>> plane = new SimpleObjectProperty<>(Optional.empty());
        gui.act(() -> {
            pane.cutBy(plane);
            model.select();
            plane.set(Optional.of(new CutPlane(Axis.X, 0.1)));
        });
        gui.until("the picture is complete", pane::isComplete);
        Point2D one = place(new Vec3(0.3, 0, 0));
        gui.click(picture, one.getX(), one.getY());
        assertThat(model.selection()).as("cut away").isEmpty();
        gui.act(() -> plane.set(Optional.of(new CutPlane(Axis.X, 0.3))));
        gui.until("the picture is complete", pane::isComplete);
        Point2D face = place(new Vec3(0.1, 0, 0));
        gui.click(picture, face.getX(), face.getY());
        assertThat(model.selection()).as("by its cut face").containsExactly(ONE);
        assertThat(model.scene()).isSameAs(SCENE);
    }

    @Test
    void whatBlinksIsNotThereForAMomentAndThenAsBefore() {
        gui.act(() -> pane.blink(Set.of(ONE)));
        gui.until("it is away", () -> pane.at(0.5, 0.5).flatMap(PicturePoint::place).isEmpty());
        gui.act(() -> model.select(TWO));
        assertThat(Gui.on(pane::isBlinking)).isFalse();
        gui.until("it is there", () -> pane.at(0.5, 0.5).flatMap(PicturePoint::place).isPresent());
        assertThat(model.scene()).isSameAs(SCENE);
    }

    @Test
    void aMirroredCopyFollowsItsOriginal() {
        gui.act(() -> {
            model.select(TWO);
            new Edits(model, Texts.in(Locale.ENGLISH)).mirror();
        });
        assertThat(model.scene().objects()).hasSize(3);
        assertThat(ScenePath.body(2).toWorld(model.scene()).point(Vec3.ZERO)).isEqualTo(new Vec3(-1.9, 0, 0.3));
        gui.act(() -> model.edit(Label.of(Label.Edit.MOVE), scene -> Moves.translated(scene, Set.of(TWO), new Vec3(1, 1, 0))));
        assertThat(ScenePath.body(2).toWorld(model.scene()).point(Vec3.ZERO)).isEqualTo(new Vec3(-2.9, 1, 0.3));
    }

    /** What is dragged elsewhere has little of the picture painted anew, and leaves nothing behind. */
    @Test
    void whatIsDrawnAboveThePictureCoversLittle() {
        Overlay overlay = (Overlay) gui.node(".overlay");
        Gesture drag = Gui.on(() -> model.begin(Label.of(Label.Edit.MOVE)));
        for (Handles.Mode mode : List.of(Handles.Mode.MOVE, Handles.Mode.TURN, Handles.Mode.SCALE)) {
            for (double by : new double[] {0, 0.7, -0.6, 30}) {
                gui.act(() -> {
                    ((ToggleButton) pane.lookup("#handles-" + mode.name().toLowerCase(Locale.ROOT))).fire();
                    drag.preview(scene -> Moves.translated(scene, Set.of(ONE), new Vec3(by, by / 2, 0)));
                });
                Bounds part = Gui.on(() -> overlay.getClip().getBoundsInParent());
                assertThat(part.getWidth() * part.getHeight()).isLessThan(overlay.getWidth() * overlay.getHeight() * 0.7);
                assertThat(drawnOutside(overlay, part)).as("pixels drawn where they are not shown").isZero();
            }
        }
        gui.act(drag::cancel);
        gui.act(() -> model.select(Set.of()));
        assertThat(Gui.on(() -> overlay.getClip().getBoundsInParent())).as("with nothing to draw").isEqualTo(new BoundingBox(0, 0, 0, 0));
        gui.act(() -> model.select(ONE));
        Point2D from = place(new Vec3(0.4, 0, 0));
        gui.moveTo(picture, from.getX(), from.getY());
        gui.press(MouseButton.PRIMARY);
        gui.moveTo(picture, from.getX() + 20, from.getY());
        assertThat(Gui.on(overlay::getClip)).as("with figures at the upper edge").isNull();
        gui.release(MouseButton.PRIMARY);
        assertThat(Gui.on(overlay::getClip)).isNotNull();
    }

    private long drawnOutside(Overlay overlay, Bounds part) {
        gui.pulse();
        WritableImage all = Gui.on(() -> {
            Node clip = overlay.getClip();
            overlay.setClip(null);
            SnapshotParameters clear = new SnapshotParameters();
            clear.setFill(Color.TRANSPARENT);
            WritableImage image = overlay.snapshot(clear, null);
            overlay.setClip(clip);
            return image;
        });
        int width = (int) all.getWidth();
        return IntStream.range(0, (int) all.getHeight()).mapToLong(y -> IntStream.range(0, width).filter(x -> !part.contains(x + 0.5, y + 0.5))
                .filter(x -> all.getPixelReader().getArgb(x, y) != 0).count()).sum();
    }

    private void type(String text) {
        text.chars().forEach(c -> gui.keys(c == '-' ? KeyCode.MINUS : c == ',' ? KeyCode.COMMA : KeyCode.getKeyCode(String.valueOf((char) c))));
    }

    private Vec3 position(int body) {
        return model.scene().objects().get(body).placement().position();
    }

    /** Where a point of the world is in the picture. */
    private Point2D place(Vec3 point) {
        Bounds frame = Gui.on(() -> gui.node(".picture-frame").getBoundsInParent());
        Bounds own = Gui.on(() -> gui.node(".picture-frame").getLayoutBounds());
        var line = new CameraView(SCENE.camera(), own.getWidth(), own.getHeight()).line(point, point.plus(new Vec3(1e-6, 0, 0)));
        return new Point2D(frame.getMinX() + line.get(0).x1(), frame.getMinY() + line.get(0).y1());
    }
}
