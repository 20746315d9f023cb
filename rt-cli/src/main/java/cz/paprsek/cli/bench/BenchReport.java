package cz.paprsek.cli.bench;

import cz.paprsek.cli.output.RayCounts;
import cz.paprsek.cli.process.Terminal;
import cz.paprsek.io.Json;
import java.util.Locale;
import java.util.Optional;

/** Shows what was measured: a table, row by row, or a JSON object a line. */
record BenchReport(Terminal terminal, boolean json, Optional<String> rival) {

    void begin(String machine) {
        if (!json) {
            terminal.result(machine);
            terminal.result(String.format(Locale.ROOT, "%-9s %8s %8s %7s %9s %9s %8s %7s %7s %7s %7s", "scene", "objects", "B/object", "primary",
                    "reflected", "refracted", "shadow", "ns/ray", "build s", "trace s", "CPU s") + rival.map(label -> String.format(Locale.ROOT, " %8s  ratio least  most", label)).orElse(""));
        }
    }

    void add(Benchmark.Result result) {
        terminal.result(json ? asJson(result) : asText(result));
    }

    private String asText(Benchmark.Result r) {
        String ours = String.format(Locale.ROOT, "%-9s %8d %8.0f %7d %9d %9d %8d %7.1f %7.3f %7.3f %7.3f", r.name(), r.objects(), r.bytesPerObject(),
                r.rays().primary(), r.rays().reflected(), r.rays().refracted(), r.rays().shadow(), r.nanosPerRay(), r.build(), r.trace(), r.cpu());
        return ours + (rival.isPresent() ? String.format(Locale.ROOT, " %8.3f %6.2f %5.2f %5.2f", r.opponentCpu(), r.ratio(), r.least(), r.most()) : "");
    }

    private String asJson(Benchmark.Result r) {
        Json object = new Json()
                .with("scene", r.name())
                .with("objects", r.objects())
                .with("bytes", r.bytes())
                .with("rays", RayCounts.asJson(r.rays()))
                .with("rays-per-second", Math.rint(r.raysPerSecond()))
                .with("seconds", new Json().with("build", r.build()).with("trace", r.trace()).with("cpu", r.cpu()));
        return rival.map(label -> object.with(label.toLowerCase(Locale.ROOT).replace("-", "") + "-cpu-seconds", r.opponentCpu())
                .with("ratio", r.ratio()).with("least", r.least()).with("most", r.most())).orElse(object).toString();
    }
}
