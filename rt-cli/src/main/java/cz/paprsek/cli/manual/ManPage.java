package cz.paprsek.cli.manual;

import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/** What {@code --help} says of a command, as a page for {@code man}: roff, with the macros of man(7). */
public final class ManPage {
    private ManPage() {}

    /** As files of pages are called: the words of the command, and the section. */
    public static String fileName(CommandLine command) {
        return name(command.getCommandSpec()) + ".1";
    }

    /**
     * The page.
     *
     * @param version of the program, as in {@code Paprsek 0.1.0}
     */
    public static String of(CommandLine command, String version) {
        CommandSpec spec = command.getCommandSpec();
        UsageMessageSpec usage = spec.usageMessage();
        StringBuilder page = new StringBuilder(".TH " + name(spec).toUpperCase(Locale.ROOT) + " 1 \"\" \"" + version + "\" \"Paprsek\"\n");
        section(page, "NAME", text(name(spec)) + " \\- " + text(Said.firstSentence(usage.description())));
        section(page, "SYNOPSIS", bold(spec.qualifiedName(" ")) + " " + text(synopsis(spec)));
        section(page, "DESCRIPTION", paragraphs(usage.description()));
        section(page, "ARGUMENTS", spec.positionalParameters().stream().filter(argument -> !argument.hidden())
                .map(argument -> tagged(italic(argument.paramLabel()), argument)).collect(Collectors.joining("\n")));
        section(page, "OPTIONS", spec.options().stream().filter(option -> !option.hidden())
                .map(option -> tagged(names(option), option)).collect(Collectors.joining("\n")));
        section(page, "COMMANDS", command.getSubcommands().values().stream()
                .map(other -> ".TP\n" + bold(name(other.getCommandSpec())) + "(1)\n" + text(Said.firstSentence(other.getCommandSpec().usageMessage().description())))
                .collect(Collectors.joining("\n")));
        section(page, "EXIT STATUS", usage.exitCodeList().entrySet().stream().map(ManPage::code).collect(Collectors.joining("\n")));
        section(page, "NOTES", usage.footer().length == 0 ? "" : ".nf\n" + Stream.of(usage.footer()).map(ManPage::line).collect(Collectors.joining("\n")).strip() + "\n.fi");
        if (spec.parent() != null) {
            section(page, "SEE ALSO", bold(name(spec.parent())) + "(1)");
        }
        return page.toString();
    }

    private static void section(StringBuilder page, String title, String text) {
        if (!text.isBlank()) {
            page.append(".SH \"").append(title).append("\"\n").append(text).append('\n');
        }
    }

    private static String name(CommandSpec spec) {
        return spec.qualifiedName("-");
    }

    private static String synopsis(CommandSpec spec) {
        return Stream.of(Stream.of("[OPTIONS]"), spec.positionalParameters().stream().filter(argument -> !argument.hidden()).map(ManPage::arguments),
                spec.subcommands().isEmpty() ? Stream.<String>empty() : Stream.of("COMMAND")).flatMap(part -> part).collect(Collectors.joining(" "));
    }

    private static String arguments(ArgSpec argument) {
        String label = argument.paramLabel() + (argument.arity().max() > 1 ? "..." : "");
        return argument.required() ? label : "[" + label + "]";
    }

    private static String tagged(String tag, ArgSpec of) {
        return ".TP\n" + tag + "\n" + paragraphs(of.description());
    }

    private static String names(OptionSpec option) {
        String names = Arrays.stream(option.names()).map(ManPage::bold).collect(Collectors.joining(", "));
        return option.arity().max() == 0 ? names : names + (option.longestName().startsWith("--") ? "=" : " ") + italic(option.paramLabel());
    }

    private static String code(Map.Entry<String, String> code) {
        return ".TP\n" + bold(code.getKey().strip()) + "\n" + text(code.getValue());
    }

    private static String paragraphs(String... texts) {
        return Said.lines(texts).stream().map(ManPage::line).collect(Collectors.joining("\n.br\n"));
    }

    /** A line that begins with a point or an apostrophe would be an order. */
    private static String line(String words) {
        String escaped = text(words);
        return escaped.startsWith(".") || escaped.startsWith("'") ? "\\&" + escaped : escaped;
    }

    private static String bold(String words) {
        return "\\fB" + text(words) + "\\fR";
    }

    private static String italic(String words) {
        return "\\fI" + text(words) + "\\fR";
    }

    /** So that a hyphen can be copied and searched for, an apostrophe stays straight and a backslash is one. */
    private static String text(String words) {
        return words.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq").replace("^", "\\(ha").replace("~", "\\(ti").replace("`", "\\(ga");
    }
}
