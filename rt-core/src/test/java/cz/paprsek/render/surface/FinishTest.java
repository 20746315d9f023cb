package cz.paprsek.render.surface;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.asset.Assets;
import cz.paprsek.material.Material;
import cz.paprsek.math.Affine;
import cz.paprsek.render.texture.Textures;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FinishTest {
    @ParameterizedTest
    @CsvSource({"0, 0.5", "1, 0.5", "2, 1", "7, 0", "49.5, 0.5", "50, 0.5", "1000000, 1"})
    void highlightsOfManyAreThoseOfEach(double exponent, double strength) {
        Finish finish = new Finish(Material.DEFAULT.withHighlight(strength, exponent), Affine.IDENTITY, new Textures(Assets.none()));
        double[] cosines = {1, 1.4, 0.7, Double.MIN_VALUE, 0, -0.0, -1, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 0.3, 0.999};
        double[] results = new double[cosines.length];
        finish.highlights(cosines.clone(), results, cosines.length);
        for (int i = 0; i < cosines.length; i++) {
            assertThat(results[i]).as("of %s", cosines[i]).isEqualTo(finish.highlight(cosines[i]));
        }
    }
}
