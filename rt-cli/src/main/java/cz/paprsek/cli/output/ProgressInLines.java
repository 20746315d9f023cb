package cz.paprsek.cli.output;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.render.RenderOptions;
import java.util.Locale;

/** Progress for a log file: a line at the start, then one every ten seconds. */
final class ProgressInLines extends Progress {
    private static final double SECONDS_BETWEEN = 10;

    private final Terminal terminal;
    private final String scene;
    private double said;

    ProgressInLines(Terminal terminal, String scene, RenderOptions options, Stop stop) {
        super(options, stop);
        this.terminal = terminal;
        this.scene = scene;
        terminal.message(scene + ": rendering " + options.region().width() + "x" + options.region().height() + " on "
                + options.threads() + (options.threads() == 1 ? " thread" : " threads"));
    }

    @Override
    void showDenoising(double seconds) {
        terminal.message(String.format(Locale.ROOT, "%s: traced after %.0f s, taking the noise out", scene, seconds));
    }

    @Override
    void show(Pace pace, double seconds) {
        if (pace.share() < 1 && seconds >= said + SECONDS_BETWEEN) {
            said = seconds;
            double left = pace.secondsLeft(seconds);
            terminal.message(String.format(Locale.ROOT, "%s: %d %% after %.0f s", scene, (int) (100 * pace.share()), seconds)
                    + (Double.isNaN(left) ? "" : String.format(Locale.ROOT, ", about %.0f s left", left)));
        }
    }
}
