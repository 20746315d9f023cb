package cz.paprsek.cli;

import cz.paprsek.cli.input.SceneReading;
import cz.paprsek.cli.plan.Kubernetes;
import cz.paprsek.cli.plan.Plan;
import cz.paprsek.cli.plan.Slurm;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.Shard;
import cz.paprsek.cli.value.Words;
import cz.paprsek.image.ImageFormat;
import cz.paprsek.io.AtomicFile;
import cz.paprsek.io.Failures;
import cz.paprsek.io.Folders;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Writes what a cluster needs to render a scene. */
@Command(
        name = "plan",
        description = {
            "Writes what a cluster needs to render a scene in shares and to put them together: for Slurm a script, for Kubernetes manifests. Nothing is started.",
            "The scene is read, and the options after -- are looked at, before anything is written; so is whether there are as many parts as shares."
        },
        footer = {"", "Examples:", "  paprsek plan scene.xml --slurm --shards 64 | sh", "  paprsek plan scene.xml --slurm -o . -- --size 3840x2160 --samples 4",
            "  paprsek plan scene.xml --kubernetes --image registry/paprsek:1 \\", "      | kubectl apply -f -"})
final class PlanCommand implements Callable<Integer> {
    private final Terminal terminal;
    private final Stop stop;

    @Spec
    private CommandSpec spec;

    @Parameters(index = "0", paramLabel = "SCENE", description = "The scene file, named as the cluster's machines will.")
    private Path scene;

    @Parameters(index = "1..*", paramLabel = "OPTION", description = "Options of 'paprsek render', after --.")
    private List<String> options = List.of();

    @Option(names = "--slurm", description = "A script for Slurm.")
    private boolean slurm;

    @Option(names = "--kubernetes", description = "Manifests for Kubernetes.")
    private boolean kubernetes;

    @Option(names = "--shards", paramLabel = "N", defaultValue = "8", description = "How many shares there are. More than there are machines spread the work more evenly. Default: 8.")
    private int shards;

    @Option(names = "--parallel", paramLabel = "N", description = "How many of them are worked on at once, at most. Default: all.")
    private Optional<Integer> parallel;

    @Option(names = "--cpus", paramLabel = "N", defaultValue = "1", description = "Processors for each share, 1-1024. Default: 1.")
    private int cpus;

    @Option(names = "--memory", paramLabel = "MB", defaultValue = "2048", description = "Memory for each share, and for putting them together, in units of 2^20 bytes. Default: 2048.")
    private int memory;

    @Option(names = "--parts", paramLabel = "DIR", description = "Where the parts go. Default: NAME.parts, by the scene's name.")
    private Optional<String> parts;

    @Option(names = "--picture", paramLabel = "FILE", description = "Where the picture goes. Default: NAME.png, by the scene's name.")
    private Optional<String> picture;

    @Option(names = "--program", paramLabel = "COMMAND", defaultValue = "paprsek", description = "How Paprsek is called on the nodes of Slurm. Default: paprsek.")
    private String program;

    @Option(names = "--image", paramLabel = "IMAGE", defaultValue = "paprsek:latest", description = "The container image of Kubernetes; docs/cluster.md tells how it is built. Default: paprsek:latest.")
    private String image;

    @Option(names = "--claim", paramLabel = "NAME", defaultValue = "", description = "A volume claim of Kubernetes that is there, with the scene on it. Default: one is made.")
    private String claim;

    @Option(names = {"-o", "--output"}, paramLabel = "DIR", description = "The directory to write the file to; it is made. Default: standard output.")
    private Optional<Path> output;

    PlanCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() {
        check();
        String name = Objects.requireNonNullElse(scene.getFileName(), scene).toString();
        String stem = name.lastIndexOf('.') > 0 ? name.substring(0, name.lastIndexOf('.')) : name;
        Plan plan = new Plan(stem, words(), shards, Math.min(shards, parallel.orElse(shards)), cpus, memory, parts.orElse(stem + ".parts"), picture.orElse(stem + ".png"));
        RenderCommand render = checked(plan);
        SceneReading reading = SceneReading.of(scene, render.given());
        reading.sentences().forEach(terminal::message);
        if (!reading.isValid()) {
            return ExitCode.BAD_SCENE;
        }
        if (reading.scenes().size() != 1) {
            throw new WrongUsage(scene + " is a database of " + reading.scenes().size() + " scenes; give a file of one");
        }
        long most = render.shares(reading.scenes().get(0), shards);
        if (most < shards) {
            terminal.message(scene + ": note: of " + shards + " shares " + (shards - most) + " have nothing to do, as the picture has " + most + " parts");
        }
        return write(plan.label() + (slurm ? ".slurm.sh" : ".kubernetes.yaml"), slurm ? Slurm.script(plan, program) : Kubernetes.manifests(plan, image, claim));
    }

    private void check() {
        if (slurm == kubernetes) {
            throw new WrongUsage("say for what: --slurm or --kubernetes");
        }
        require("--shards", shards, kubernetes ? Kubernetes.MOST_SHARDS : Shard.MOST);
        parallel.ifPresent(count -> require("--parallel", count, Integer.MAX_VALUE));
        require("--cpus", cpus, 1024);
        require("--memory", memory, 1 << 24);
        if (kubernetes && scene.isAbsolute()) {
            throw new WrongUsage(scene + ": name the scene from the folder that will be on the volume, not from the root");
        }
    }

    private static void require(String name, int number, int most) {
        if (number < 1 || number > most) {
            throw new WrongUsage(name + " must be from 1 to " + most + ", but is " + number);
        }
    }

    private List<String> words() {
        List<String> words = new ArrayList<>(List.of(scene.toString()));
        words.addAll(options);
        return words;
    }

    /** The command that renders the first share, as the machines will read it. */
    private RenderCommand checked(Plan plan) {
        List<String> words = new ArrayList<>(plan.render());
        words.addAll(List.of("--threads", Integer.toString(cpus), "--shard", "1/" + shards, "-o", plan.parts()));
        CommandLine render = Objects.requireNonNull(spec.root().subcommands().get("render"));
        try {
            render.parseArgs(words.toArray(String[]::new));
        } catch (ParameterException mistake) {
            throw new WrongUsage("the options after -- are not those of render: " + Mistakes.sentence(mistake));
        }
        RenderCommand command = render.getCommand();
        command.checkShare(scene, merged(plan.picture()));
        return command;
    }

    private static ImageFormat merged(String picture) {
        return ImageFormat.ofFile(picture).or(() -> picture.endsWith("/") || Files.isDirectory(Words.path(picture)) ? Optional.of(ImageFormat.PNG) : Optional.empty())
                .orElseThrow(() -> new WrongUsage("cannot tell the format of '" + picture + "': let --picture end in one of " + ImageFormat.all()));
    }

    private int write(String name, String text) {
        try {
            if (output.isEmpty()) {
                terminal.table().append(text).flush();
                return ExitCode.DONE;
            }
            Folders.make(output.get());
            Path file = output.get().resolve(name);
            stop.guard(() -> AtomicFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8))));
            terminal.result(file.toString());
            return ExitCode.DONE;
        } catch (IOException e) {
            terminal.message(Failures.sentence(output.map(Path::toString).orElse("standard output"), e));
            return ExitCode.FAILED;
        }
    }
}
