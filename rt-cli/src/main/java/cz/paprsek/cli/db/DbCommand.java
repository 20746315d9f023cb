package cz.paprsek.cli.db;

import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** The commands on scene databases. */
@Command(
        name = "db",
        synopsisSubcommandLabel = "COMMAND",
        description = {
            "Lists, filters and changes scene databases: files with many scenes, each known by its name.",
            "A filter compares columns, numbers and quoted texts with = != < <= > >= like in, joined by and, or, not and parentheses. In like, "
                    + "%% stands for any characters and _ for one. A filter of scenes may ask for whatever is in them: exists(torus), "
                    + "count(sphere where radius > 2) > 3, transparency > 0.",
            "Changes are made under a lock: two at once lose nothing."
        },
        footer = {
            "",
            "Examples:",
            "  paprsek db init my.xml                            one with examples",
            "  paprsek db list my.xml --where 'tag = \"glass\"'",
            "  paprsek db show sphere my.xml --where 'radius > 2 and name like \"gl%%\"' --csv",
            "  paprsek db find my.xml --where 'transparency > 0.5'",
            "  paprsek db add my.xml new.xml --tag draft",
            "  paprsek db extract my.xml \"Chess set\" -o chess.xml",
            "  paprsek render my.xml --where 'exists(torus)' -o pictures/"
        })
public final class DbCommand implements Runnable {
    @Spec
    private CommandSpec spec;

    /** The command with all that it has below it. */
    public static CommandLine of(Terminal terminal, Stop stop) {
        return new CommandLine(new DbCommand())
                .addSubcommand("list", new DbListCommand(terminal, stop))
                .addSubcommand("tables", new DbTablesCommand(terminal, stop))
                .addSubcommand("show", new DbShowCommand(terminal, stop))
                .addSubcommand("find", new DbFindCommand(terminal, stop))
                .addSubcommand("add", new DbAddCommand(terminal, stop))
                .addSubcommand("extract", new DbExtractCommand(terminal, stop))
                .addSubcommand("remove", new DbRemoveCommand(terminal, stop))
                .addSubcommand("rename", new DbRenameCommand(terminal, stop))
                .addSubcommand("merge", new DbMergeCommand(terminal, stop))
                .addSubcommand("init", new DbInitCommand(terminal, stop));
    }

    @Override
    public void run() {
        throw new WrongUsage("say what to do: " + String.join(", ", spec.subcommands().keySet()));
    }
}
