package cz.paprsek.render;

import java.util.function.BooleanSupplier;

/**
 * A monitor with somebody else beside it who may cancel.
 *
 * @param own is told all
 * @param also whether to stop
 */
record AskingMonitor(RenderMonitor own, BooleanSupplier also) implements RenderMonitor.PassingOn {
    @Override
    public boolean cancelled() {
        return also.getAsBoolean() || own.cancelled();
    }
}
