package cz.paprsek.cli.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import cz.paprsek.cli.Run;
import cz.paprsek.cli.process.ExitCode;
import cz.paprsek.cli.process.Stop;
import org.junit.jupiter.api.Test;

class BenchCommandTest {
    @Test
    void aTableHasARowForEachScene() {
        Run run = Run.cli("bench", "--scene", "few,csg1000", "--size", "32x18", "--rounds", 2);
        assertThat(run.code()).isZero();
        assertThat(run.out().lines().map(line -> line.substring(0, line.indexOf(" ")))).containsExactly("Java", "scene", "few", "csg1000");
        assertThat(run.out().lines().skip(2)).allMatch(row -> row.strip().matches("(\\S+ +){10}\\S+")).anyMatch(row -> row.contains(" 576 "));
    }

    @Test
    void scriptsGetAnObjectForEachScene() {
        Run run = Run.cli("bench", "--scene", "flake4", "--size", "32x18", "--rounds", 1, "--threads", 2, "--json");
        assertThat(run.code()).isZero();
        assertThat(run.out()).hasLineCount(1).startsWith("{\"scene\":\"flake4\",\"objects\":7382,\"bytes\":").contains("\"rays\":{\"primary\":576,")
                .contains("\"seconds\":{\"build\":").doesNotContain("povray");
    }

    @Test
    void growthIsShownByScenesThatGrow() {
        Run run = Run.cli("bench", "--scene", "cloud10,chain1000", "--size", "32x18", "--rounds", 1);
        assertThat(run.out().lines().skip(2).map(line -> line.replaceAll(" +", " ").split(" ", -1)[1])).containsExactly("10", "1");
        assertThat(BenchScenes.growingNames()).contains("cloud10", "cloud10M", "chain2", "chain1000").doesNotContain("few");
    }

    @Test
    void povRayIsMeasuredInTurn() {
        assumeThat(PovRay.installed()).isPresent();
        Run run = Run.cli("bench", "--scene", "few", "--size", "320x180", "--rounds", 1, "--against", "povray");
        assertThat(run.err()).isEmpty();
        assertThat(run.out().lines().skip(2)).hasSize(1).allMatch(row -> row.strip().matches("few( +[0-9.]+){14}"));
    }

    @Test
    void whatCannotBeMeasuredIsRefused() {
        assertThat(Run.cli("bench", "--scene", "fwe").err()).contains("there is no standard scene \"fwe\"; did you mean \"few\"?");
        assertThat(Run.cli("bench", "--rounds", 0).err()).contains("--rounds must be between 1 and 1000, but is 0");
        assertThat(Run.cli("bench", "--threads", 5000).code()).isEqualTo(ExitCode.WRONG_USAGE);
        assertThat(Run.cli("bench", "--against", "sunflow").code()).isEqualTo(ExitCode.WRONG_USAGE);
    }

    @Test
    void aStopEndsIt() {
        Stop stop = new Stop();
        stop.request();
        assertThat(Run.watched(false, stop, "bench", "--scene", "few").code()).isEqualTo(ExitCode.INTERRUPTED);
    }
}
