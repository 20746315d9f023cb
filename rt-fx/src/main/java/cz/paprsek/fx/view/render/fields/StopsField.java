package cz.paprsek.fx.view.render.fields;

import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.scene.RenderSettings;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/** A field for an exposure. Up and down change it by thirds of a stop, as cameras do. */
public final class StopsField extends RealField {
    private static final int STEPS = 3;

    public StopsField(String id, Texts texts) {
        super(id, texts.of("render.exposure.hint"), texts.of("render.exposure.hint") + " (±" + RenderSettings.MOST_STOPS + ")", texts,
                stops -> Math.abs(stops) <= RenderSettings.MOST_STOPS, 0);
        addEventFilter(KeyEvent.KEY_PRESSED, this::step);
    }

    private void step(KeyEvent event) {
        int by = event.getCode() == KeyCode.UP ? 1 : event.getCode() == KeyCode.DOWN ? -1 : 0;
        if (by != 0) {
            double thirds = validProperty().get() ? Math.rint(STEPS * get()) + by : 0;
            set(Math.max(-RenderSettings.MOST_STOPS, Math.min(RenderSettings.MOST_STOPS, Math.rint(thirds * 1000 / STEPS) / 1000)));
            event.consume();
        }
    }
}
