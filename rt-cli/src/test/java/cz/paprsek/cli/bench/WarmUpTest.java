package cz.paprsek.cli.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class WarmUpTest {
    private long compiled;
    private long now;

    /** How many renders of a second each it takes, beside each of which so many milliseconds are spent on compiling. */
    private int renders(int... compiling) {
        WarmUp warmUp = new WarmUp(() -> compiled, () -> now);
        int renders = 0;
        do {
            compiled += renders < compiling.length ? compiling[renders] : 0;
            now += 1_000_000_000;
            renders++;
        } while (warmUp.goesOn());
        return renders;
    }

    @Test
    void fourWhereNothingIsCompiled() {
        assertThat(renders()).isEqualTo(4);
        assertThat(renders(900)).isEqualTo(4);
    }

    @Test
    void threeInARowBesideWhichLittleIs() {
        assertThat(renders(900, 800, 700, 600)).isEqualTo(7);
        assertThat(renders(900, 0, 0, 300, 20, 10, 21, 5)).isEqualTo(10);
    }

    @Test
    void notForEver() {
        int[] always = new int[100];
        Arrays.fill(always, 500);
        assertThat(renders(always)).isEqualTo(20);
    }

    @Test
    void ofThisMachineItEnds() {
        WarmUp warmUp = new WarmUp();
        int renders = 1;
        while (warmUp.goesOn()) {
            renders++;
        }
        assertThat(renders).isBetween(4, 20);
    }
}
