package cz.paprsek.cli;

import cz.paprsek.io.Json;
import java.util.Locale;

/** Shows what was measured: a table, row by row, or a JSON object a line. */
record BenchReport(Terminal terminal, boolean json, boolean compares) {

    void begin(String machine) {
        if (!json) {
            terminal.result(machine);
            terminal.result(String.format(Locale.ROOT, "%-10s %8s %9s %9s %9s %9s %7s %8s %8s %8s", "scene", "objects", "primary", "reflected",
                    "refracted", "shadow", "Mray/s", "build s", "trace s", "CPU s") + (compares ? "  POV-Ray  ratio" : ""));
        }
    }

    void add(Benchmark.Result result) {
        terminal.result(json ? asJson(result) : asText(result));
    }

    private String asText(Benchmark.Result r) {
        String ours = String.format(Locale.ROOT, "%-10s %8d %9d %9d %9d %9d %7.2f %8.3f %8.3f %8.3f", r.name(), r.objects(), r.rays().primary(),
                r.rays().reflected(), r.rays().refracted(), r.rays().shadow(), r.raysPerSecond() / 1e6, r.build(), r.trace(), r.cpu());
        return ours + (compares ? String.format(Locale.ROOT, " %8.3f %6.2f", r.opponentCpu(), r.ratio()) : "");
    }

    private String asJson(Benchmark.Result r) {
        Json object = new Json()
                .with("scene", r.name())
                .with("objects", r.objects())
                .with("rays", RayCounts.asJson(r.rays()))
                .with("rays-per-second", Math.rint(r.raysPerSecond()))
                .with("seconds", new Json().with("build", r.build()).with("trace", r.trace()).with("cpu", r.cpu()));
        return (compares ? object.with("povray-cpu-seconds", r.opponentCpu()).with("ratio", r.ratio()) : object).toString();
    }
}
