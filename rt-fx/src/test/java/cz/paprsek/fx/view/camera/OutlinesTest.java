package cz.paprsek.fx.view.camera;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.drawing.CameraView;
import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.model.EditorState;
import cz.paprsek.fx.view.look.Strokes;
import cz.paprsek.fx.view.rays.BodyOutline;
import cz.paprsek.fx.view.rays.BodyOutline.Look;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Light;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.scene.ScenePath.BodyAt;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javafx.scene.SnapshotParameters;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What lies above what, in a picture of 200 × 150 of a union of balls with a light among them. */
class OutlinesTest {
    private static final int WIDTH = 200;
    private static final int HEIGHT = 150;
    private static final int ORANGE = 0xFFFF9B3D;
    private static final Camera CAMERA = Camera.looking(new Vec3(0, 0, 60), new Vec3(0, 0, -1));
    private static final BodyAt UNION = ScenePath.body(0);
    private static final BodyAt FIRST = UNION.child(0);

    private static Scene balls(int count) {
        SplittableRandom random = new SplittableRandom(7);
        Stream<Operand> first = Stream.of(Operand.of(new Sphere(8)).at(-12, 0, 0));
        Stream<Operand> others = IntStream.range(1, count).mapToObj(i -> Operand.of(new Sphere(3)).at(40 * random.nextDouble() - 20, 30 * random.nextDouble() - 15, 0));
        return Scene.EMPTY.plus(SceneObject.of(new Csg(Csg.Operation.UNION, Stream.concat(first, others).toList()))).plus(Light.at(-12, 8, 0));
    }

    /** Of three thousand, lines are drawn by other means. */
    @ParameterizedTest
    @ValueSource(ints = {100, 3000})
    void whatIsSelectedLiesAboveItsSiblingsAndLightsAboveAll(int count) {
        Scene scene = balls(count);
        CameraView view = new CameraView(CAMERA, WIDTH, HEIGHT);
        int[] alone = drawn(g -> {
            if (count > Strokes.MANY) {
                BodyOutline.draw(g, view::line, CAMERA, scene, List.of(FIRST), Look.STRONG);
            } else {
                BodyOutline.draw(g, view::line, CAMERA.position(), scene, FIRST, Look.STRONG);
            }
        });
        assertAbove(alone, selected(scene, Set.of(FIRST)), 50);
        assertAbove(selected(scene, Set.of(ScenePath.light(0))), selected(scene, Set.of(ScenePath.light(0), FIRST)), 20);
    }

    private static void assertAbove(int[] alone, int[] all, int least) {
        List<Integer> places = IntStream.range(0, alone.length).filter(i -> alone[i] == ORANGE).boxed().toList();
        assertThat(places).hasSizeGreaterThanOrEqualTo(least).allMatch(i -> all[i] == ORANGE);
    }

    @Test
    void ofManyOperandsThatAreSelectedEachIsDrawnOnce() {
        Scene scene = balls(3000);
        Map<Look, List<BodyAt>> drawn = Outlines.drawn(state(scene, IntStream.range(0, 1000).mapToObj(UNION::child).collect(Collectors.toSet())));
        assertThat(drawn).containsOnlyKeys(Look.STRONG, Look.BASE);
        assertThat(drawn.get(Look.STRONG)).hasSize(1000);
        assertThat(drawn.get(Look.BASE)).hasSize(2000).doesNotContainAnyElementsOf(drawn.get(Look.STRONG));
        assertThat(Outlines.drawn(state(scene, Set.of(UNION, FIRST))).get(Look.BASE)).hasSize(2999);
    }

    private static EditorState state(Scene scene, Set<? extends ScenePath> selected) {
        EditorModel model = new EditorModel(scene);
        model.select(selected);
        return model.state();
    }

    private static int[] selected(Scene scene, Set<ScenePath> selected) {
        return drawn(g -> new Outlines(g, state(scene, selected), CAMERA, new Extent(g.getCanvas())).selected());
    }

    private static int[] drawn(Consumer<GraphicsContext> drawing) {
        return Gui.on(() -> {
            Canvas canvas = new Canvas(WIDTH, HEIGHT);
            drawing.accept(canvas.getGraphicsContext2D());
            SnapshotParameters onNothing = new SnapshotParameters();
            onNothing.setFill(Color.TRANSPARENT);
            WritableImage seen = canvas.snapshot(onNothing, null);
            return IntStream.range(0, WIDTH * HEIGHT).map(i -> seen.getPixelReader().getArgb(i % WIDTH, i / WIDTH)).toArray();
        });
    }
}
