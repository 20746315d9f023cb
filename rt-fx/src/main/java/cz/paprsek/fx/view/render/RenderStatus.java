package cz.paprsek.fx.view.render;

import cz.paprsek.fx.view.texts.Texts;
import cz.paprsek.io.Failures;
import cz.paprsek.render.RenderResult.Certainty;
import java.util.Locale;
import java.util.Optional;
import javafx.concurrent.Worker;

/** Says how far a render is, or how it ended. */
final class RenderStatus {
    private final Texts texts;

    RenderStatus(Texts texts) {
        this.texts = texts;
    }

    /** @param certainty how near its pixels are to the truth, once that is known */
    String of(Worker.State state, RenderProgress progress, Optional<Certainty> certainty, Optional<Throwable> fault) {
        return switch (state) {
            case READY, SCHEDULED -> texts.of("render.waiting");
            case RUNNING -> progress.isDenoising()
                    ? texts.of("render.denoising", time(progress.elapsedSeconds()))
                    : texts.of("render.running", percent(progress), time(progress.elapsedSeconds()), time(progress.remainingSeconds()), speed(progress));
            case SUCCEEDED -> texts.of("render.done", time(progress.elapsedSeconds()), speed(progress)) + certainty.map(this::known).orElse("");
            case CANCELLED -> texts.of("render.cancelled", percent(progress), time(progress.elapsedSeconds()));
            case FAILED -> texts.of("render.failed", fault.map(Failures::sentence).map(texts::sentence).orElse(""));
        };
    }

    /** How far a render is that has not ended. */
    String inShort(Worker.State state, RenderProgress progress) {
        if (state != Worker.State.RUNNING) {
            return texts.of("render.waiting");
        }
        return progress.isDenoising()
                ? texts.of("render.denoising", time(progress.elapsedSeconds()))
                : texts.of("render.queue.running", percent(progress), time(progress.remainingSeconds()));
    }

    private String known(Certainty certainty) {
        return " · " + texts.of("render.certainty", percent(certainty.within()), String.format(texts.locale(), "%.4f", certainty.farthest()))
                + (certainty.untrusted() > 0 ? " · " + texts.of("render.untrusted", percent(certainty.untrusted())) : "");
    }

    private String percent(double share) {
        return String.format(texts.locale(), "%.2f", 100 * share);
    }

    private static String percent(RenderProgress progress) {
        return Integer.toString((int) (100 * progress.share()));
    }

    private String speed(RenderProgress progress) {
        return String.format(texts.locale(), "%.2f", progress.raysPerSecond() / 1e6);
    }

    /** Seconds below a minute, else minutes or hours as a clock shows them. */
    private String time(double seconds) {
        if (Double.isNaN(seconds)) {
            return "–";
        }
        if (seconds < 60) {
            return String.format(texts.locale(), "%.1f s", seconds);
        }
        long whole = Math.round(seconds);
        return whole < 3600
                ? String.format(Locale.ROOT, "%d:%02d min", whole / 60, whole % 60)
                : String.format(Locale.ROOT, "%d:%02d:%02d h", whole / 3600, whole / 60 % 60, whole % 60);
    }
}
