package cz.paprsek.cli;

import cz.paprsek.cli.Grading.Graded;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.image.Image;
import cz.paprsek.image.ImageComparison;
import cz.paprsek.image.ImageFiles;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.io.Failures;
import cz.paprsek.io.Json;
import cz.paprsek.teach.grade.Grade.Verdict;
import cz.paprsek.teach.mistake.Mistake;
import cz.paprsek.teach.mistake.Mistakes;
import cz.paprsek.words.Words;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * Tells how pictures are graded.
 *
 * @param several whether each line of words begins with the picture's name
 * @param evidence where a picture of four is drawn
 */
record GradeReport(Terminal terminal, Stop stop, boolean csv, boolean json, boolean several, Evidence evidence) {
    private static final List<String> COLUMNS = List.of("picture", "verdict", "mistakes", "beyond", "largest", "mean", "explained", "left");

    /** Begins. */
    void begin() {
        if (csv) {
            print(String.join(",", COLUMNS));
        }
    }

    /** Tells of a picture; returns the exit code. */
    int told(Path picture, Graded graded) {
        if (csv) {
            print(row(picture, graded));
        } else if (json) {
            terminal.result(object(picture, graded).toString());
        } else {
            lines(picture, graded);
        }
        boolean isDrawn = evidence.of(picture).map(target -> draw(target, graded)).orElse(true);
        return isDrawn && graded.grade().verdict() == Verdict.RIGHT ? ExitCode.DONE : ExitCode.FAILED;
    }

    private void print(String line) {
        PrintWriter out = terminal.table();
        out.print(line + "\r\n");
        out.flush();
    }

    /** In one line what it is. */
    private static String verdict(Graded graded) {
        List<Mistakes> explanations = graded.grade().explanations();
        return switch (graded.grade().verdict()) {
            case RIGHT -> "right";
            case UNEXPLAINED -> "unexplained";
            case MISTAKEN -> (explanations.size() > 1 ? "one of: " : "") + explanations.stream().map(Mistakes::toString).collect(Collectors.joining(", "));
        };
    }

    private void lines(Path picture, Graded graded) {
        say((several ? picture + ": " : "") + verdict(graded));
        for (Mistakes made : graded.grade().explanations()) {
            for (Mistake mistake : made.all()) {
                say("  " + mistake + ": " + mistake.meaning(Words.ENGLISH) + ":");
                say("    " + mistake.wrong(Words.ENGLISH) + "   should be   " + mistake.right(Words.ENGLISH));
            }
        }
        say("  from right: " + distance(graded.distance()));
        if (graded.grade().verdict() == Verdict.MISTAKEN) {
            say("  from that mistake: " + distance(graded.left()) + "; " + percent(graded.grade().explained()) + " of what is wrong is explained");
        } else if (graded.grade().verdict() == Verdict.UNEXPLAINED && !graded.unknown().isEmpty()) {
            say("  mistakes cannot be looked for, since the plain tracer that makes them does not know " + String.join(", ", graded.unknown()));
        }
    }

    private void say(String line) {
        terminal.result(Letters.fit(line));
    }

    private static String distance(ImageComparison found) {
        return percent(found.shareBeyond()) + " of pixels by more than 2 steps" + (found.largest() > 0 ? ", the largest " + number(found.largest()) + " at column "
                + found.x() + ", row " + found.y() + ", the mean " + number(found.mean()) : "") + (found.isGrey() ? ", in brightness" : "");
    }

    private static String percent(double share) {
        return String.format(Locale.ROOT, "%.2f %%", 100 * share);
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.3f", value).replaceAll("\\.?0+$", "");
    }

    private static String row(Path picture, Graded graded) {
        return String.join(",", "\"" + picture.toString().replace("\"", "\"\"") + "\"", graded.grade().verdict().name().toLowerCase(Locale.ROOT),
                graded.grade().explanations().stream().map(Mistakes::toString).collect(Collectors.joining(" | ")), number(graded.distance().shareBeyond()),
                number(graded.distance().largest()), number(graded.distance().mean()), number(graded.grade().explained()), number(graded.left().shareBeyond()));
    }

    private static Json object(Path picture, Graded graded) {
        return new Json().with("picture", picture.toString()).with("verdict", verdict(graded))
                .with("explanations", graded.grade().explanations().stream().map(made -> new Json().withTexts("mistakes", made.all().stream().map(Mistake::toString).toList())).toList())
                .with("explained", graded.grade().explained()).with("samples", graded.grade().samples()).with("distance", distanceAsJson(graded.distance()))
                .with("left", distanceAsJson(graded.left())).withTexts("unknown", graded.unknown());
    }

    private static Json distanceAsJson(ImageComparison found) {
        return new Json().with("share", found.shareBeyond()).with("largest", found.largest()).with("x", found.x()).with("y", found.y()).with("mean", found.mean())
                .with("grey", found.isGrey());
    }

    private boolean draw(Path target, Graded graded) {
        Image given = graded.given().image();
        Image four = new Image(2 * given.width(), 2 * given.height());
        copy(given, four, 0, 0);
        copy(graded.right().image(), four, given.width(), 0);
        copy(graded.wrong().image(), four, 0, given.height());
        copy(ImageComparison.heatmap(graded.given(), graded.wrong(), graded.left().tolerance()), four, given.width(), given.height());
        try {
            stop.write(target, () -> ImageFiles.write(four, target, ImageFormat.ofFile(target.toString()).orElse(ImageFormat.PNG)));
            return true;
        } catch (IOException e) {
            terminal.message(Failures.sentence(target.toString(), e));
            return false;
        }
    }

    private static void copy(Image from, Image to, int left, int top) {
        for (int y = 0; y < from.height(); y++) {
            for (int x = 0; x < from.width(); x++) {
                to.set(left + x, top + y, from.red(x, y), from.green(x, y), from.blue(x, y));
            }
        }
    }
}
