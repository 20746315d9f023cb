package cz.paprsek.render;

import cz.paprsek.image.Image;
import cz.paprsek.image.Layers;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;

/**
 * A monitor with somebody else beside it who may cancel.
 *
 * @param own is told all
 * @param also whether to stop
 */
record AskingMonitor(RenderMonitor own, BooleanSupplier also) implements RenderMonitor {
    @Override
    public boolean cancelled() {
        return also.getAsBoolean() || own.cancelled();
    }

    @Override
    public boolean wantsRows() {
        return own.wantsRows();
    }

    @Override
    public void traced(long rays) {
        own.traced(rays);
    }

    @Override
    public void found(Tile tile, Image image, int done, int total) {
        own.found(tile, image, done, total);
    }

    @Override
    public void finished(Tile tile, Image image, int done, int total) {
        own.finished(tile, image, done, total);
    }

    @Override
    public boolean passed(Image image, Supplier<Layers> layers, int passes) {
        return own.passed(image, layers, passes);
    }
}
