package cz.paprsek.cli;

import cz.paprsek.render.RenderOptions;
import java.util.Locale;
import me.tongfei.progressbar.DelegatingProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

/** Progress for somebody who watches: a bar with percentage, time left and speed, gone when the render is over. */
final class ProgressBarOnTerminal extends Progress {
    /** A terminal is at least so wide; asking for its width would cost more time than many a render takes. */
    private static final int COLUMNS = 79;
    private static final int LONGEST_NAME = 24;
    private static final int MILLIS_BETWEEN = 100;

    private final Terminal terminal;
    private final ProgressBar bar;
    private final int raysPerPixel;
    private final long begin = System.nanoTime();

    ProgressBarOnTerminal(Terminal terminal, String scene, RenderOptions options, Stop stop) {
        super(options, stop);
        this.terminal = terminal;
        raysPerPixel = options.settings().samples() * options.settings().samples();
        String name = Printable.line(scene);
        bar = new ProgressBarBuilder()
                .setTaskName(name.length() <= LONGEST_NAME ? name : "..." + name.substring(name.length() - LONGEST_NAME + 3))
                .setInitialMax((long) options.region().width() * options.region().height())
                .setStyle(ProgressBarStyle.ASCII)
                .setUpdateIntervalMillis(MILLIS_BETWEEN)
                // Not the library's own console: it starts other processes to learn about the terminal.
                .setConsumer(new DelegatingProgressBarConsumer(this::draw, COLUMNS))
                .build();
    }

    @Override
    void show(long done, long total) {
        double seconds = (System.nanoTime() - begin) / 1e9;
        bar.stepTo(done);
        bar.setExtraMessage(String.format(Locale.ROOT, "%.1f M eye rays/s", done * raysPerPixel / 1e6 / Math.max(seconds, 1e-3)));
    }

    @Override
    public void close() {
        bar.close();
        draw(" ".repeat(COLUMNS));
        draw("");
    }

    private void draw(String line) {
        terminal.err().print("\r" + line);
        terminal.err().flush();
    }
}
