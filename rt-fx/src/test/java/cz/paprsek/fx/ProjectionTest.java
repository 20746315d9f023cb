package cz.paprsek.fx;

import static cz.paprsek.fx.EditorGui.place;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.projection.ProjectionPane;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import cz.paprsek.xml.SceneFiles;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import javafx.geometry.Point2D;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.paint.Color;
import javafx.stage.Window;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Mouse and keys in the projections. */
class ProjectionTest extends InProjections {
    private static final ScenePath BALL = ScenePath.body(0);
    private static final ScenePath CRATE = ScenePath.body(1);
    private static final ScenePath BOWL = ScenePath.body(2);

    /** A ball at the origin, a crate behind it, a bowl to the right; the camera far to the left. */
    static final Scene SCENE = Scene.EMPTY
            .withCamera(Camera.lookingAt(new Vec3(-6, 3, 6), Vec3.ZERO))
            .plus(Light.at(-3, 5, 3))
            .plus(
                    SceneObject.of(new Sphere(1)).named("ball"),
                    SceneObject.of(new Block(new Vec3(-1.5, -1.5, -4), new Vec3(1.5, 1.5, -2))).named("crate"),
                    SceneObject.of(Csg.difference(Operand.of(new Sphere(1)), Operand.of(new Sphere(0.5)).at(0, 0.8, 0))).named("bowl").at(5, 0, 0));

    @Override
    Scene scene() {
        return SCENE;
    }

    @Test
    void clickSelectsWhatIsInFrontAndTheNextClickWhatIsBehind() {
        ProjectionPane front = editor.projection("front");
        click(front, 0.3, 0.3, 0);
        assertThat(editor.model().selection()).containsExactly(BALL);
        click(front, 0.3, 0.3, 0);
        assertThat(editor.model().selection()).containsExactly(CRATE);
        click(front, 0.3, 0.3, 0);
        assertThat(editor.model().selection()).containsExactly(BALL);
        click(front, 0, 3, 0);
        assertThat(editor.model().selection()).isEmpty();
        assertThat(editor.model().undoableProperty().get()).isEmpty();
    }

    @Test
    void furtherClicksReachTheOperands() {
        ProjectionPane front = editor.projection("front");
        click(front, 5, 0.9, 0);
        click(front, 5, 0.9, 0);
        assertThat(editor.model().selection()).first().matches(item -> item instanceof ScenePath.BodyAt body && body.depth() == 1);
    }

    @Test
    void shiftAddsToTheSelectionAndTakesAway() {
        ProjectionPane front = editor.projection("front");
        click(front, 0.3, 0.3, 0);
        editor.gui.hold(KeyCode.SHIFT);
        click(front, 5.9, 0, 0);
        click(front, -3, 5, 3);
        assertThat(editor.model().selection()).containsExactly(BALL, BOWL, ScenePath.light(0));
        click(front, 0.3, 0.3, 0);
        editor.gui.letGo(KeyCode.SHIFT);
        assertThat(editor.model().selection()).containsExactly(BOWL, ScenePath.light(0));
    }

    @Test
    void rubberBandSelectsWhatLiesWithin() {
        ProjectionPane front = editor.projection("front");
        drag(front, new Vec3(-2, 2.2, 0), new Vec3(7, -2, 0));
        assertThat(editor.model().selection()).containsExactlyInAnyOrder(BALL, CRATE, BOWL);
    }

    @ParameterizedTest
    @CsvSource({"front, 1, 0.5, 0", "top, 1, 0, 0.5", "right, 0, 0.5, 1"})
    void draggingMovesInTheTwoAxesOfTheView(String axes, double x, double y, double z) {
        Vec3 by = new Vec3(x, y, z);
        ProjectionPane pane = editor.projection(axes);
        editor.gui.act(() -> editor.model().select(BALL));
        drag(pane, new Vec3(0.2, 0.2, 0.2), new Vec3(0.2, 0.2, 0.2).plus(by));
        assertMoved(BALL, by, 1.5 / scale(pane));
        assertThat(editor.text("#status-selection")).isEqualTo("ball   2 × 2 × 2");
        editor.gui.keys(KeyCode.CONTROL, KeyCode.Z);
        assertThat(editor.model().scene()).isSameAs(SCENE);
        editor.gui.keys(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.Z);
        assertMoved(BALL, by, 1.5 / scale(pane));
    }

    @Test
    void snappedDragEndsOnTheGridUnlessCtrlIsHeld() {
        editor.gui.act(() -> {
            editor.editor.snapping().set(true);
            editor.model().select(BALL);
        });
        ProjectionPane front = editor.projection("front");
        Point2D from = place(front, 0.2, 0.2, 0);
        Point2D to = place(front, 0.2 + 1.87, 0.2 + 2.61, 0);
        editor.gui.moveTo(front, from.getX(), from.getY());
        editor.gui.press(MouseButton.PRIMARY);
        editor.gui.moveTo(front, to.getX() - 3, to.getY());
        editor.gui.moveTo(front, to.getX(), to.getY());
        Vec3 snapped = position(BALL);
        editor.gui.hold(KeyCode.CONTROL);
        Vec3 free = position(BALL);
        editor.gui.letGo(KeyCode.CONTROL);
        assertThat(position(BALL)).isEqualTo(snapped);
        editor.gui.release(MouseButton.PRIMARY);
        assertThat(snapped.x() * 10).isEqualTo(Math.rint(snapped.x() * 10));
        assertThat(snapped.y() * 10).isEqualTo(Math.rint(snapped.y() * 10));
        assertThat(free.minus(new Vec3(1.87, 2.61, 0)).length()).isCloseTo(0, within(3 / scale(front)));
        assertThat(free).isNotEqualTo(snapped);
    }

    @Test
    void shiftKeepsADragToOneAxis() {
        ProjectionPane front = editor.projection("front");
        editor.gui.act(() -> editor.model().select(BALL));
        editor.gui.hold(KeyCode.SHIFT);
        drag(front, new Vec3(0.2, 0.2, 0), new Vec3(2.2, 0.5, 0));
        editor.gui.letGo(KeyCode.SHIFT);
        assertThat(position(BALL).y()).isZero();
        assertThat(position(BALL).x()).isCloseTo(2, within(3 / scale(front)));
    }

    @Test
    void escapeCancelsADrag() {
        ProjectionPane front = editor.projection("front");
        Point2D from = place(front, 0.2, 0.2, 0);
        editor.gui.moveTo(front, from.getX(), from.getY());
        editor.gui.press(MouseButton.PRIMARY);
        editor.gui.moveTo(front, from.getX() + 40, from.getY());
        assertThat(position(BALL).x()).isPositive();
        editor.gui.keys(KeyCode.D);
        assertThat(position(BALL)).as("D moves a copy").isEqualTo(Vec3.ZERO);
        assertThat(position(ScenePath.body(1)).x()).as("which stands after it").isPositive();
        editor.gui.keys(KeyCode.ESCAPE);
        assertThat(editor.model().scene()).isSameAs(SCENE);
        editor.gui.moveTo(front, from.getX() + 60, from.getY());
        editor.gui.release(MouseButton.PRIMARY);
        assertThat(editor.model().scene()).isSameAs(SCENE);
        assertThat(editor.model().undoableProperty().get()).isEmpty();
    }

    @Test
    void arrowKeysNudge() {
        ProjectionPane top = editor.projection("top");
        editor.gui.act(() -> {
            editor.model().select(BALL);
            top.requestFocus();
        });
        editor.gui.keys(KeyCode.RIGHT);
        double step = position(BALL).x();
        assertThat(step).isPositive();
        editor.gui.keys(KeyCode.DOWN);
        assertThat(position(BALL)).isEqualTo(new Vec3(step, 0, step));
        editor.gui.keys(KeyCode.SHIFT, KeyCode.LEFT);
        assertThat(position(BALL).x()).isCloseTo(-9 * step, within(1e-9));
    }

    @Test
    void cornerHandleKeepsProportionsWhileTheChainIsOn() {
        ProjectionPane front = editor.projection("front");
        editor.gui.act(() -> editor.model().select(CRATE));
        Point2D corner = place(front, 1.5, 1.5, 0).add(7, -7);
        Point2D to = place(front, 4.5, 3, 0).add(7, -7);
        editor.gui.drag(front, corner.getX(), corner.getY(), to.getX(), to.getY());
        Vec3 scale = editor.model().scene().objects().get(1).placement().scale();
        assertThat(scale.x()).isCloseTo(2, within(0.1));
        assertThat(scale).isEqualTo(new Vec3(scale.x(), scale.x(), scale.x()));
    }

    @Test
    void whatGrowsInProportionStaysAtItsDepth() {
        editor.gui.act(() -> editor.model().edit(Label.of(Label.Edit.MOVE), scene -> Moves.translated(scene, Set.of(BALL), new Vec3(0, 0, 2))));
        ProjectionPane front = editor.projection("front");
        editor.gui.act(() -> editor.model().select(BALL));
        Point2D corner = place(front, 1, 1, 0).add(7, -7);
        Point2D to = place(front, 3, 3, 0).add(7, -7);
        editor.gui.drag(front, corner.getX(), corner.getY(), to.getX(), to.getY());
        assertThat(editor.model().scene().objects().get(0).placement().scale().z()).isCloseTo(2, within(0.1));
        assertThat(position(BALL).z()).isEqualTo(2);
    }

    @Test
    void figuresAreShownWhileDragging() {
        ProjectionPane front = editor.projection("front");
        Point2D from = place(front, 0.2, 0.2, 0);
        WritableImage before = Gui.on(() -> front.snapshot(null, null));
        editor.gui.moveTo(front, from.getX(), from.getY());
        editor.gui.press(MouseButton.PRIMARY);
        editor.gui.moveTo(front, from.getX() + 40, from.getY());
        editor.gui.moveTo(front, from.getX() + 80, from.getY());
        int color = Gui.on(() -> count(front.snapshot(null, null), from.getX() + 90, from.getY() - 30, 80, 20)) - Gui.on(() -> count(before, from.getX() + 90, from.getY() - 30, 80, 20));
        editor.gui.release(MouseButton.PRIMARY);
        assertThat(color).as("letters beside the mouse").isGreaterThan(40);
    }

    /** How many pixels of a part have the colour of what is selected. */
    private static int count(WritableImage image, double x, double y, int width, int height) {
        int found = 0;
        Color wanted = Theme.LIGHT.palette().selected();
        for (int i = 0; i < width; i++) {
            for (int j = 0; j < height; j++) {
                Color color = image.getPixelReader().getColor((int) x + i, (int) y + j);
                found += Math.abs(color.getRed() - wanted.getRed()) + Math.abs(color.getBlue() - wanted.getBlue()) < 0.3 ? 1 : 0;
            }
        }
        return found;
    }

    @Test
    void aRightClickShowsTheWordsOfTheObjectMenu() {
        ProjectionPane front = editor.projection("front");
        Point2D at = place(front, 0.2, 0.2, 0);
        editor.gui.moveTo(front, at.getX(), at.getY());
        editor.gui.press(MouseButton.SECONDARY);
        editor.gui.release(MouseButton.SECONDARY);
        assertThat(editor.model().selection()).hasSize(1);
        List<String> words = Gui.on(() -> {
            ContextMenu menu = Window.getWindows().stream().filter(ContextMenu.class::isInstance).map(ContextMenu.class::cast).findFirst().orElseThrow();
            List<String> texts = menu.getItems().stream().map(MenuItem::getText).filter(Objects::nonNull).toList();
            menu.hide();
            return texts;
        });
        List<String> object = Gui.on(() -> ((MenuBar) editor.gui.stage().getScene().lookup("#menu-bar")).getMenus().get(3).getItems().stream()
                .map(MenuItem::getText).filter(Objects::nonNull).toList());
        assertThat(object).hasSizeGreaterThan(6);
        assertThat(words).containsAll(object).contains("Delete", "Paste");
    }

    @Test
    void cornerHandleResizesFromTheOppositeCorner() {
        editor.gui.act(() -> editor.editor.proportional().set(false));
        ProjectionPane front = editor.projection("front");
        editor.gui.act(() -> editor.model().select(CRATE));
        Point2D corner = place(front, 1.5, 1.5, 0).add(7, -7);
        Point2D to = place(front, 4.5, 3, 0).add(7, -7);
        editor.gui.drag(front, corner.getX(), corner.getY(), to.getX(), to.getY());
        Vec3 scale = editor.model().scene().objects().get(1).placement().scale();
        assertThat(scale.x()).isCloseTo(2, within(0.1));
        assertThat(scale.y()).isCloseTo(1.5, within(0.1));
        assertThat(scale.z()).isEqualTo(1);
        assertThat(editor.model().scene().objects().get(1).placement().position().x()).isCloseTo(1.5, within(0.1));
    }

    @Test
    void upperHandleTurnsAboutTheAxisOfTheView() {
        editor.gui.act(() -> {
            editor.editor.snapping().set(true);
            editor.model().select(CRATE);
        });
        ProjectionPane front = editor.projection("front");
        Point2D middle = place(front, 0, 0, 0);
        Point2D handle = place(front, 0, 1.5, 0).add(0, -27);
        double arm = middle.getY() - handle.getY();
        editor.gui.drag(front, handle.getX(), handle.getY(), middle.getX() - arm, middle.getY());
        assertThat(editor.model().scene().objects().get(1).placement().rotation()).isEqualTo(new Vec3(0, 0, 90));
    }

    @Test
    void wheelZoomsAboutTheCursor() {
        ProjectionPane front = editor.projection("front");
        Point2D before = place(front, 5, 0, 0);
        double scale = scale(front);
        editor.gui.moveTo(front, before.getX(), before.getY());
        editor.gui.wheel(-3);
        // In or out: without a display, the robot's wheel turns the other way.
        assertThat(scale(front)).isNotCloseTo(scale, within(scale * 1e-3));
        assertThat(place(front, 5, 0, 0).distance(before)).isLessThan(2);
    }

    @Test
    void wholeSceneIsShownAtFirstAndAgainWhenAnotherOneIsOpened() {
        ProjectionPane front = editor.projection("front");
        assertShowsAll(front, SCENE);
        Scene large = Scene.EMPTY.plus(SceneObject.of(new Sphere(80)).at(200, 0, 0));
        editor.gui.act(() -> editor.model().edit(cz.paprsek.fx.model.Label.of(cz.paprsek.fx.model.Label.Edit.CHANGE), scene -> large));
        double scale = scale(front);
        assertThat(scale(front)).as("an edit moves no view").isEqualTo(scale);
        editor.gui.act(() -> editor.model().open(large));
        assertShowsAll(front, large);
        assertThat(scale(front)).isLessThan(scale);
        editor.gui.act(() -> front.zoom(0.1));
        double chosen = scale(front);
        editor.gui.act(() -> editor.gui.stage().setWidth(1000));
        assertThat(scale(front)).as("what was chosen stays").isEqualTo(chosen);
    }

    private static void assertShowsAll(ProjectionPane pane, Scene scene) {
        assertThat(scene.objects()).allSatisfy(object -> {
            Vec3 middle = object.placement().position();
            assertThat(pane.getLayoutBounds().contains(place(pane, middle.x(), middle.y(), middle.z()))).isTrue();
        });
    }

    @Test
    void middleButtonPans() {
        ProjectionPane front = editor.projection("front");
        Point2D before = place(front, 0, 0, 0);
        editor.gui.moveTo(front, 100, 100);
        editor.gui.press(MouseButton.MIDDLE);
        editor.gui.moveTo(front, 130, 80);
        editor.gui.release(MouseButton.MIDDLE);
        assertThat(place(front, 0, 0, 0).subtract(before).distance(30, -20)).isCloseTo(0, within(1e-9));
        assertThat(editor.model().selection()).isEmpty();
    }

    @Test
    void lockedThingsStayAndHiddenThingsAreNotThere() {
        ProjectionPane front = editor.projection("front");
        editor.gui.act(() -> editor.model().select(BALL));
        editor.menu("object-lock");
        click(front, 0.3, 0.3, 0);
        assertThat(editor.model().selection()).containsExactly(CRATE);
        editor.menu("object-hide");
        click(front, 0.3, 0.3, 0);
        assertThat(editor.model().selection()).isEmpty();
        editor.menu("object-unlock-all");
        editor.menu("object-show-all");
        assertThat(editor.model().state().hidden()).isEqualTo(Set.of());
        click(front, 0.3, 0.3, 0);
        assertThat(editor.model().selection()).containsExactly(BALL);
    }

    @Test
    void statusTellsWhereTheMouseIs() {
        ProjectionPane top = editor.projection("top");
        Point2D place = place(top, 2, 0, 1);
        editor.gui.moveTo(top, Math.rint(place.getX()), Math.rint(place.getY()));
        assertThat(editor.text("#status-cursor")).matches("x [12]\\.\\d+   z [01]\\.\\d+");
    }

    private void assertMoved(ScenePath item, Vec3 by, double slack) {
        assertThat(position(item).minus(by).length()).isCloseTo(0, within(slack));
    }

    @Test
    void arrowKeysOnACopyWithAPlaceOfItsOwnSayWhyNot() throws Exception {
        openCopies();
        Scene before = editor.model().scene();
        ProjectionPane front = editor.projection("front");
        click(front, 0, 0, 0);
        assertThat(editor.model().selection()).containsExactly(ScenePath.body(0));
        editor.gui.keys(KeyCode.RIGHT);
        editor.gui.until("told", () -> editor.status().startsWith("each copy has a position of its own, by"));
        assertThat(editor.model().scene()).isSameAs(before);
        assertThat(editor.dialogs.faults).isEmpty();
    }

    @Test
    void aDragOfOneSaysWhyNotInTheUsersLanguage() throws Exception {
        openCopies();
        editor.gui.act(() -> editor.editor.setLanguage(Locale.forLanguageTag("cs")));
        editor.gui.act(() -> editor.projection("front").fitAll());
        Scene before = editor.model().scene();
        drag(editor.projection("front"), Vec3.ZERO, new Vec3(1, 1, 0));
        editor.gui.until("told", () -> editor.status().contains("2*i*i"));
        assertThat(editor.status()).doesNotContain("each copy");
        assertThat(editor.model().scene()).isEqualTo(before);
        assertThat(editor.dialogs.faults).isEmpty();
    }

    private void openCopies() throws Exception {
        Scene copies = SceneFiles.parse("""
                <scene xmlns="urn:paprsek:scene:1">
                  <camera position="0 2 9" target="0 0 0"/>
                  <repeat name="ball" count="3"><sphere radius="1" position="{2*i*i} 0 0"/></repeat>
                </scene>""");
        editor.gui.act(() -> editor.model().open(copies));
        editor.gui.act(() -> editor.projection("front").fitAll());
    }
}
