package cz.paprsek.render.show;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.material.Rgb;
import org.junit.jupiter.api.Test;

class NumberedCellsTest {
    @Test
    void aCellShowsItsTenthsUprightAndIsRepeated() {
        String expected = """
                ..........
                ...#..###.
                ..##....#.
                ...#...#..
                ...#...#..
                ..###..#..
                ..........
                """;
        assertThat(drawn(0.1, 0.7)).isEqualTo(expected);
        assertThat(drawn(-1.9, 3.7)).isEqualTo(expected);
    }

    @Test
    void itIsRedderToTheRightAndGreenerUpwards() {
        assertThat(NumberedCells.color(0.801, 0.201).red()).isGreaterThan(NumberedCells.color(0.201, 0.201).red());
        assertThat(NumberedCells.color(0.201, 0.801).green()).isGreaterThan(NumberedCells.color(0.201, 0.201).green());
    }

    /** The cell at u, v, from the top left on. */
    private static String drawn(double u, double v) {
        StringBuilder lines = new StringBuilder();
        for (int row = 6; row >= 0; row--) {
            for (int column = 0; column < 10; column++) {
                Rgb color = NumberedCells.color(u + column / 100.0, v + (row == 0 ? 0.01 : row == 6 ? 0.09 : 0.02 + 0.012 * (row - 0.5)));
                lines.append(color.equals(Rgb.BLACK) || color.equals(Rgb.WHITE) ? '#' : '.');
            }
            lines.append('\n');
        }
        return lines.toString();
    }
}
