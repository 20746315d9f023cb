package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.picture.PicturePoint;
import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.image.Image;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.render.RenderResult;
import cz.paprsek.render.RenderResult.Outcome;
import cz.paprsek.render.Renderer;
import cz.paprsek.render.Tile;
import cz.paprsek.render.mode.RenderMode;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import javafx.application.Platform;

/**
 * The number that a pixel's colour stands for, such as a depth or a count: of the one pixel, rendered alone as a number, since no pixel depends on any other. Of questions that
 * come faster than answers only the last is answered.
 */
final class ModeValue {
    private static final double STEPS = 255;

    private final Texts texts;
    private final RenderOptions options;
    private final AtomicLong asked = new AtomicLong();

    /** @param options of the whole picture */
    ModeValue(Texts texts, RenderOptions options) {
        this.texts = texts;
        this.options = options;
    }

    /** Whether colours stand for something else than colours. */
    static boolean isOf(RenderMode mode) {
        return mode.isNumber() || mode == RenderMode.NORMALS;
    }

    /** Forgets what was asked. */
    void stop() {
        asked.incrementAndGet();
    }

    /** Asks what a pixel's colour stands for. The answer, in words, comes on JavaFX's thread, unless something else is asked before. */
    void ask(PicturePoint point, Consumer<String> answer) {
        long number = asked.incrementAndGet();
        RenderOptions pixel = options.withRegion(new Tile(point.column(), point.row(), 1, 1)).withThreads(1);
        RenderMonitor monitor = new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return asked.get() != number;
            }
        };
        RenderDesk.start(() -> {
            RenderResult result = Renderer.render(point.scene(), options.mode().isNumber() ? pixel.withNumbers() : pixel, monitor);
            if (result.outcome() == Outcome.DONE) {
                String words = words(result.image());
                Platform.runLater(() -> Optional.of(words).filter(all -> asked.get() == number).ifPresent(answer));
            }
        }, "paprsek-pixel");
    }

    private String words(Image pixel) {
        double value = pixel.red(0, 0);
        return switch (options.mode()) {
            case NORMALS -> pixel.argb(0, 0) << 8 == 0 ? "" : texts.of("picture.normal", side(pixel, 16), side(pixel, 8), side(pixel, 0));
            case DEPTH -> value > 0 ? texts.of("picture.depth", decimal("%.4f", value)) : texts.of("picture.no-depth");
            case ERROR -> value < 0 ? texts.of("picture.untrusted") : texts.of("picture.error", decimal("%.3f", value * STEPS));
            case RAYS -> texts.of("picture.rays", decimal("%.0f", value));
            case NODES -> texts.of("picture.nodes", decimal("%.0f", value));
            case SAMPLES -> texts.of("picture.samples", decimal("%.0f", value));
            default -> "";
        };
    }

    /** A component of a normal, whose colour is as fine as 1/127. */
    private String side(Image pixel, int shift) {
        return decimal("%.2f", (pixel.argb(0, 0) >> shift & 255) / (STEPS / 2) - 1);
    }

    private String decimal(String format, double value) {
        return String.format(texts.locale(), format, value);
    }
}
