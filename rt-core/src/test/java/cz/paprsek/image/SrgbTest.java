package cz.paprsek.image;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.material.Rgb;
import java.util.Random;
import org.junit.jupiter.api.Test;

class SrgbTest {
    @Test
    void levelChangesExactlyWhereTheFormulaRoundsUp() {
        for (int level = 1; level < 256; level++) {
            double threshold = Rgb.linear(level - 0.5);
            float least = (float) threshold;
            if (least < threshold) {
                least = Math.nextUp(least);
            }
            assertThat(Srgb.encode(least)).as("at the threshold of %d", level).isEqualTo(level);
            assertThat(Srgb.encode(Math.nextDown(least))).as("just below the threshold of %d", level).isEqualTo(level - 1);
        }
    }

    @Test
    void anyLightGivesTheNearestLevel() {
        Random random = new Random(1);
        for (int i = 0; i < 200_000; i++) {
            float light = random.nextFloat();
            assertThat(Math.abs(Srgb.encode(light) - Rgb.encoded(light))).as("%s", light).isLessThan(0.5 + 1e-4);
        }
    }

    @Test
    void everyLevelSurvivesDecodingAndEncoding() {
        for (int level = 0; level < 256; level++) {
            assertThat(Srgb.encode((float) Rgb.linear(level))).isEqualTo(level);
        }
    }

    @Test
    void lightOutOfRangeIsClamped() {
        assertThat(Srgb.encode(-1)).isZero();
        assertThat(Srgb.encode(Float.NaN)).isZero();
        assertThat(Srgb.encode(Float.NEGATIVE_INFINITY)).isZero();
        assertThat(Srgb.encode(1)).isEqualTo(255);
        assertThat(Srgb.encode(40)).isEqualTo(255);
        assertThat(Srgb.encode(Float.POSITIVE_INFINITY)).isEqualTo(255);
    }
}
