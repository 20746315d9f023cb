package cz.paprsek.render.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import cz.paprsek.material.Pattern;
import cz.paprsek.material.Pattern.Colors;
import cz.paprsek.material.Pattern.Lay;
import cz.paprsek.render.texture.ValueField;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;

/** The slopes of patterns with values, against differences. */
class SlopeTest {
    static final List<Pattern> PATTERNS = List.of(
            new Pattern.Gradient(Colors.DEFAULT, Lay.NONE),
            new Pattern.Marble(1.3, 0.7, 3, 5, Colors.DEFAULT, Lay.NONE),
            new Pattern.Wood(2, 0.4, 2, 1, Colors.DEFAULT, Lay.NONE),
            new Pattern.Granite(4, 2, Colors.DEFAULT, Lay.NONE),
            new Pattern.Noise(5, 77, Colors.DEFAULT, Lay.NONE));

    /** Of far more than a thousand points a few lie at an edge, where there are two slopes. */
    @ParameterizedTest
    @FieldSource("PATTERNS")
    void aSlopeIsWhatTheValueGrowsBy(Pattern pattern) {
        ValueField field = ValueField.of(pattern);
        Random random = new Random(1);
        double step = 1e-6;
        int atEdges = 0;
        for (int i = 0; i < 2000; i++) {
            double x = 20 * random.nextDouble() - 10;
            double y = pattern instanceof Pattern.Gradient ? 2 * random.nextDouble() - 0.5 : 20 * random.nextDouble() - 10;
            double z = 20 * random.nextDouble() - 10;
            double[] slope = new double[3];
            field.slope(x, y, z, slope);
            double[] grown = {
                field.value(x + step, y, z) - field.value(x - step, y, z), field.value(x, y + step, z) - field.value(x, y - step, z),
                field.value(x, y, z + step) - field.value(x, y, z - step)};
            boolean isSame = true;
            for (int k = 0; k < 3; k++) {
                isSame &= Math.abs(slope[k] - grown[k] / (2 * step)) < 1e-6 * (1 + Math.abs(slope[k]));
            }
            atEdges += isSame ? 0 : 1;
        }
        assertThat(atEdges).isLessThan(4);
        assertThat(field.value(0.5, 0.25, 0.5)).isCloseTo(field.value(0.5, 0.25, 0.5 + 1e-9), within(1e-6));
    }
}
