package cz.paprsek.fx.view.projection;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Csg;
import cz.paprsek.shape.Operand;
import cz.paprsek.shape.Sphere;
import java.lang.management.ManagementFactory;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javafx.geometry.BoundingBox;
import javafx.scene.canvas.Canvas;
import org.junit.jupiter.api.Test;

class PainterTest {
    private static final int WIDTH = 800;
    private static final int HEIGHT = 600;
    /** Of a picture of thin lines, bytes: how much of it is covered, colours, and the picture itself. */
    private static final long PICTURE = WIDTH * HEIGHT * (1L + 4 + 4);

    @Test
    void besideOperandsThatAreSelectedAllOthersAreOnePicture() {
        EditorModel model = new EditorModel(Scene.EMPTY.plus(SceneObject.of(new Csg(Csg.Operation.UNION, IntStream.range(0, 2100)
                .mapToObj(i -> Operand.of(new Sphere(0.3)).at(i % 50, Math.floorDiv(i, 50), 0)).toList()))));
        Gui.on(() -> {
            model.select(IntStream.range(0, 20).mapToObj(i -> ScenePath.body(0).child(i)).collect(Collectors.toSet()));
            return true;
        });
        drawn(model);
        assertThat(drawn(model) / PICTURE).isOne();
    }

    @Test
    void aPartIsMadeOfWholeSquares() {
        assertThat(Viewport.whole(new BoundingBox(5.2, 3.9, 1, 2), 4)).isEqualTo(new BoundingBox(4, 0, 4, 8));
        assertThat(Viewport.whole(new BoundingBox(5.2, 3.9, 1, 2), 1)).isEqualTo(new BoundingBox(5, 3, 2, 3));
    }

    /** Bytes that are taken where figures are known. */
    private static long drawn(EditorModel model) {
        return Gui.on(() -> {
            Figures figures = new Figures(Axes.FRONT);
            figures.show(model.scene(), false);
            figures.of(0);
            Painter painter = new Painter(new Canvas(WIDTH, HEIGHT).getGraphicsContext2D(), new Viewport(25, 20, 12, WIDTH, HEIGHT), Axes.FRONT, Theme.LIGHT.palette());
            ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
            long before = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
            painter.selected(model.state(), figures);
            return threads.getThreadAllocatedBytes(Thread.currentThread().getId()) - before;
        });
    }
}
