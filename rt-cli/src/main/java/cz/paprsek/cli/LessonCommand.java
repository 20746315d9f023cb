package cz.paprsek.cli;

import cz.paprsek.cli.process.Columns;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Interruption;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.Words;
import cz.paprsek.io.Failures;
import cz.paprsek.lesson.Lesson;
import cz.paprsek.lesson.Lesson.Formula;
import cz.paprsek.lesson.Lesson.Look;
import cz.paprsek.lesson.Lesson.Paragraph;
import cz.paprsek.lesson.Lesson.Part;
import cz.paprsek.lesson.LessonCheck;
import cz.paprsek.lesson.LessonException;
import cz.paprsek.lesson.Lessons;
import cz.paprsek.lesson.Question;
import cz.paprsek.lesson.Said;
import cz.paprsek.lesson.Task;
import cz.paprsek.render.RenderMonitor;
import cz.paprsek.text.Numbers;
import cz.paprsek.text.Similar;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Lists lessons, prints one with its answers, and checks it. */
@Command(
        name = "lesson",
        description = {
            "Lists the lessons that are in the editor; with a name, or the file of one of your own, prints that lesson with its answers, for the teacher.",
            "What is printed has been checked: wrong answers are wrong, its tasks are not done to begin with, and are in their solutions."
        },
        footer = {
            "",
            "Examples:",
            "  paprsek lesson",
            "  paprsek lesson sphere --language cs",
            "  paprsek lesson mine/lesson.xml",
            "  paprsek lesson --schema > lesson.xsd"
        })
final class LessonCommand implements Callable<Integer> {
    private final Terminal terminal;
    private final Stop stop;

    @Parameters(index = "0", arity = "0..1", paramLabel = "NAME|FILE", description = "A lesson by its name, or the file of one, which ends in .xml.")
    private Optional<String> wanted;

    @Option(names = "--language", paramLabel = "LANGUAGE", defaultValue = "en", description = "${COMPLETION-CANDIDATES}: English or Czech. Default: ${DEFAULT-VALUE}.")
    private WorksheetCommand.Language language;

    @Option(names = "--schema", description = "Prints the XML schema (XSD) of lessons instead.")
    private boolean schema;

    LessonCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() {
        try {
            if (schema) {
                terminal.bytes().write(Lessons.schema().getBytes(StandardCharsets.UTF_8));
            } else if (wanted.isEmpty()) {
                Lessons.NAMES.forEach(name -> terminal.result(String.format(Locale.ROOT, "%-18s%s", name, in(Lessons.shipped(name).title()))));
            } else {
                return tell(lesson(wanted.get()));
            }
            return ExitCode.DONE;
        } catch (CancellationException interrupted) {
            return Interruption.told(terminal, false);
        } catch (LessonException e) {
            e.problems().forEach(problem -> terminal.message(problem.toString()));
            return ExitCode.BAD_SCENE;
        } catch (IOException e) {
            terminal.message(Failures.sentence(wanted.orElse("standard output"), e));
            return ExitCode.BAD_SCENE;
        }
    }

    private static Lesson lesson(String wanted) throws LessonException, IOException {
        if (Lessons.NAMES.contains(wanted)) {
            return Lessons.shipped(wanted);
        }
        if (!wanted.toLowerCase(Locale.ROOT).endsWith(".xml")) {
            throw new WrongUsage("there is no lesson \"" + wanted + "\"" + Similar.suggestion(wanted, Lessons.NAMES) + "; 'paprsek lesson' lists them, and files end in .xml");
        }
        Path file = Words.path(wanted);
        if (Files.notExists(file)) {
            throw new NoSuchFileException(wanted);
        }
        return Lessons.read(file);
    }

    private int tell(Lesson lesson) {
        List<String> problems = LessonCheck.problems(lesson, new RenderMonitor() {
            @Override
            public boolean cancelled() {
                return stop.requested();
            }
        });
        say("", in(lesson.title()));
        lesson.parts().forEach(part -> tell(part, lesson));
        problems.forEach(problem -> terminal.message(wanted.orElseThrow() + ": " + problem));
        return problems.isEmpty() ? ExitCode.DONE : ExitCode.BAD_SCENE;
    }

    private void tell(Part part, Lesson lesson) {
        terminal.result("");
        if (part instanceof Paragraph paragraph) {
            say("", in(paragraph.text()));
        } else if (part instanceof Formula formula) {
            say("    ", in(formula.text()));
        } else if (part instanceof Look look) {
            say("→ " + look.column() + "," + look.row() + "  ", in(look.text()));
        } else if (part instanceof Question question) {
            say("? ", in(question.asked()));
            say("  = ", numbers(Lessons.answer(lesson, question)) + "  ± " + Numbers.text(question.tolerance()) + "   " + in(question.why()));
            question.slips().forEach(slip -> say("  ≠ ", numbers(slip.numbers()) + "   " + in(slip.told())));
        } else if (part instanceof Task task) {
            say("! ", in(task.asked()));
            say("  = ", in(task.why()));
        }
    }

    /** To four places: answers are told to people. */
    private static String numbers(List<Double> numbers) {
        return numbers.stream().map(number -> Numbers.text(Math.rint(1e4 * number) / 1e4 + 0.0)).collect(Collectors.joining(" "));
    }

    private String in(Said said) {
        return said.in(Locale.forLanguageTag(language.name()));
    }

    /** Lines that every terminal shows whole; those below the first begin where its text does. */
    private void say(String mark, String text) {
        String from = Letters.fit(mark);
        String indent = " ".repeat(Columns.of(from));
        List<String> lines = Columns.lines(Letters.fit(text), Columns.USUAL - indent.length());
        for (int i = 0; i < lines.size(); i++) {
            terminal.result((i == 0 ? from : indent) + lines.get(i));
        }
    }
}
