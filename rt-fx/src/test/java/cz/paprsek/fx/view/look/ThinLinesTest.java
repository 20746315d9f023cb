package cz.paprsek.fx.view.look;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.fx.Gui;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import javafx.geometry.BoundingBox;
import javafx.scene.SnapshotParameters;
import javafx.scene.canvas.Canvas;
import javafx.scene.image.WritableImage;
import javafx.scene.paint.Color;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ThinLinesTest {
    private static final int SIZE = 100;

    @ParameterizedTest
    @CsvSource({"1.2, 0", "1.2, 20", "1.8, 40", "3, 51", "4, 100", "1.8, 200", "3, 271"})
    void aLineCoversItsLengthTimesItsWidthAndTwoHalvesOfADisc(double lineWidth, double degrees) {
        double length = 60;
        double x = 50.3 - length / 2 * Math.cos(Math.toRadians(degrees));
        double y = 49.8 - length / 2 * Math.sin(Math.toRadians(degrees));
        double covered = IntStream.of(drawn(lineWidth, Color.BLACK, lines -> {
            lines.moveTo(x, y);
            lines.lineTo(100.6 - x, 99.6 - y);
        })).mapToDouble(argb -> (argb >>> 24) / 255.0).sum();
        assertThat(covered).isCloseTo(length * lineWidth + Math.PI * lineWidth * lineWidth / 4, within(0.01 * length * lineWidth));
    }

    @Test
    void whatIsOnThePictureIsInItsPlaceAndColorAndTheRestIsLeftOut() {
        int[] pixels = drawn(2, Color.web("#ff9b3d"), lines -> {
            lines.moveTo(-1e9, 50);
            lines.lineTo(1e9, 50);
            lines.moveTo(20, -300);
            lines.lineTo(20, -200);
        });
        IntStream.range(0, SIZE * SIZE).forEach(i -> assertThat(pixels[i]).as("pixel " + i % SIZE + " " + i / SIZE)
                .isEqualTo(i / SIZE == 49 || i / SIZE == 50 ? 0xFFFF9B3D : 0));
    }

    @Test
    void nothingWouldBeSeenAnyMoreWhereAllIsCovered() {
        drawn(3, Color.RED, lines -> {
            assertThat(lines.hides(22, 22, 38, 38)).isFalse();
            for (int i = 20; i < 40; i++) {
                lines.moveTo(20, i);
                lines.lineTo(40, i);
            }
            assertThat(lines.hides(22, 22, 38, 38)).isTrue();
            assertThat(lines.hides(22, 22, 50, 38)).isFalse();
            assertThat(lines.hides(-50, -50, -10, -10)).as("beside the picture").isTrue();
        });
    }

    /** As of a screen at 125 %. */
    @ParameterizedTest
    @CsvSource({"1, 1", "2, 1", "1.25, 4", "1.5, 2", "1.75, 4", "1.2000000476837158, 5", "1.2345, "})
    void aSquareOfWholePixelsOfTheScreenIsFound(double pixels, @Nullable Integer size) {
        assertThat(Strokes.square(pixels)).isEqualTo(size == null ? OptionalInt.empty() : OptionalInt.of(size));
    }

    private static int[] drawn(double lineWidth, Color color, Consumer<Strokes> drawing) {
        return Gui.on(() -> {
            Canvas canvas = new Canvas(SIZE, SIZE);
            Strokes lines = Strokes.on(canvas.getGraphicsContext2D(), new BoundingBox(0, 0, SIZE, SIZE), lineWidth, color, true);
            drawing.accept(lines);
            lines.end();
            SnapshotParameters onNothing = new SnapshotParameters();
            onNothing.setFill(Color.TRANSPARENT);
            WritableImage seen = canvas.snapshot(onNothing, null);
            return IntStream.range(0, SIZE * SIZE).map(i -> seen.getPixelReader().getArgb(i % SIZE, i / SIZE)).toArray();
        });
    }
}
