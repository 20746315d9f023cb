package cz.paprsek.cli.output;

import cz.paprsek.cli.process.Columns;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.io.PlainText;
import cz.paprsek.render.RenderOptions;
import cz.paprsek.scene.RenderSettings;
import java.util.Locale;

/** Progress for somebody who watches: a bar with percentage, speed and time left in one line, which is gone when the render is over. */
public final class ProgressBar extends Progress {
    private static final int LONGEST_NAME = 24;
    private static final int CELLS = 20;
    private static final String DENOISING = "traced; taking the noise out";
    /** The terminal is asked for its width each time, which costs milliseconds. */
    private static final double SECONDS_BETWEEN = 0.5;

    private final Terminal terminal;
    private final String name;
    private final int raysPerPixel;
    private int columns = Columns.USUAL;
    private double drawn = Double.NEGATIVE_INFINITY;
    private int width;

    ProgressBar(Terminal terminal, String scene, RenderOptions options, Stop stop) {
        super(options, stop);
        this.terminal = terminal;
        name = PlainText.of(scene, Integer.MAX_VALUE);
        raysPerPixel = options.isInPasses() ? Math.min(RenderSettings.USUAL_PATHS, options.settings().samples()) : options.settings().samples() * options.settings().samples();
        refresh();
    }

    @Override
    void show(Pace pace, double seconds) {
        if (seconds < drawn + SECONDS_BETWEEN) {
            return;
        }
        drawn = seconds;
        columns = Columns.ofTerminal();
        draw(line(columns, name, pace.share(), pace.pixelsPerSecond(seconds) * raysPerPixel, pace.secondsLeft(seconds)));
    }

    @Override
    void showDenoising(double seconds) {
        draw(denoising(Columns.ofTerminal(), name));
    }

    /** One line, as much of it as there is room for. */
    static String denoising(int columns, String name) {
        int room = Math.min(LONGEST_NAME, columns - 2 - DENOISING.length());
        return room > 0 ? Columns.end(name, room) + " " + DENOISING : DENOISING.length() < columns ? DENOISING : "";
    }

    @Override
    public synchronized void close() {
        draw("");
        terminal.err().print('\r');
        terminal.err().flush();
    }

    /**
     * One line, such as {@code glass.xml  42 % [########            ]  1.3 M eye rays/s  0:08 left}. The last column stays free: many a
     * terminal begins a new line when it is written to. Where there is no room, the bar, the speed and the name go first.
     */
    static String line(int columns, String name, double share, double eyeRaysPerSecond, double secondsLeft) {
        int full = (int) (share * CELLS);
        String percent = String.format(Locale.ROOT, "%3d %%", (int) (share * 100));
        String bar = String.format(" [%s%s]", "#".repeat(full), " ".repeat(CELLS - full));
        String speed = Double.isNaN(eyeRaysPerSecond) ? "" : String.format(Locale.ROOT, " %.1f M eye rays/s", eyeRaysPerSecond / 1e6);
        String left = Double.isNaN(secondsLeft) ? "" : "  " + clock(secondsLeft) + " left";
        for (String rest : new String[] {percent + bar + speed + left, percent + bar + left, percent + left, percent}) {
            int room = Math.min(LONGEST_NAME, columns - 2 - Columns.of(rest));
            if (room >= Math.min(LONGEST_NAME / 2, Columns.of(name))) {
                return Columns.end(name, room) + " " + rest;
            }
        }
        return percent.length() < columns ? percent : "";
    }

    private static String clock(double secondsLeft) {
        long left = Math.min((long) Math.ceil(secondsLeft), 359_999);
        return left < 3600 ? String.format(Locale.ROOT, "%d:%02d", left / 60, left % 60)
                : String.format(Locale.ROOT, "%d:%02d:%02d", left / 3600, left / 60 % 60, left % 60);
    }

    private void draw(String line) {
        int before = Math.min(width, columns - 1);
        width = Columns.of(line);
        terminal.err().print("\r" + line + " ".repeat(Math.max(0, before - width)));
        terminal.err().flush();
    }
}
