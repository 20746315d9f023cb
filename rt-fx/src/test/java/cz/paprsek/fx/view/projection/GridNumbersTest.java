package cz.paprsek.fx.view.projection;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import cz.paprsek.fx.model.EditorModel;
import cz.paprsek.fx.view.command.Edits;
import cz.paprsek.fx.view.look.Theme;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.math.Vec3;
import cz.paprsek.scene.Scene;
import cz.paprsek.scene.SceneObject;
import cz.paprsek.scene.ScenePath;
import cz.paprsek.shape.Block;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.BoundingBox;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.image.WritableImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The numbers of the grid of a pane of 400 × 300, where something selected is as wide as the pane and its upper side lies in y = 0. */
class GridNumbersTest {
    private static final Bounds PANE = new BoundingBox(0, 0, 400, 300);

    private final EditorModel model = new EditorModel(Scene.EMPTY.plus(SceneObject.of(new Block(new Vec3(-500, -500, -1), new Vec3(500, 0, 1)))));

    @Test
    void areNotStruckThroughByWhatIsSelected() {
        ProjectionPane pane = Gui.on(() -> new ProjectionPane(new Edits(model, Texts.in(Locale.ENGLISH)), Axes.FRONT, new SimpleObjectProperty<>(Theme.LIGHT),
                new SimpleBooleanProperty(true), new SimpleBooleanProperty(true)));
        try (Gui gui = Gui.show(() -> pane, 400, 300)) {
            gui.act(() -> model.select(ScenePath.body(0)));
            gui.act(() -> pane.zoom(1.4));
            gui.pulse();
            WritableImage seen = Gui.on(() -> pane.snapshot(null, null));
            Point2D zero = Gui.on(() -> pane.toPane(Vec3.ZERO));
            assertThat(zero.getY()).isBetween(20.0, 270.0);
            assertThat(selected(seen, 60, 120, zero.getY())).as("the side").isGreaterThan(50);
            assertThat(selected(seen, 2, 8, zero.getY())).as("on the number").isZero();
        }
    }

    /** Of a camera that stands on an axis, or close to it, and of lights, wherever along the rim; the axes in the middle, at each edge and beyond. */
    @ParameterizedTest
    @EnumSource(Axes.class)
    void lettersOfTheAxesKeepOffSignsAndWithinThePane(Axes axes) {
        for (double x : new double[] {-90, -1, 0, 6, 188, 394, 400, 401, 490}) {
            assertLettersAreSeen(axes, x, 142);
        }
        for (double y : new double[] {-90, -1, 0, 6, 294, 300, 301, 390}) {
            assertLettersAreSeen(axes, 188, y);
        }
    }

    private static void assertLettersAreSeen(Axes axes, double axisX, double axisY) {
        Viewport view = new Viewport((200 - axisX) / 40, (axisY - 150) / 40, 40, 400, 300);
        assertThat(new Point2D(view.x(0), view.y(0))).isEqualTo(new Point2D(axisX, axisY));
        List<Bounds> alone = Grid.letters(view, axes, List.of());
        List<Bounds> hiding = new ArrayList<>();
        int moved = 0;
        for (int x = 0; x <= 400; x += 4) {
            for (int y = 0; y <= 300; y += 4) {
                Bounds sign = new BoundingBox(x - 9, y - 9, 18, 18);
                List<Bounds> letters = Grid.letters(view, axes, List.of(sign));
                if (letters.stream().anyMatch(letter -> sign.intersects(letter) || !PANE.contains(letter))) {
                    hiding.add(sign);
                }
                moved += letters.equals(alone) ? 0 : 1;
            }
        }
        assertThat(hiding).as("signs that letters of axes at %s, %s do not keep off, or leave the pane for", axisX, axisY).isEmpty();
        assertThat(moved).isPositive();
    }

    /** How many of the columns have a pixel of a selected body near a row. */
    private static long selected(WritableImage seen, int from, int to, double row) {
        return IntStream.range(from, to).filter(x -> IntStream.rangeClosed((int) row - 3, (int) row + 3)
                .anyMatch(y -> seen.getPixelReader().getColor(x, y).equals(Theme.LIGHT.palette().selected()))).count();
    }
}
