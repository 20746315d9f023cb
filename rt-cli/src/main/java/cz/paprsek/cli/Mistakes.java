package cz.paprsek.cli;

import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.Words;
import cz.paprsek.text.Similar;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** What is said of a command line that cannot be understood. */
final class Mistakes {
    /** What picocli says of a command that it is asked to explain. */
    private static final Pattern UNKNOWN_COMMAND = Pattern.compile("^Unknown subcommand '(.*)'");

    /** What it says of a value that is to be two with an equals sign between them. */
    private static final Pattern NO_PAIR = Pattern.compile("^Value for option option ('.*') \\((.*)\\) should be in KEY=VALUE format but was (.*)$");

    /** What other renderers call what has another name here. */
    private static final Map<String, String> OF_OTHERS = Map.ofEntries(
            Map.entry("--width", "--size"), Map.entry("--height", "--size"), Map.entry("--resolution", "--size"), Map.entry("--res", "--size"), Map.entry("-w", "--size"),
            Map.entry("--spp", "--samples"), Map.entry("--aa", "--samples"), Map.entry("--antialias", "--samples"), Map.entry("--quality", "--samples"), Map.entry("--passes", "--samples"),
            Map.entry("--depth", "--max-depth"), Map.entry("--bounces", "--max-depth"), Map.entry("--jobs", "--threads"), Map.entry("-j", "--threads"), Map.entry("--cores", "--threads"),
            Map.entry("--outfile", "--output"), Map.entry("--crop", "--region"));

    private Mistakes() {}

    static String sentence(ParameterException mistake) {
        if (mistake instanceof UnmatchedArgumentException strange && !strange.getUnmatched().isEmpty()) {
            CommandSpec spec = mistake.getCommandLine().getCommandSpec();
            String word = strange.getUnmatched().get(0);
            return word.length() > 1 && word.startsWith("-") ? option(spec, word) : word(spec, word);
        }
        List<String> unmatched = mistake.getCommandLine().getUnmatchedArguments();
        if (mistake instanceof MissingParameterException && !unmatched.isEmpty() && unmatched.get(0).startsWith("-")) {
            return option(mistake.getCommandLine().getCommandSpec(), unmatched.get(0));
        }
        Matcher command = UNKNOWN_COMMAND.matcher(String.valueOf(mistake.getMessage()));
        if (command.find()) {
            return word(mistake.getCommandLine().getCommandSpec(), command.group(1));
        }
        String threads = mistake.getArgSpec() instanceof OptionSpec option && option.longestName().equals("--threads")
                ? "; without --threads, all processors are used" : "";
        return NO_PAIR.matcher(String.valueOf(mistake.getMessage()).replace("\n", " ")).replaceFirst("Invalid value for option $1: expected $2, but found '$3'") + threads;
    }

    private static String option(CommandSpec spec, String given) {
        if (given.contains(".") && !given.startsWith("--") && !given.contains("=")) {
            return "unknown option \"" + given + "\"; if it is a file, say ./" + given;
        }
        String word = given.split("=", 2)[0];
        List<String> known = spec.options().stream().flatMap(option -> List.of(option.names()).stream()).toList();
        String here = OF_OTHERS.getOrDefault(word, "");
        if (known.contains(here)) {
            return "unknown option \"" + word + "\"; here that is " + here + (here.equals("--size") ? " WIDTHxHEIGHT" : "");
        }
        if (word.startsWith("--") && Similar.nearest(word, known).isPresent()) {
            return "unknown option \"" + word + "\"" + Similar.suggestion(word, known);
        }
        if (word.matches("-o|--output") && spec.positionalParameters().stream().anyMatch(place -> place.paramLabel().startsWith("FILE"))) {
            return "unknown option \"" + word + "\"; the file stands there without an option: paprsek " + spec.name() + " "
                    + String.join(" ", spec.positionalParameters().stream().map(ArgSpec::paramLabel).toList());
        }
        // A letter, with or without its value, for one of the long ones; its beginning; or one dash where two belong.
        Optional<String> longer = known.stream().filter(word::equalsIgnoreCase).findFirst()
                .or(() -> known.stream().filter(name -> name.startsWith("-" + word) || (word.length() > 4 && name.startsWith(word))).findFirst())
                .or(() -> known.stream().filter(name -> !word.startsWith("--") && name.startsWith("-" + word.substring(0, 2))).findFirst());
        return "unknown option \"" + word + "\"" + longer.map(name -> "; did you mean \"" + name + "\"?").orElseGet(() -> ofCommands(spec, word));
    }

    /** Options belong behind the command. */
    private static String ofCommands(CommandSpec spec, String word) {
        TreeSet<String> commands = new TreeSet<>();
        spec.subcommands().forEach((name, command) -> {
            if (command.getCommandSpec().findOption(word) != null) {
                commands.add(name);
            }
        });
        return commands.isEmpty() ? "" : "; it belongs behind a command: " + String.join(", ", commands);
    }

    private static String word(CommandSpec spec, String word) {
        List<String> known = new ArrayList<>(spec.subcommands().keySet());
        if (known.isEmpty()) {
            return "unexpected \"" + word + "\"";
        }
        boolean isScene = spec.parent() == null && (word.endsWith(".xml") || isFile(word));
        return "there is no command \"" + word + "\"" + (isScene ? "; to render it, say paprsek render " + word : Similar.suggestion(word, known));
    }

    private static boolean isFile(String word) {
        try {
            return Files.isRegularFile(Words.path(word));
        } catch (WrongUsage noName) {
            return false;
        }
    }
}
