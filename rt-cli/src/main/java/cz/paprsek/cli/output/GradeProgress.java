package cz.paprsek.cli.output;

import cz.paprsek.cli.process.Columns;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.io.PlainText;
import cz.paprsek.teach.grade.Grader;

/** How far the grading of a picture is, for somebody who watches: in one line, which is gone when there is something to tell. Nothing where nobody does. */
public final class GradeProgress implements Grader.Watcher, AutoCloseable {
    private static final double SECONDS_BETWEEN = 0.5;

    private final Terminal terminal;
    private final String name;
    private double drawn = Double.NEGATIVE_INFINITY;
    private int width;

    /** @param name of the picture */
    public GradeProgress(Terminal terminal, String name) {
        this.terminal = terminal;
        this.name = PlainText.of(name, Integer.MAX_VALUE);
    }

    /** The right picture is being made. */
    public void rendering() {
        show("rendering the right picture");
    }

    @Override
    public void tried(int samples, int together, int done, int all) {
        show((together > 1 ? "pair " : "mistake ") + done + " of " + all + ", " + (samples > 1 ? samples * samples + " rays a pixel" : "1 ray a pixel"));
    }

    private synchronized void show(String what) {
        double seconds = System.nanoTime() / 1e9;
        if (terminal.interactive() && seconds >= drawn + SECONDS_BETWEEN) {
            drawn = seconds;
            int columns = Columns.ofTerminal();
            int room = columns - 3 - Columns.of(what);
            draw(room < 1 ? Columns.end(what, columns - 1) : Columns.end(name, room) + ": " + what);
        }
    }

    private void draw(String line) {
        terminal.err().print("\r" + line + " ".repeat(Math.max(0, width - Columns.of(line))));
        terminal.err().flush();
        width = Columns.of(line);
    }

    @Override
    public synchronized void close() {
        if (width > 0) {
            draw("");
            terminal.err().print('\r');
            terminal.err().flush();
        }
    }
}
