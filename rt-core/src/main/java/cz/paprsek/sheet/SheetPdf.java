package cz.paprsek.sheet;

import cz.paprsek.sheet.SheetPage.Row;
import cz.paprsek.sheet.Worksheet.Task;
import cz.paprsek.sheet.pdf.Pdf;
import cz.paprsek.sheet.pdf.PdfPage;
import cz.paprsek.sheet.pdf.PdfSketch;
import cz.paprsek.words.Words;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.stream.Stream;

/** Writes a worksheet as PDF: the same as {@link SheetPage}, on A4. */
final class SheetPdf {
    private static final double MARGIN = 42;
    private static final double WIDTH = Pdf.WIDTH - 2 * MARGIN;
    private static final double BOTTOM = Pdf.HEIGHT - 50;
    private static final double TEXT = 10;
    /** From one base line to the next, by the size of letters. */
    private static final double LEADING = 1.4;
    /** Room for handwriting. */
    private static final double BLANK = 23;
    private static final double HANGING = 24;
    private static final String BLACK = "#000000";

    private final SheetPage page;
    private final Words words;
    private final Pdf pdf;
    private PdfPage now;
    private double y;

    /** Words in one kind of letters. */
    private record Run(String text, boolean isBold) {}

    SheetPdf(String sceneName, OptionalLong seed, Words words) {
        this.page = new SheetPage(sceneName, seed, words);
        this.words = words;
        this.pdf = new Pdf(page.title(), words.of("sheet.language"));
        this.now = begin();
    }

    byte[] file(List<Task> tasks) {
        heading(page.title(), 15);
        String name = words.of("sheet.name");
        String date = words.of("sheet.date");
        y += 12;
        blank(MARGIN, name, 0.62 * WIDTH);
        blank(MARGIN + 0.66 * WIDTH, date, 0.34 * WIDTH);
        y += 6;
        paragraph(8.5, new Run(words.of("sheet.how"), false));
        for (int i = 0; i < tasks.size(); i++) {
            task(i + 1, tasks.get(i), false);
        }
        now = begin();
        heading(page.solutions(), 15);
        for (int i = 0; i < tasks.size(); i++) {
            task(i + 1, tasks.get(i), true);
        }
        return pdf.bytes();
    }

    private PdfPage begin() {
        PdfPage fresh = pdf.page();
        y = MARGIN;
        fresh.text(MARGIN, Pdf.HEIGHT - 28, 8, false, "#606060", page.title() + "   ·   " + pdf.pages());
        return fresh;
    }

    private void room(double height) {
        if (y + height > BOTTOM) {
            now = begin();
        }
    }

    private void heading(String text, double size) {
        // No heading stands alone at the bottom of a page.
        room(size * LEADING + 70);
        y += 0.6 * size;
        paragraph(size, new Run(text, true));
    }

    private void task(int number, Task task, boolean isSolved) {
        heading(number + ". " + words.of("sheet.pixel", task.pixel().column(), task.pixel().row()), 12.5);
        if (!isSolved) {
            PdfSketch sketch = new PdfSketch(task.sketch());
            double height = sketch.height(WIDTH);
            room(height + 4);
            sketch.draw(now, MARGIN, y, WIDTH);
            y += height + 4;
        }
        for (RayExercise ray : task.rays()) {
            heading(ray.name() + "  " + ray.headline(), 10.5);
            for (Line line : ray.lines()) {
                if (!isSolved || !line.isGiven()) {
                    line(line, isSolved);
                }
            }
        }
        y += 4;
        paragraph(8.5, new Run(words.of("sheet.screen"), false));
        page.screen(task).forEach(line -> line(line, isSolved));
        if (isSolved) {
            paragraph(8.5, new Run(page.allDigits(task), false));
        }
    }

    private void line(Line line, boolean isSolved) {
        Row row = page.row(line, isSolved);
        if (row.isBlank()) {
            room(BLANK);
            y += BLANK - TEXT * LEADING;
            blank(MARGIN, row.formula() + " =", WIDTH);
        } else {
            paragraph(TEXT, new Run(row.formula() + "  " + row.numbers(), false), new Run(row.result(), true));
        }
    }

    /** A word, and a line to write on. */
    private void blank(double x, String word, double width) {
        double from = x + pdf.width(word, TEXT, false) + 5;
        now.text(x, y + TEXT, TEXT, false, BLACK, word);
        now.stroke(List.of(List.of(new double[] {from, y + TEXT + 2}, new double[] {x + width, y + TEXT + 2})), 0.6, BLACK, List.of());
        y += x > MARGIN || width == WIDTH ? TEXT * LEADING : 0;
    }

    /** Words one after the other, broken where the page ends; further lines are indented. */
    private void paragraph(double size, Run... runs) {
        double x = MARGIN;
        double whole = Stream.of(runs).mapToDouble(run -> pdf.width(run.text(), size, run.isBold())).sum();
        // All of its lines on one page: a formula with its numbers is read at once.
        room(size * LEADING * Math.ceil(whole / (WIDTH - 3 * HANGING)));
        for (Run run : runs) {
            for (String word : pieces(run.text(), size, run.isBold())) {
                double width = pdf.width(word, size, run.isBold());
                if (x > MARGIN && x + width > MARGIN + WIDTH) {
                    y += size * LEADING;
                    x = MARGIN + (runs.length > 1 ? HANGING : 0);
                }
                now.text(x, y + size, size, run.isBold(), BLACK, word);
                x += width + pdf.width(" ", size, run.isBold());
            }
        }
        y += size * LEADING;
    }

    /** Words; what is wider than a line, such as a name without blanks, in parts. */
    private List<String> pieces(String text, double size, boolean isBold) {
        List<String> pieces = new ArrayList<>();
        for (String word : text.strip().split(" +", -1)) {
            String rest = word;
            while (pdf.width(rest, size, isBold) > WIDTH - HANGING) {
                int length = rest.length() - 1;
                while (length > 1 && pdf.width(rest.substring(0, length), size, isBold) > WIDTH - HANGING) {
                    length--;
                }
                pieces.add(rest.substring(0, length));
                rest = rest.substring(length);
            }
            if (!rest.isEmpty()) {
                pieces.add(rest);
            }
        }
        return pieces;
    }
}
