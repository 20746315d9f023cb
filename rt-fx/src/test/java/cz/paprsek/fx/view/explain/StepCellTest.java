package cz.paprsek.fx.view.explain;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.fx.Gui;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Where lines of the exercise may be broken: at the blanks that are left, never within a number. */
class StepCellTest {
    private static final String LINE = "cos θ = -(0.101, -0.277)·(-0.0541, 0.328) + 1";

    private static List<String> lines(String line, int room) {
        // A class of JavaFX's cannot begin before JavaFX has.
        return Gui.on(() -> List.of(StepCell.broken(line, run -> run.length() <= room).split(" ")));
    }

    @Test
    void vectorsStayWholeAsLongAsTheyHaveRoom() {
        assertThat(lines(LINE, 99)).containsExactly("cos", "θ", "=\u00a0-(0.101,\u00a0-0.277)·(-0.0541,\u00a00.328)", "+\u00a01");
        assertThat(lines(LINE, 22)).containsExactly("cos", "θ", "=\u00a0-(0.101,\u00a0-0.277)·", "(-0.0541,\u00a00.328)", "+\u00a01");
        assertThat(lines(LINE, 12)).containsExactly("cos", "θ", "=\u00a0-(0.101,", "-0.277)·", "(-0.0541,", "0.328)", "+\u00a01");
    }

    /** Where numbers have a comma, a semicolon stands between them. */
    @Test
    void vectorsStayWholeInCzech() {
        String line = "cos θ = −(0,101; −0,277)·(−0,0541; 0,328) = 0,3";
        assertThat(lines(line, 99)).containsExactly("cos", "θ", "=\u00a0−(0,101;\u00a0−0,277)·(−0,0541;\u00a00,328)", "=\u00a00,3");
        assertThat(lines(line, 22)).containsExactly("cos", "θ", "=\u00a0−(0,101;\u00a0−0,277)·", "(−0,0541;\u00a00,328)", "=\u00a00,3");
    }

    /** A letter alone in a line says nothing: its vector is broken instead. */
    @Test
    void aLetterStaysWithTheBeginningOfItsVector() {
        String line = "d = (-0.383, -0.157, -0.91)";
        assertThat(lines(line, 99)).containsExactly("d\u00a0=\u00a0(-0.383,\u00a0-0.157,\u00a0-0.91)");
        assertThat(lines(line, 24)).containsExactly("d\u00a0=\u00a0(-0.383,", "-0.157,", "-0.91)");
    }
}
