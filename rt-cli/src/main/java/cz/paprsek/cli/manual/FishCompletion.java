package cz.paprsek.cli.manual;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** The commands and their options as fish completes them: a line for each, with the beginning of what it does. */
public final class FishCompletion {
    private static final int LONGEST = 60;

    private FishCompletion() {}

    /** The script, for a file in {@code ~/.config/fish/completions}. */
    public static String of(CommandLine root) {
        List<String> lines = new ArrayList<>();
        String program = root.getCommandName();
        add(lines, program, root, "not __fish_seen_subcommand_from " + names(root));
        for (CommandLine command : root.getSubcommands().values()) {
            String here = "__fish_seen_subcommand_from " + command.getCommandName();
            boolean isLeaf = command.getSubcommands().isEmpty();
            add(lines, program, command, isLeaf ? here : here + "; and not __fish_seen_subcommand_from " + names(command));
            for (CommandLine below : command.getSubcommands().values()) {
                add(lines, program, below, here + "; and __fish_seen_subcommand_from " + below.getCommandName());
            }
        }
        return String.join("\n", lines) + "\n";
    }

    private static String names(CommandLine command) {
        return String.join(" ", command.getSubcommands().keySet());
    }

    /** What may follow a command, where the condition holds: with commands below it, these and no files. */
    private static void add(List<String> lines, String program, CommandLine command, String condition) {
        CommandSpec spec = command.getCommandSpec();
        String start = "complete -c " + program + " -n " + quoted(condition);
        command.getSubcommands().forEach((name, below) -> lines.add(start + " -f -a " + name + said(below.getCommandSpec().usageMessage().description())));
        for (OptionSpec option : spec.options()) {
            if (!option.hidden()) {
                lines.add(start + words(option) + (option.arity().max() > 0 ? values(option) : "") + said(option.description()));
            }
        }
    }

    private static String words(OptionSpec option) {
        StringBuilder words = new StringBuilder();
        for (String name : option.names()) {
            words.append(name.startsWith("--") ? " -l " + name.substring(2) : " -s " + name.substring(1));
        }
        return words.toString();
    }

    /** The words that there are, or a file's name. */
    private static String values(OptionSpec option) {
        if (option.completionCandidates() == null) {
            return " -r";
        }
        List<String> candidates = new ArrayList<>();
        option.completionCandidates().forEach(candidates::add);
        return candidates.isEmpty() ? " -r" : " -x -a " + quoted(candidates.stream().sorted().collect(Collectors.joining(" ")));
    }

    private static String said(String... description) {
        String sentence = Said.firstSentence(description);
        int cut = sentence.lastIndexOf(' ', LONGEST);
        return sentence.isEmpty() ? "" : " -d " + quoted(sentence.length() <= LONGEST || cut < 0 ? sentence : sentence.substring(0, cut) + " \u2026");
    }

    private static String quoted(String words) {
        return "'" + words.replace("\\", "\\\\").replace("'", "\\'") + "'";
    }
}
