package cz.paprsek.fx.view.projection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.Gesture;
import cz.paprsek.fx.model.Label;
import cz.paprsek.fx.model.edit.Moves;
import cz.paprsek.fx.model.edit.Structure;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.look.Layer;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.image.WritableImage;
import javafx.scene.input.MouseButton;
import javafx.scene.layout.StackPane;
import javafx.scene.shape.Line;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What is drawn, and painted, anew while one ball of a thousand is dragged in a pane of 400 × 300, seen from the front. */
class LayersTest {
    private static final int STEPS = 10;
    private static final List<String> NAMES = List.of("rest", "selected", "signs", "grabbed");

    private final EditorModel model = new EditorModel(balls(1000));
    private final ProjectionPane pane = Gui.on(() -> new ProjectionPane(new Edits(model, Texts.in(Locale.ENGLISH)), Axes.FRONT, new SimpleObjectProperty<>(Theme.LIGHT),
            new SimpleBooleanProperty(true), new SimpleBooleanProperty(true)));

    @Test
    void whatStaysIsDrawnOnceAndWhatMovesCoversLittle() {
        try (Gui gui = Gui.show(() -> pane, 400, 300)) {
            gui.act(() -> model.select(ScenePath.body(444)));
            Gesture drag = Gui.on(() -> model.begin(Label.of(Label.Edit.MOVE)));
            gui.pulse();
            List<Integer> before = ofAll(Layer::drawings);
            for (int i = 1; i <= STEPS; i++) {
                move(gui, drag, 0.01 * i);
            }
            List<Integer> drawn = ofAll(Layer::drawings);
            assertThat(IntStream.range(0, NAMES.size()).map(i -> drawn.get(i) - before.get(i))).containsExactly(0, STEPS, 0, STEPS);
            double area = of("selected", LayersTest::area);
            assertThat(area).isBetween(1000.0, 400 * 300 / 6.0);
            assertThat(of("grabbed", LayersTest::area)).isEqualTo(area);
        }
    }

    /** Lines across the pane, too, have little of it painted anew. */
    @Test
    void whatAHandDragsCoversLittleWhereItIsInLineWithAnother() {
        try (Gui gui = Gui.show(() -> pane, 400, 300)) {
            Point2D from = Gui.on(() -> pane.toPane(new Vec3(4, 4, 0)));
            Point2D to = Gui.on(() -> pane.toPane(new Vec3(6, 7, 0)));
            gui.moveTo(pane, from.getX(), from.getY());
            gui.press(MouseButton.PRIMARY);
            gui.moveTo(pane, to.getX() - 5, to.getY());
            gui.moveTo(pane, to.getX() + 1, to.getY() + 1);
            assertThat(guides()).hasSize(2)
                    .anySatisfy(line -> assertThat(line.getEndY() - line.getStartY()).isEqualTo(300)).anySatisfy(line -> assertThat(line.getEndX() - line.getStartX()).isEqualTo(400));
            assertThat(of("grabbed", LayersTest::area)).isLessThan(400 * 300 / 4.0);
            gui.release(MouseButton.PRIMARY);
            assertThat(guides()).isEmpty();
        }
    }

    private List<Line> guides() {
        return Gui.on(() -> pane.lookupAll(".guide").stream().filter(Node::isVisible).map(Line.class::cast).toList());
    }

    /** Of three thousand, lines are drawn by other means. */
    @ParameterizedTest
    @ValueSource(ints = {1000, 3000})
    void whereADragBeginsAndEndsTheRestIsMendedAndNotDrawnAnew(int count) {
        Gui.on(() -> {
            model.open(balls(count));
            return true;
        });
        try (Gui gui = Gui.show(() -> pane, 400, 300)) {
            gui.pulse();
            int[] before = pixels(gui);
            int drawings = of("rest", Layer::drawings);
            gui.act(() -> model.select(ScenePath.body(444)));
            Gesture drag = Gui.on(() -> model.begin(Label.of(Label.Edit.MOVE)));
            move(gui, drag, 1.37);
            move(gui, drag, 2.37);
            gui.act(drag::commit);
            gui.act(() -> model.select());
            assertThat(of("rest", Layer::drawings)).isEqualTo(drawings);
            int[] dragged = pixels(gui);
            gui.act(() -> pane.zoom(2));
            gui.act(() -> pane.zoom(0.5));
            assertThat(of("rest", Layer::drawings)).isEqualTo(drawings + 2);
            assertThat(differing(dragged, pixels(gui))).as("pixels that are otherwise when all is drawn anew").isZero();
            assertThat(differing(dragged, before)).as("pixels that are otherwise after the drag").isPositive();
            gui.act(() -> {
                model.undo();
                model.select();
            });
            assertThat(differing(before, pixels(gui))).as("pixels that are otherwise after undoing").isZero();
        }
    }

    /** As when what is dragged is deleted, or all that there is is put into a group, before the button is let go. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aDragMayEndWithFewerObjects(boolean isGrouped) {
        List<Throwable> faults = new CopyOnWriteArrayList<>();
        Gui.on(() -> {
            model.open(balls(2));
            return true;
        });
        try (Gui gui = Gui.show(() -> pane, 400, 300)) {
            gui.act(() -> Thread.currentThread().setUncaughtExceptionHandler((thread, fault) -> faults.add(fault)));
            gui.act(() -> model.select(isGrouped ? Set.of(ScenePath.body(0), ScenePath.body(1)) : Set.of(ScenePath.body(1))));
            Point2D from = Gui.on(() -> pane.toPane(Vec3.X));
            gui.moveTo(pane, from.getX(), from.getY());
            gui.press(MouseButton.PRIMARY);
            gui.moveTo(pane, from.getX() + 20, from.getY() + 20);
            gui.moveTo(pane, from.getX() + 40, from.getY() + 20);
            assertThat(Gui.on(() -> model.gesturingProperty().get())).isTrue();
            gui.act(() -> {
                if (isGrouped) {
                    pane.edits().combine(Csg.Operation.UNION);
                } else {
                    model.editState(Label.of(Label.Edit.DELETE), state -> Structure.delete(state, state.selection()));
                }
            });
            gui.release(MouseButton.PRIMARY);
            gui.act(() -> model.select());
            assertThat(model.scene().objects()).hasSize(1);
            assertThat(faults).isEmpty();
            int[] mended = pixels(gui);
            gui.act(() -> pane.zoom(2));
            gui.act(() -> pane.zoom(0.5));
            assertThat(differing(mended, pixels(gui))).as("pixels that are otherwise when all is drawn anew").isZero();
            gui.act(() -> Thread.currentThread().setUncaughtExceptionHandler(null));
        }
    }

    private static Scene balls(int count) {
        return Scene.EMPTY.withObjects(IntStream.range(0, count)
                .mapToObj(i -> SceneObject.of(new Sphere(0.3)).at(i % 10, i / 10 % 10, -Math.floorDiv(i, 100))).toList()).plus(Light.at(5, 5, 5));
    }

    @Test
    void nothingAroundIsLaidOutForWhatIsDrawn() {
        StackPane around = Gui.on(() -> new StackPane(pane));
        try (Gui gui = Gui.show(() -> around, 400, 300)) {
            gui.pulse();
            assertThat(Gui.on(() -> {
                model.select(ScenePath.body(444));
                return pane.isNeedsLayout() + " " + around.isNeedsLayout();
            })).isEqualTo("true false");
        }
    }

    /** As when panes are resized: JavaFX then does not look below what it has not been led to. */
    @Test
    void whatIsDrawnIsSeenAlsoBelowWhatAsksForALayoutInTheMiddleOfOne() {
        StackPane around = Gui.on(() -> new StackPane(pane));
        AtomicBoolean isLaidOut = new AtomicBoolean();
        StackPane whole = Gui.on(() -> new StackPane(around) {
            @Override
            public void requestLayout() {
                // While JavaFX lays it out, it does not hear.
                if (!isLaidOut.get()) {
                    super.requestLayout();
                }
            }
        });
        try (Gui gui = Gui.show(() -> whole, 400, 300)) {
            gui.pulse();
            Gui.on(() -> {
                isLaidOut.set(true);
                around.requestLayout();
                isLaidOut.set(false);
                return true;
            });
            int before = of("selected", Layer::drawings);
            gui.act(() -> model.select(ScenePath.body(444)));
            gui.pulse();
            assertThat(of("selected", Layer::drawings)).isGreaterThan(before);
        }
    }

    @Test
    void aDragLeavesThePictureOfWhatIsOpenedThere() {
        try (Gui gui = Gui.show(() -> pane, 400, 300)) {
            gui.act(() -> model.select(ScenePath.body(444)));
            Gesture drag = Gui.on(() -> model.begin(Label.of(Label.Edit.MOVE)));
            gui.pulse();
            for (int i = 1; i <= STEPS; i++) {
                move(gui, drag, 0.37 * i);
            }
            int[] dragged = pixels(gui);
            gui.act(() -> pane.zoom(2));
            gui.act(() -> pane.zoom(0.5));
            assertThat(differing(dragged, pixels(gui))).as("pixels that are otherwise when all is drawn anew").isZero();
            gui.act(drag::cancel);
            int[] cancelled = pixels(gui);
            gui.act(() -> model.select());
            gui.act(() -> model.select(ScenePath.body(444)));
            assertThat(differing(cancelled, pixels(gui))).as("pixels that are otherwise after the drag has been given up").isZero();
        }
    }

    @Test
    void allThatIsDraggedIsDrawnOnceAndMoved() {
        try (Gui gui = Gui.show(() -> pane, 400, 300)) {
            gui.act(() -> model.select(Stream.concat(Stream.of(ScenePath.light(0)), IntStream.range(0, 1000).mapToObj(ScenePath::body)).collect(Collectors.toSet())));
            Gesture drag = Gui.on(() -> model.begin(Label.of(Label.Edit.MOVE)));
            gui.pulse();
            int before = of("selected", Layer::drawings);
            for (int i = 1; i <= STEPS; i++) {
                move(gui, drag, 0.1 * i);
            }
            assertThat(of("selected", Layer::drawings) - before).isZero();
            double pixel = Gui.on(() -> pane.toPane(Vec3.X).getX() - pane.toPane(Vec3.ZERO).getX());
            assertThat(of("selected", Layer::getTranslateX)).isCloseTo(0.1 * STEPS * pixel, within(1e-6));
            assertThat(of("selected", Layer::getTranslateY)).isCloseTo(-0.05 * STEPS * pixel, within(1e-6));
            gui.act(drag::commit);
            assertThat(of("selected", Layer::getTranslateX)).isZero();
            assertThat(of("selected", Layer::drawings) - before).isEqualTo(1);
        }
    }

    private void move(Gui gui, Gesture drag, double by) {
        gui.act(() -> drag.preview(scene -> Moves.translated(scene, model.selection(), new Vec3(by, by / 2, 0))));
    }

    private static double area(Layer layer) {
        return layer.getBoundsInParent().getWidth() * layer.getBoundsInParent().getHeight();
    }

    private <T> T of(String name, Function<Layer, T> what) {
        return Gui.on(() -> what.apply((Layer) pane.lookup("." + name)));
    }

    private <T> List<T> ofAll(Function<Layer, T> what) {
        return NAMES.stream().map(name -> of(name, what)).toList();
    }

    private int[] pixels(Gui gui) {
        gui.pulse();
        WritableImage seen = Gui.on(() -> pane.snapshot(null, null));
        return IntStream.range(0, 400 * 300).map(i -> seen.getPixelReader().getArgb(i % 400, i / 400)).toArray();
    }

    private static long differing(int[] one, int[] other) {
        return IntStream.range(0, one.length).filter(i -> one[i] != other[i]).count();
    }
}
