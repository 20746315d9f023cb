package cz.paprsek.fx.view.render;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.view.texts.Texts;
import java.util.Locale;
import java.util.Optional;
import javafx.concurrent.Worker;
import org.junit.jupiter.api.Test;

/** What is said of a render is true of what it does just then. */
class RenderStatusTest {
    private static final RenderProgress TRACED = new RenderProgress(8, 8, 20, 4, 6_000_000, true, true);

    private final RenderStatus status = new RenderStatus(Texts.in(Locale.ENGLISH));

    @Test
    void whileTheNoiseIsTakenOutNoTimeIsPromised() {
        assertThat(status.of(Worker.State.RUNNING, TRACED, Optional.empty(), Optional.empty())).isEqualTo("Traced; taking the noise out · 20.0 s");
        assertThat(status.inShort(Worker.State.RUNNING, TRACED)).isEqualTo("Traced; taking the noise out · 20.0 s");
    }

    @Test
    void raysAreCountedForTheTimeTheyTook() {
        assertThat(status.of(Worker.State.SUCCEEDED, TRACED, Optional.empty(), Optional.empty())).isEqualTo("Done in 20.0 s · 1.50 million rays/s");
        RenderProgress halfWay = new RenderProgress(4, 8, 2, 2, 3_000_000, true, false);
        assertThat(status.of(Worker.State.RUNNING, halfWay, Optional.empty(), Optional.empty())).isEqualTo("50 % · 2.0 s · 2.0 s left · 1.50 million rays/s");
        assertThat(status.inShort(Worker.State.RUNNING, halfWay)).isEqualTo("50 % · 2.0 s left");
    }
}
