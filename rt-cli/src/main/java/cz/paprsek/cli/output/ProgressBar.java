package cz.paprsek.cli.output;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.io.PlainText;
import cz.paprsek.render.RenderOptions;
import java.util.Locale;

/** Progress for somebody who watches: a bar with percentage, speed and time left in one line, which is gone when the render is over. */
public final class ProgressBar extends Progress {
    /** A terminal is at least so wide; asking for its width means starting another program. */
    private static final int COLUMNS = 79;
    private static final int LONGEST_NAME = 24;
    private static final int CELLS = 20;
    private static final long NANOS_BETWEEN = 100_000_000;

    private final Terminal terminal;
    private final String name;
    private final int raysPerPixel;
    private final long begin = System.nanoTime();
    private long drawn;

    ProgressBar(Terminal terminal, String scene, RenderOptions options, Stop stop) {
        super(options, stop);
        this.terminal = terminal;
        String printable = PlainText.of(scene, Integer.MAX_VALUE);
        name = printable.length() <= LONGEST_NAME ? printable : "..." + printable.substring(printable.length() - LONGEST_NAME + 3);
        raysPerPixel = options.settings().samples() * options.settings().samples();
        draw(name);
    }

    @Override
    void show(long done, long total) {
        long elapsed = System.nanoTime() - begin;
        if (elapsed >= drawn + NANOS_BETWEEN) {
            drawn = elapsed;
            double seconds = elapsed / 1e9;
            draw(line(name, (double) done / total, done * raysPerPixel / seconds, seconds * (total - done) / done));
        }
    }

    @Override
    public void close() {
        draw("");
        terminal.err().print('\r');
        terminal.err().flush();
    }

    /** One line, such as {@code glass.xml  42 % [########            ]  1.3 M eye rays/s  0:08 left}. */
    public static String line(String name, double share, double eyeRaysPerSecond, double secondsLeft) {
        int full = (int) (share * CELLS);
        long left = Math.min((long) Math.ceil(secondsLeft), 359_999);
        String clock = left < 3600 ? String.format(Locale.ROOT, "%d:%02d", left / 60, left % 60)
                : String.format(Locale.ROOT, "%d:%02d:%02d", left / 3600, left / 60 % 60, left % 60);
        return String.format(Locale.ROOT, "%s %3d %% [%s%s] %.1f M eye rays/s  %s left", name, (int) (share * 100),
                "#".repeat(full), " ".repeat(CELLS - full), eyeRaysPerSecond / 1e6, clock);
    }

    private void draw(String line) {
        terminal.err().print("\r" + line + " ".repeat(Math.max(0, COLUMNS - line.length())));
        terminal.err().flush();
    }
}
