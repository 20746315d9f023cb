package cz.paprsek.fx.view.rays;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.drawing.CameraView;
import cz.paprsek.fx.Gui;
import cz.paprsek.fx.view.rays.BodyOutline.Look;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Body;
import cz.paprsek.scene.Camera;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Sphere;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
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

/** Outlines above a picture of 200 × 150. */
class BodyOutlineTest {
    private static final int WIDTH = 200;
    private static final int HEIGHT = 150;
    private static final Camera CAMERA = Camera.looking(new Vec3(0, 0, 60), new Vec3(0, 0, -1));

    private final AtomicInteger asked = new AtomicInteger();
    private final CameraView view = new CameraView(CAMERA, WIDTH, HEIGHT);
    private final RayPainter.Mapping picture = (from, to) -> {
        asked.incrementAndGet();
        return view.line(from, to);
    };

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatLiesWhereAllIsCoveredIsPassedOver(boolean isOneGroup) {
        int some = asked(20_000, isOneGroup);
        int more = asked(60_000, isOneGroup);
        // Where each is, is asked; of those that are passed over, nothing else.
        assertThat(more - some).isBetween(40_000, 45_000);
    }

    private int asked(int count, boolean isOneGroup) {
        SplittableRandom random = new SplittableRandom(7);
        List<SceneObject> balls = IntStream.range(0, count)
                .mapToObj(i -> SceneObject.of(new Sphere(0.8)).at(80 * random.nextDouble() - 40, 60 * random.nextDouble() - 30, 0)).toList();
        Scene scene = Scene.EMPTY.withObjects(isOneGroup
                ? List.of(SceneObject.of(new Csg(Csg.Operation.UNION, balls.stream().map(ball -> Body.of(ball).toOperand()).toList()))) : balls);
        asked.set(0);
        drawn(g -> BodyOutline.draw(g, picture, CAMERA, scene, IntStream.range(0, scene.objects().size()).mapToObj(ScenePath::body).toList(), Look.STRONG));
        return asked.get();
    }

    @Test
    void manyAreWhereEachIs() {
        List<SceneObject> balls = IntStream.range(0, 12).mapToObj(i -> SceneObject.of(new Sphere(1 + i / 4.0)).at(12 * (i % 4) - 18, 12 * (i / 4) - 12, -i)).toList();
        Scene scene = Scene.EMPTY.withObjects(balls);
        int[] each = drawn(g -> ScenePath.bodies(scene).forEach(at -> BodyOutline.draw(g, picture, CAMERA.position(), scene, at, Look.STRONG)));
        int[] many = drawn(g -> BodyOutline.draw(g, picture, CAMERA, scene, ScenePath.bodies(scene).toList(), Look.STRONG));
        double off = IntStream.range(0, each.length).mapToDouble(i -> difference(each[i], many[i])).sum();
        double all = IntStream.of(each).mapToDouble(argb -> difference(argb, 0)).sum();
        assertThat(all).isGreaterThan(1000);
        assertThat(off / all).isLessThan(0.25);
    }

    private static double difference(int one, int other) {
        return Stream.of(24, 16, 8, 0).mapToInt(shift -> Math.abs((one >>> shift & 0xFF) - (other >>> shift & 0xFF))).sum() / 255.0;
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
