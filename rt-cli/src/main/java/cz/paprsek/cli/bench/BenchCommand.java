package cz.paprsek.cli.bench;

import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Interruption;
import cz.paprsek.cli.process.Memory;
import cz.paprsek.cli.process.Stop;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.cli.process.WrongUsage;
import cz.paprsek.cli.value.Size;
import cz.paprsek.io.Failures;
import cz.paprsek.render.Renderer;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Measures how fast pictures are made. */
@Command(
        name = "bench",
        description = {
            "Measures how fast the standard scenes are rendered, which are made from fixed seeds, 1280x720 pixels, five levels deep.",
            "Times are medians: of preparing a scene, of tracing its picture once the virtual machine is warm, and of the processor time "
                    + "of all threads that trace."
        },
        footer = {
            "",
            "Examples:",
            "  paprsek bench",
            "  paprsek bench --against povray                  in turn with POV-Ray",
            "  paprsek bench --against mitsuba                 paths, and rays by its Embree",
            "  paprsek bench --against-jar old.jar --rounds 9  whether it got slower",
            "  paprsek bench --scale --rounds 3                how time and memory grow",
            "  paprsek bench --scene few --scene cloud1M --threads 2 --json"
        })
public final class BenchCommand implements Callable<Integer> {
    private static final int MOST_ROUNDS = 1000;

    /** Whom to compare with. */
    public enum Opponent {
        /** Follows no paths. */
        povray,
        mitsuba;

        /** What is measured if no scenes are named. */
        Collection<String> names() {
            return this == mitsuba ? BenchScenes.mitsubasNames() : BenchScenes.standardNames();
        }

        /** @param option that chose the scene */
        private void check(String name, String option) {
            if (this == mitsuba ? !BenchScenes.mitsubasNames().contains(name) : BenchScenes.pathNames().contains(name)) {
                throw new WrongUsage("--against " + this + " does not go with " + option + ": "
                        + (this == mitsuba ? "it is for " + String.join(", ", names()) : "POV-Ray follows no paths; --against mitsuba does"));
            }
        }
    }

    private final Terminal terminal;
    private final Stop stop;

    @Option(names = "--scene", paramLabel = "NAME", completionCandidates = BenchScenes.class, split = ",",
            description = "One of ${COMPLETION-CANDIDATES}; may be given several times. Default: the standard ones.")
    private List<String> names = new ArrayList<>();

    @Option(names = "--scale", description = "Shows how cost grows instead: clouds of 10 to 10M spheres (10M need java -Xmx6g), unions of 2 to 1000.")
    private boolean scale;

    @Option(names = "--against", paramLabel = "PROGRAM", description =
            "Renders each scene in turn with ${COMPLETION-CANDIDATES} on as many threads, and tells how many times its processor time is ours. Mitsuba 3, as Python has it, follows paths, and finds what rays hit with Embree.")
    private Optional<Opponent> against;

    @Option(names = "--against-jar", paramLabel = "OLD.jar", description =
            "Renders each scene in turn with another version of this program, in this virtual machine, and tells how many times its processor time is ours.")
    private Optional<Path> jar;

    @Option(names = "--threads", paramLabel = "N", defaultValue = "1", description = "Threads to render with, 1-1024. Default: 1.")
    private int threads;

    @Option(names = "--rounds", paramLabel = "N", defaultValue = "7", description = "How often each scene is measured, 1-1000. Default: 7.")
    private int rounds;

    @Option(names = "--size", paramLabel = "WxH", description = "Width and height in pixels. Default: 1280x720, of paths 256x256.")
    private Optional<Size> size;

    @Option(names = "--json", description = "Prints a JSON object for every scene, one a line, instead of a table.")
    private boolean json;

    public BenchCommand(Terminal terminal, Stop stop) {
        this.terminal = terminal;
        this.stop = stop;
    }

    @Override
    public Integer call() {
        if (json) {
            stop.oweLastWords();
        }
        requireWithin("--threads", threads, 1024);
        requireWithin("--rounds", rounds, MOST_ROUNDS);
        names.forEach(BenchScenes::check);
        if (against.isPresent() && jar.isPresent()) {
            throw new WrongUsage("--against and --against-jar: compare with one at a time");
        }
        against.ifPresent(opponent -> measured().forEach(name -> opponent.check(name, names.isEmpty() ? "--scale" : "--scene " + name)));
        try {
            measure();
            return ExitCode.DONE;
        } catch (InterruptedIOException stopped) {
            return Interruption.told(terminal, json);
        } catch (IOException e) {
            terminal.message("paprsek: " + Failures.sentence(e));
            return ExitCode.FAILED;
        } catch (OutOfMemoryError e) {
            terminal.message("paprsek: " + Memory.sentence("the scene", 0));
            return ExitCode.FAILED;
        }
    }

    private void measure() throws IOException {
        if (against.isEmpty() && jar.isEmpty()) {
            measure(Optional.empty());
            return;
        }
        try (Rival rival = rival()) {
            measure(Optional.of(rival));
        }
    }

    private Rival rival() throws IOException {
        if (jar.isPresent()) {
            return new OtherVersion(jar.get(), stop);
        }
        return against.get() == Opponent.mitsuba ? new Mitsuba(threads, stop) : new PovRayRival(PovRay.installed()
                .orElseThrow(() -> new WrongUsage("--against povray needs POV-Ray, but no program \"povray\" is on the search path")), stop);
    }

    private void measure(Optional<Rival> rival) throws IOException {
        BenchReport report = new BenchReport(terminal, json, rival.map(Rival::label));
        report.begin("Java " + Runtime.version() + ", " + Renderer.kernel() + ", " + threads + (threads == 1 ? " thread" : " threads")
                + rival.map(one -> ", against " + one.version()).orElse(""));
        Benchmark benchmark = new Benchmark(stop, size, threads, rounds, rival);
        for (String name : measured()) {
            report.add(benchmark.run(name));
        }
    }

    private Collection<String> measured() {
        return !names.isEmpty() ? names : scale ? BenchScenes.growingNames() : against.map(Opponent::names).orElse(BenchScenes.standardNames());
    }

    private static void requireWithin(String option, int value, int most) {
        if (value < 1 || value > most) {
            throw new WrongUsage(option + " must be between 1 and " + most + ", but is " + value);
        }
    }
}
