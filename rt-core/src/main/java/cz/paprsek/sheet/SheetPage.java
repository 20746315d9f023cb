package cz.paprsek.sheet;

import cz.paprsek.material.Rgb.Tone;
import cz.paprsek.render.explain.LinearRgb;
import cz.paprsek.sheet.Worksheet.Task;
import cz.paprsek.words.Words;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;

/** Writes a worksheet as HTML, to be printed on A4 or letter. */
final class SheetPage {
    private static final String STYLE = """
            body { font: 11pt/1.35 sans-serif; color: #000; background: #fff; max-width: 190mm; margin: 8mm auto; padding: 0 4mm; }
            h1 { font-size: 16pt; margin: 0 0 2mm; } h2 { font-size: 13pt; margin: 6mm 0 2mm; } h3 { font-size: 11pt; margin: 4mm 0 1mm; }
            .who { display: flex; gap: 8mm; margin: 0 0 4mm; } .who span { flex: 1; border-bottom: 0.3mm solid #000; }
            svg { width: 100%; height: auto; border: 0.2mm solid #bbb; break-inside: avoid; }
            table { border-collapse: collapse; width: 100%; } td { padding: 0.6mm 2mm 0.6mm 0; vertical-align: bottom; } tr { break-inside: avoid; }
            td.f { white-space: nowrap; width: 1%; } td.blank { border-bottom: 0.3mm solid #000; height: 7.5mm; }
            .solution { break-before: page; } .result { font-weight: bold; } .remark { font-size: 9.5pt; }
            @page { margin: 14mm; } @media print { body { margin: 0; max-width: none; padding: 0; } }
            """;

    private final String title;
    private final OptionalLong seed;
    private final Words words;
    private final StringBuilder html = new StringBuilder();

    SheetPage(String sceneName, OptionalLong seed, Words words) {
        this.title = words.of("sheet.title") + (sceneName.isBlank() ? "" : ": " + sceneName) + (seed.isPresent() ? ", " + words.of("sheet.variant", seed.getAsLong()) : "");
        this.seed = seed;
        this.words = words;
    }

    /** What a line shows: a formula with numbers, a result, or room to write that. */
    record Row(String formula, String numbers, String result, boolean isBlank) {}

    String title() {
        return title;
    }

    String solutions() {
        return words.of("sheet.solution") + (seed.isPresent() ? ", " + words.of("sheet.variant", seed.getAsLong()) : "");
    }

    String page(List<Task> tasks) {
        html.append("<!DOCTYPE html>\n<html lang=\"").append(words.of("sheet.language")).append("\">\n<head>\n<meta charset=\"utf-8\">\n<title>").append(escaped(title))
                .append("</title>\n<style>\n").append(STYLE).append("</style>\n</head>\n<body>\n");
        element("h1", "", title);
        html.append("<p class=\"who\">").append(escaped(words.of("sheet.name"))).append(" <span></span>").append(escaped(words.of("sheet.date"))).append(" <span></span></p>\n");
        element("p", "remark", words.of("sheet.how"));
        for (int i = 0; i < tasks.size(); i++) {
            task(i + 1, tasks.get(i), false);
        }
        html.append("<div class=\"solution\">\n");
        element("h1", "", solutions());
        for (int i = 0; i < tasks.size(); i++) {
            task(i + 1, tasks.get(i), true);
        }
        return html.append("</div>\n</body>\n</html>\n").toString();
    }

    private void task(int number, Task task, boolean isSolved) {
        element("h2", "", number + ". " + words.of("sheet.pixel", task.pixel().column(), task.pixel().row()));
        if (!isSolved) {
            html.append(task.sketch());
        }
        for (RayExercise ray : task.rays()) {
            element("h3", "", ray.name() + "  " + ray.headline());
            html.append("<table>\n");
            for (Line line : ray.lines()) {
                if (!isSolved || !line.isGiven()) {
                    line(line, isSolved);
                }
            }
            html.append("</table>\n");
        }
        element("p", "remark", words.of("sheet.screen"));
        html.append("<table>\n");
        screen(task).forEach(line -> line(line, isSolved));
        html.append("</table>\n");
        if (isSolved) {
            element("p", "remark", allDigits(task));
        }
    }

    String allDigits(Task task) {
        LinearRgb light = task.pixel().developed();
        return words.of("sheet.all-digits", words.figures(Pocket.text(light)), Pocket.shown(light));
    }

    /** What becomes of the light on a screen: exposed and toned if the picture is, and in sRGB. */
    List<Line> screen(Task task) {
        double exposure = Pocket.of(task.pixel().exposure());
        Tone tone = task.pixel().tone();
        String light = words.of("name.light-of", task.rays().get(task.rays().size() - 1).name());
        String twice = exposure == 0 ? "" : "2^(" + Pocket.text(exposure) + ")·";
        LinearRgb shown = Pocket.of(task.reckoned().times(StrictMath.pow(2, exposure)));
        List<Line> lines = new ArrayList<>();
        lines.add(new Line("B = " + twice + light, twice + Pocket.text(task.reckoned()), Pocket.text(shown), false));
        if (tone != Tone.NONE) {
            shown = Pocket.of(new LinearRgb(tone.of(shown.red()), tone.of(shown.green()), tone.of(shown.blue())));
            lines.add(new Line(words.of("sheet.toned", words.of("kind." + tone)), "", Pocket.text(shown), true));
        }
        lines.add(new Line("v = 255·(1.055·B^(1/2.4) − 0.055)", "", "sRGB " + Pocket.shown(shown), false));
        return lines;
    }

    Row row(Line english, boolean isSolved) {
        Line line = new Line(words.figures(english.formula()), words.figures(english.numbers()), words.figures(english.result()), english.isGiven());
        if (line.isGiven()) {
            // What begins with a letter says itself what is equal to what.
            return new Row(line.formula(), (Character.isLetter(line.result().charAt(0)) ? "" : "= ") + line.result(), "", false);
        }
        return isSolved ? new Row(line.formula(), (line.numbers().isEmpty() ? "" : "= " + line.numbers() + " ") + "=", line.result(), false) : new Row(line.formula(), "", "", true);
    }

    private void line(Line line, boolean isSolved) {
        Row row = row(line, isSolved);
        html.append("<tr><td class=\"f\">").append(escaped(row.formula())).append("</td>");
        if (row.isBlank()) {
            html.append("<td class=\"blank\">=</td>");
        } else {
            html.append("<td>").append(escaped(row.numbers())).append(row.result().isEmpty() ? "" : " <span class=\"result\">" + escaped(row.result()) + "</span>").append("</td>");
        }
        html.append("</tr>\n");
    }

    private void element(String name, String kind, String text) {
        html.append('<').append(name).append(kind.isEmpty() ? "" : " class=\"" + kind + "\"").append('>').append(escaped(text)).append("</").append(name).append(">\n");
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
