package cz.paprsek.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import cz.paprsek.image.Image;
import cz.paprsek.image.Layers;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class WholePassesTest {
    @Test
    void aPassThatCannotBeWrittenIsToldAtOnceAndRenderingGoesOn() {
        List<String> told = new ArrayList<>();
        WholePasses passes = new WholePasses(Optional.empty(), (image, layers, count) -> {
            throw new IOException("no space left on device");
        }, hindered -> told.add(hindered.getMessage()));
        assertThat(passes.passed(new Image(1, 1), () -> Layers.ofSize(1, 1), 1)).isTrue();
        assertThat(told).containsExactly("no space left on device");
        assertThat(passes.passesWritten()).isZero();
        assertThat(passes.passed(new Image(1, 1), () -> Layers.ofSize(1, 1), 2)).isTrue();
        assertThat(told).as("once").hasSize(1);
    }
}
