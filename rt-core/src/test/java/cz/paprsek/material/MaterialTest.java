package cz.paprsek.material;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class MaterialTest {
    private static Stream<Material> differingInOne(double share) {
        Material plain = Material.DEFAULT;
        Rgb color = new Rgb(255 * share, 1, 2);
        Pattern pattern = new Pattern.Plain(color);
        return Stream.of(plain.withPattern(pattern), plain.withDiffusion(share / 2), plain.withHighlight(share, 30), plain.withHighlight(0, 31 + share), plain.withReflection(share),
                plain.withTransparency(share, 1), plain.withTransparency(0, 1 + share), plain.withRoughness(share), plain.withAttenuation(color, 1),
                plain.withAttenuation(Rgb.WHITE, share / 3), plain.withEmission(color, 1), plain.withEmission(Rgb.BLACK, share / 5));
    }

    /** Finishes are found by it: those of thousands of materials of which one emits a little more than the other took a minute. */
    @Test
    void hardlyAnyTwoThatDifferInOneThingHaveTheSameHash() {
        List<Material> all = IntStream.range(1, 500).boxed().flatMap(i -> differingInOne(i / 512.0)).toList();
        assertThat(all.stream().map(Material::hashCode).distinct().count()).isGreaterThan(all.size() * 9 / 10);
    }
}
