package cz.paprsek.fx.model.edit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class NamesTest {
    @Test
    void theFirstNumberThatIsFreeIsTaken() {
        Names names = new Names(new HashSet<>(Set.of("ball", "ball 3", "box 7")));
        assertThat(List.of(names.take("ball"), names.take("ball"), names.take("ball 2"), names.take("box 7"), names.take("box"), names.take(""), names.take("")))
                .containsExactly("ball 2", "ball 4", "ball 5", "box 2", "box", "", "");
    }

    @Test
    void noNumberIsTriedAgainForEachOfMany() {
        AtomicInteger asked = new AtomicInteger();
        Set<String> taken = new HashSet<>() {
            @Override
            public boolean contains(Object name) {
                asked.incrementAndGet();
                return super.contains(name);
            }
        };
        Names names = new Names(taken);
        List<String> originals = IntStream.range(0, 1000).mapToObj(i -> names.take("ball")).toList();
        List<String> copies = originals.stream().map(names::take).toList();
        assertThat(copies).startsWith("ball 1001").endsWith("ball 2000");
        assertThat(asked.get()).isLessThanOrEqualTo(3 * 2000);
    }
}
